#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/guard/tokens.h"

namespace remeshd {

/// Knows callers by the tokens of a file. For any thread.
class Doorman {
 public:
  /// Throws what Tokens::read throws.
  explicit Doorman(std::filesystem::path token_file);

  /// Makes a tenant ready to be served.
  using Prepare = std::function<void(const std::string& tenant)>;
  /// Has every tenant of the file prepared now, and each of a file that is read anew before its
  /// tokens count. Where it throws, so does this, and nothing is kept of it. In place of the one
  /// before, which is called no more once this has returned; an empty one: nothing is prepared.
  void prepare_with(Prepare prepare);

  /// Reads the file anew. Where that, or preparing a tenant, throws, the tokens stay those that
  /// they were. Takes as long as preparing.
  void reload();
  /// The tenant of a call with this `authorization` (none: no such metadata).
  /// Throws Error(Unauthenticated): CREDENTIALS_MISSING, CREDENTIALS_INVALID.
  [[nodiscard]] std::string tenant_of(const std::optional<std::string_view>& authorization) const;
  /// Whether a call that was let in for a tenant would be let in for it today too.
  /// Throws Error(Unauthenticated): CREDENTIALS_INVALID.
  void check_again(const std::optional<std::string_view>& authorization,
                   const std::string& tenant) const;

 private:
  const std::filesystem::path file_;
  std::mutex reloading_;  ///< guards what follows, before the other mutex
  Prepare prepare_;
  mutable std::mutex mutex_;  ///< guards what follows; nobody waits with it
  Tokens tokens_;
};

}  // namespace remeshd

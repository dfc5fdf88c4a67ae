#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/guard/tokens.h"

namespace remeshd {

/// Tells the tenants of callers by the tokens of a file. May be used from any thread.
class Doorman {
 public:
  /// Throws what Tokens::read throws.
  explicit Doorman(std::filesystem::path token_file);

  /// Makes a tenant ready to be served.
  using Prepare = std::function<void(const std::string& tenant)>;
  /// Calls `prepare` now for every tenant of the file, and in each `reload` for every tenant of the
  /// new file before its tokens take effect. Replaces the former function, which is not called any
  /// more once this has returned; an empty one prepares nothing. Throws what `prepare` throws; the
  /// former function then stays.
  void prepare_with(Prepare prepare);

  /// Reads the file anew. Throws what Tokens::read or preparing a tenant throws; the old tokens
  /// then stay in force. Takes as long as preparing the tenants does.
  void reload();
  /// The tenant of a call with this `authorization` (none: no such metadata).
  /// Throws Error(Unauthenticated): CREDENTIALS_MISSING, CREDENTIALS_INVALID.
  [[nodiscard]] std::string tenant_of(const std::optional<std::string_view>& authorization) const;
  /// Checks that a call that was let in for a tenant would still be let in for it, since the file
  /// may have been read anew.
  /// Throws Error(Unauthenticated): CREDENTIALS_INVALID.
  void check_again(const std::optional<std::string_view>& authorization,
                   const std::string& tenant) const;

 private:
  const std::filesystem::path file_;
  std::mutex reloading_;  ///< guards `prepare_`; locked before `mutex_`
  Prepare prepare_;
  mutable std::mutex mutex_;  ///< guards `tokens_`; nobody waits while holding it
  Tokens tokens_;
};

}  // namespace remeshd

#pragma once

#include <filesystem>
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

  /// Reads the file anew. Where that throws, the tokens stay those that they were.
  void reload();
  /// The tenant of a call with this `authorization` (none: no such metadata).
  /// Throws Error(Unauthenticated): CREDENTIALS_MISSING, CREDENTIALS_INVALID.
  [[nodiscard]] std::string tenant_of(const std::optional<std::string_view>& authorization) const;

 private:
  const std::filesystem::path file_;
  mutable std::mutex mutex_;
  Tokens tokens_;
};

}  // namespace remeshd

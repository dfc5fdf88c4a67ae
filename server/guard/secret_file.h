#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace remeshd {

/// A file of tokens, keys or certificates that cannot be used; `what` names it and says why, and
/// tells nothing of its content.
class SecretFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a file that only this user, its group or root may read, and only this user or root may
/// change. Throws SecretFileError.
std::string read_secret_file(const std::filesystem::path& file);

}  // namespace remeshd

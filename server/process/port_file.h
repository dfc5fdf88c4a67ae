#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace remeshd {

/// The file that tells where the daemon serves: an address a line, as a client takes it. It is
/// there while the daemon serves, and always whole.
class PortFile {
 public:
  /// Removes what an earlier daemon left. An empty path: no file.
  explicit PortFile(std::filesystem::path file);
  /// Removes the file.
  ~PortFile();
  PortFile(const PortFile&) = delete;
  PortFile& operator=(const PortFile&) = delete;

  /// Throws std::system_error where it cannot be written.
  void write(const std::vector<std::string>& addresses) const;

 private:
  const std::filesystem::path file_;
};

}  // namespace remeshd

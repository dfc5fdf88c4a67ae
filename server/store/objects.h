#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

/// Files named by the SHA-256 of what is in them: `ab/cdef...` below a folder. A name that is there
/// is whole.
class Objects {
 public:
  /// Makes the folder, and clears what a crash left half-written.
  explicit Objects(std::filesystem::path folder);

  /// Stores the bytes and returns their hash. What is there already and whole is left as it is.
  /// Throws Error(StoreFailed, StoreFull).
  std::string put(std::string_view bytes);
  /// Throws Error(StoreCorrupted) where the bytes do not have that hash or are gone.
  [[nodiscard]] std::string get(const std::string& hash) const;
  /// No error where there is none.
  void remove(const std::string& hash);
  /// All hashes, sorted.
  [[nodiscard]] std::vector<std::string> list() const;
  [[nodiscard]] std::filesystem::path path_of(const std::string& hash) const;

 private:
  std::filesystem::path folder_;
  std::filesystem::path scratch_;
};

}  // namespace remeshd

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

/// The folder where a store puts what it found and does not know, instead of deleting it. Nothing
/// in it is ever read again, or deleted, by the store.
class Quarantine {
 public:
  Quarantine(std::filesystem::path folder, std::filesystem::path scratch)
      : folder_(std::move(folder)), scratch_(std::move(scratch)) {}

  /// Moves a file or folder of the same file system there, and notes `why`. Where that fails it
  /// stays in its place, which is noted too.
  void take(const std::filesystem::path& path, std::string_view why);
  /// Keeps a copy of bytes there; the same bytes once.
  void keep(std::string_view name, std::string_view bytes, std::string_view why);

  /// What happened, a line each.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::filesystem::path folder_, scratch_;
  std::vector<std::string> notes_;
};

}  // namespace remeshd

#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "server/store/store.h"

namespace remeshd::test {

/// A fresh folder for a store, gone with this.
class StoreFolder {
 public:
  StoreFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("remeshd-session-test-" + std::to_string(::getpid()) + "-" +
               std::to_string(++count))) {}
  ~StoreFolder() { std::filesystem::remove_all(path_); }
  StoreFolder(const StoreFolder&) = delete;
  StoreFolder& operator=(const StoreFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::unique_ptr<Store> open() const { return std::make_unique<Store>(path_); }

  /// Changes the last byte of every pack.
  void damage_objects() const {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_ / "packs")) {
      if (!entry.is_regular_file()) continue;
      std::fstream file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
      file.seekg(-1, std::ios::end);
      const char last = static_cast<char>(file.get());
      file.seekp(-1, std::ios::end);
      file.put(static_cast<char>(last ^ 1));
    }
  }

 private:
  static inline std::atomic<int> count = 0;
  std::filesystem::path path_;
};

}  // namespace remeshd::test

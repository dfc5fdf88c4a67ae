#pragma once

#include <filesystem>

#include "server/tier/object_store.h"

namespace remeshd {

/// Objects as files below a folder that all daemons reach, on a network file system. A file is
/// there whole or not at all.
class FolderObjects final : public ObjectStore {
 public:
  /// Makes the folder if need be. Throws Error(TIER_UNAVAILABLE).
  explicit FolderObjects(std::filesystem::path folder);

  [[nodiscard]] bool has(const std::string& key, double within) override;
  [[nodiscard]] std::optional<std::string> get(const std::string& key) override;
  void put(const std::string& key, const std::string& bytes) override;
  [[nodiscard]] std::optional<std::string> start_of(const std::string& key,
                                                    std::size_t bytes) override;
  void list(const std::string& prefix,
            const std::function<void(const ObjectInfo&)>& visit) override;
  void remove(const std::string& key) override;

 private:
  const std::filesystem::path folder_;
};

}  // namespace remeshd

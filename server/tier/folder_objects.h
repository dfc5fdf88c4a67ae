#pragma once

#include <filesystem>

#include "server/tier/object_store.h"

namespace remeshd {

/// Objects as files below a folder that all daemons reach, on a network file system. A file is
/// there whole or not at all.
///
/// The file `TIER` in it marks the folder. Where it is missing later, the folder is not the tier,
/// but maybe the mount point of a file system that is not mounted: that is an outage, not an empty
/// tier.
class FolderObjects final : public ObjectStore {
 public:
  /// Makes the folder if need be, and marks it. Throws Error(TIER_UNAVAILABLE).
  explicit FolderObjects(std::filesystem::path folder);

  /// Whether the folder had no mark and no objects when it was opened: a new tier, or a file system
  /// that was not mounted.
  [[nodiscard]] bool begun() const { return begun_; }
  [[nodiscard]] bool has(const std::string& key, double within) override;
  [[nodiscard]] std::optional<std::string> get(const std::string& key,
                                               const std::stop_token& stop) override;
  void put(const std::string& key, const std::string& bytes) override;
  [[nodiscard]] std::optional<std::string> start_of(const std::string& key,
                                                    std::size_t bytes) override;
  void list(const std::string& prefix,
            const std::function<void(const ObjectInfo&)>& visit) override;
  void remove(const std::string& key) override;

 private:
  /// Returns what `work` does; its failures, and a missing mark, become TIER_UNAVAILABLE.
  template <typename Work>
  auto with_tier(Work&& work);

  const std::filesystem::path folder_;
  bool begun_ = false;
};

}  // namespace remeshd

#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "server/designs/design_error.h"
#include "server/designs/design_table.h"

namespace remeshd::test {

/// Designs in memory, of a table that can fail and be changed by others at any moment.
class DesignShelf final : public DesignTable {
 public:
  DesignState since(const std::string& tenant, const std::string& name,
                    std::uint64_t version) override {
    check();
    const std::scoped_lock lock(mutex_);
    const auto found = designs_.find({tenant, name});
    if (found == designs_.end()) return {};
    DesignState state = found->second.state;
    const std::uint64_t from = state.version < version ? 0 : version;
    for (const auto& [number, row] : found->second.rows)
      if (row.second > from) state.rows.push_back(row.first);
    return state;
  }
  std::vector<std::pair<std::string, std::uint64_t>> versions(const std::string& tenant) override {
    check();
    const std::scoped_lock lock(mutex_);
    std::vector<std::pair<std::string, std::uint64_t>> all;
    for (const auto& [key, design] : designs_)
      if (key.first == tenant) all.emplace_back(key.second, design.state.version);
    return all;
  }
  std::vector<std::string> designs_of(const std::string& tenant, const std::string& id) override {
    check();
    const std::scoped_lock lock(mutex_);
    std::vector<std::string> names;
    for (const auto& [key, design] : designs_)
      if (key.first == tenant && std::ranges::any_of(design.rows, [&](const auto& row) {
            return row.second.first.id == id;
          }))
        names.push_back(key.second);
    return names;
  }
  bool change(const std::string& tenant, const std::vector<DesignChange>& changes) override {
    if (const auto hook = std::exchange(before_change, {})) hook();
    check();
    const std::scoped_lock lock(mutex_);
    for (const DesignChange& change : changes) {
      const auto found = designs_.find({tenant, change.name});
      const std::uint64_t version = found == designs_.end() ? 0 : found->second.state.version;
      if (version != change.expected) return false;
    }
    for (const DesignChange& change : changes) {
      Design& design = designs_[{tenant, change.name}];
      design.state = change.to;
      design.state.version = change.expected + 1;
      design.state.rows.clear();
      for (const DesignRow& row : change.to.rows)
        design.rows[row.number] = {row, design.state.version};
    }
    ++changed;
    return true;
  }
  void lose() {
    const std::scoped_lock lock(mutex_);
    designs_.clear();
  }

  std::atomic<bool> fails = false;
  std::atomic<int> changed = 0;
  std::function<void()> before_change;  ///< called once

 private:
  struct Design {
    DesignState state;
    std::map<std::uint32_t, std::pair<DesignRow, std::uint64_t>> rows;  ///< with their versions
  };
  void check() const {
    if (fails) throw error::catalogue_unavailable("it is out");
  }

  std::mutex mutex_;
  std::map<std::pair<std::string, std::string>, Design> designs_;  ///< by tenant and name
};

}  // namespace remeshd::test

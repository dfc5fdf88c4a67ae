#include <cstddef>
#include <map>
#include <set>
#include <string_view>

#include "engine/base/error.h"
#include "server/store/store.h"

// Packs of what the catalogue does not have: they are deleted once no other pack needs them.
namespace remeshd {
namespace fs = std::filesystem;

void Store::discard(const std::string& id) {
  const std::scoped_lock lock(committing_);
  const auto unfiled = unfiled_.find(id);
  if (unfiled == unfiled_.end()) return;
  const std::scoped_lock reading(reading_);
  if (!catalogue_->is_stored(id)) leftovers_[id] = {unfiled->second, packs_->bytes_of(id)};
  unfiled_.erase(unfiled);
  count_leftovers();
  // Deleted by the next commit: the disk may be in trouble now.
}

namespace {

/// Whether `remove` succeeded; if not, the next commit tries again.
template <typename Remove>
bool removed(Remove&& remove) {
  try {
    remove();
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

void Store::tidy() {
  std::erase_if(leftovers_, [&](const auto& leftover) {
    return read([&](Catalogue& catalogue) { return catalogue.is_stored(leftover.first); });
  });
  delete_packs([](const std::string&) { return true; });
  std::erase_if(old_scratch_,
                [](const fs::path& file) { return removed([&] { remove_file(file); }); });
}

void Store::delete_packs(const std::function<bool(const std::string& id)>& which) {
  std::map<std::string, std::size_t> standing;  // on each: packs that no revision names
  for (const auto& [id, base] : unfiled_) ++standing[base];
  for (const auto& [id, leftover] : leftovers_) ++standing[leftover.base];
  const auto is_needed = [&](const std::string& id) {
    const auto on = standing.find(id);
    return (on != standing.end() && on->second > 0) || unfiled_.contains(id) ||
           read([&](Catalogue& catalogue) {
             return catalogue.is_stored(id) || catalogue.is_base(id);
           });
  };
  // Deleting a pack may set its base free, which the next round deletes.
  for (bool again = true; again;) {
    again = std::erase_if(leftovers_, [&](const auto& leftover) {
              const std::string& id = leftover.first;
              if (!which(id) || is_needed(id)) return false;
              ++deletions_;
              if (!removed([&] { packs_->remove(id); })) return false;
              --standing[leftover.second.base];
              return true;
            }) > 0;
  }
  count_leftovers();
}

void Store::count_leftovers() {
  std::uint64_t bytes = 0;
  for (const auto& [id, leftover] : leftovers_) bytes += leftover.bytes;
  leftover_bytes_ = bytes;
}

std::uint64_t Store::bytes() {
  return leftover_bytes_ + read([](Catalogue& catalogue) { return catalogue.count_bytes(); });
}

std::string Store::base_of(const std::string& id) {
  const std::scoped_lock lock(committing_);
  if (const auto record = read([&](Catalogue& catalogue) { return catalogue.revision(id); });
      record && record->bytes > 0)
    return record->base;
  const auto leftover = leftovers_.find(id);
  return leftover != leftovers_.end() ? leftover->second.base : "";
}

std::vector<std::pair<std::string, std::string>> Store::on_removed_bases() {
  const std::scoped_lock lock(committing_);
  std::set<std::string_view> needed;  // by what no revision names
  for (const auto& [id, base] : unfiled_) needed.insert(base);
  for (const auto& [id, leftover] : leftovers_) needed.insert(leftover.base);
  std::vector<std::pair<std::string, std::string>> alone;
  for (const auto& [base, leftover] : leftovers_) {
    if (needed.contains(base)) continue;
    const auto standing = read([&](Catalogue& catalogue) { return catalogue.standing_on(base); });
    if (standing.size() == 1) alone.emplace_back(standing.front(), base);
  }
  return alone;
}

}  // namespace remeshd

#include "server/session/tier_garbage.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

namespace remeshd {
namespace {

using ById = std::unordered_map<std::string, const SharedObject*>;

ById by_id(const std::vector<SharedObject>& objects) {
  ById found;
  for (const SharedObject& object : objects) found[object.id] = &object;
  return found;
}

/// The object and what it needs, as far as that is there and not kept yet.
std::vector<const SharedObject*> with_needs(const SharedObject* object, const ById& objects,
                                            const std::set<std::string>& kept) {
  std::vector<const SharedObject*> chain;
  std::set<std::string> seen;  // what strangers wrote may have cycles
  while (object != nullptr && !kept.contains(object->id) && seen.insert(object->id).second) {
    chain.push_back(object);
    const auto next = objects.find(object->needs);
    object = next == objects.end() ? nullptr : next->second;
  }
  return chain;
}

}  // namespace

std::set<std::string> kept_objects(const std::vector<SharedObject>& objects, std::uint64_t bytes,
                                   std::optional<std::int64_t> after) {
  const ById all = by_id(objects);
  std::vector<const SharedObject*> order;
  for (const SharedObject& object : objects) order.push_back(&object);
  std::ranges::stable_sort(order, [](const SharedObject* a, const SharedObject* b) {
    return std::pair(a->pinned, a->written_ns) > std::pair(b->pinned, b->written_ns);
  });
  std::set<std::string> kept;
  std::uint64_t taken = 0;
  for (const SharedObject* object : order) {
    if (!object->pinned && after && object->written_ns < *after) break;
    const auto chain = with_needs(object, all, kept);
    std::uint64_t more = 0;
    for (const SharedObject* each : chain) more += each->bytes;
    if (!object->pinned && taken + more > bytes) break;
    taken += more;
    for (const SharedObject* each : chain) kept.insert(each->id);
  }
  return kept;
}

std::vector<SharedObject> dropped_objects(const std::vector<SharedObject>& objects,
                                          const std::set<std::string>& kept) {
  const ById all = by_id(objects);
  std::vector<SharedObject> dropped;
  std::set<std::string> listed = kept;
  for (const SharedObject& object : objects) {
    // The chain ends before an object that is listed: once reversed, it comes before that one.
    const auto chain = with_needs(&object, all, listed);
    for (auto each = chain.rbegin(); each != chain.rend(); ++each) {
      dropped.push_back(**each);
      listed.insert((*each)->id);
    }
  }
  std::ranges::reverse(dropped);
  return dropped;
}

}  // namespace remeshd

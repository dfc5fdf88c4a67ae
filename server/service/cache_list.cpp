#include "server/service/cache_list.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "server/limits.h"
#include "server/service/encode_cache.h"
#include "server/service/page_token.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

/// The sort key of an entry in this order.
std::int64_t key_of(const CacheEntry& entry, v1::CacheOrder order) {
  switch (order) {
    case v1::CACHE_ORDER_UNSPECIFIED:
      return entry.used_ns;
    case v1::CACHE_ORDER_BYTES:
      return static_cast<std::int64_t>(entry.record.bytes);
    case v1::CACHE_ORDER_CREATED:
      return entry.record.created_ns;
    default:
      throw error::option_invalid("order", "is no known enumerator");
  }
}

bool passes(const CacheEntry& entry, const v1::CacheFilter& filter, const std::set<int>& states,
            const std::set<std::string>& of_design) {
  if (!states.empty() && !states.contains(encode(entry).state())) return false;
  if (!filter.design().empty() && !of_design.contains(entry.record.id)) return false;
  if (filter.pinned() && !entry.record.pinned) return false;
  return !filter.unfiled() || entry.places == 0;
}

}  // namespace

v1::ListCacheEntriesResponse list_cache_entries(Session& session,
                                                const v1::ListCacheEntriesRequest& request) {
  const v1::CacheFilter& filter = request.filter();
  const ListIdentity list("cache", filter, request.order(), request.descending());
  const std::set<int> states(filter.states().begin(), filter.states().end());
  std::set<std::string> of_design;
  if (!filter.design().empty())
    for (const ListedRevision& row :
         session.list({.design = filter.design()}, {.limit = std::numeric_limits<int>::max()}))
      of_design.insert(row.record.id);

  using Key = std::pair<std::int64_t, std::string>;
  std::vector<std::pair<Key, CacheEntry>> rows;
  for (CacheEntry& entry : session.cache().cache_entries())
    if (passes(entry, filter, states, of_design)) {
      const Key key{key_of(entry, request.order()), entry.record.id};
      rows.emplace_back(key, std::move(entry));
    }
  const auto before = [&](const Key& a, const Key& b) {
    return request.descending() ? b < a : a < b;
  };
  std::ranges::sort(rows, before, &std::pair<Key, CacheEntry>::first);
  auto row = rows.begin();
  if (!request.page_token().empty()) {
    const ListIdentity::Row last = list.read(request.page_token());
    const Key after{last.value, last.id};
    row = std::ranges::find_if(rows, [&](const auto& r) { return before(after, r.first); });
  }
  const std::uint32_t limit = request.page_size() == 0
                                  ? limits::kListRows
                                  : std::min(request.page_size(), limits::kListRows);
  v1::ListCacheEntriesResponse out;
  for (std::uint32_t n = 0; n < limit && row != rows.end(); ++n, ++row)
    *out.add_entries() = encode(row->second);
  if (row != rows.end() && out.entries_size() > 0) {
    const Key& last = std::prev(row)->first;
    out.set_next_page_token(list.token(last.first, last.second, 0, ""));
  }
  return out;
}

}  // namespace remeshd

#include "server/service/lists.h"

#include <algorithm>
#include <limits>

#include "server/limits.h"
#include "server/service/encode.h"
#include "server/service/page_token.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

int rows_of(std::uint32_t wanted) {
  return static_cast<int>(wanted == 0 ? limits::kListRows : std::min(wanted, limits::kListRows));
}

/// Nanoseconds since 1970; times out of their range are clamped to it.
std::int64_t ns_of(const google::protobuf::Timestamp& time) {
  constexpr std::int64_t kNano = 1000000000;
  // A message may have any 32 bits for nanoseconds: up to three seconds more or less.
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / kNano - 3;
  return std::clamp(time.seconds(), -kMost, kMost) * kNano + time.nanos();
}

RevisionFilter filter_of(const v1::RevisionFilter& message) {
  RevisionFilter out;
  out.design = message.design();
  out.model_name = message.model_name();
  out.parent = message.parent();
  out.root = message.root();
  out.heads = message.heads();
  out.unfiled = message.unfiled();
  if (message.has_created_from()) out.created_from_ns = ns_of(message.created_from());
  if (message.has_created_before()) out.created_before_ns = ns_of(message.created_before());
  if (message.algorithm_version() != 0) out.algorithm_version = message.algorithm_version();
  return out;
}

DesignFilter filter_of(const v1::DesignFilter& message) {
  DesignFilter out;
  out.prefix = message.prefix();
  if (message.has_changed_from()) out.changed_from_ns = ns_of(message.changed_from());
  if (message.has_changed_before()) out.changed_before_ns = ns_of(message.changed_before());
  return out;
}

RevisionOrder order_of(v1::RevisionOrder order) {
  switch (order) {
    case v1::REVISION_ORDER_UNSPECIFIED:
      return RevisionOrder::Place;
    case v1::REVISION_ORDER_CREATED:
      return RevisionOrder::Created;
    case v1::REVISION_ORDER_NODES:
      return RevisionOrder::Nodes;
    default:
      throw error::option_invalid("order", "is no known enumerator");
  }
}

DesignOrder order_of(v1::DesignOrder order) {
  switch (order) {
    case v1::DESIGN_ORDER_UNSPECIFIED:
      return DesignOrder::Name;
    case v1::DESIGN_ORDER_CHANGED:
      return DesignOrder::Changed;
    case v1::DESIGN_ORDER_REVISIONS:
      return DesignOrder::Revisions;
    default:
      throw error::option_invalid("order", "is no known enumerator");
  }
}

/// Cuts rows, of which `limit` + 1 were asked for, to `limit`; whether there were more.
template <typename Rows>
bool cut(Rows& rows, int limit) {
  if (rows.size() <= static_cast<std::size_t>(limit)) return false;
  rows.resize(static_cast<std::size_t>(limit));
  return true;
}

}  // namespace

v1::ListRevisionsResponse list_revisions(Session& session,
                                         const v1::ListRevisionsRequest& request) {
  const ListIdentity list("revisions", request.filter(), request.order(), request.descending());
  const int limit = rows_of(request.page_size());
  RevisionPage page{.order = order_of(request.order()),
                    .descending = request.descending(),
                    .after = std::nullopt,
                    .limit = limit + 1};
  if (!request.page_token().empty()) {
    const ListIdentity::Row row = list.read(request.page_token());
    page.after = {.value = row.value, .id = row.id, .design = row.name, .number = row.number};
  }
  auto rows = session.list(filter_of(request.filter()), page);
  const bool more = cut(rows, limit);
  v1::ListRevisionsResponse out;
  for (const ListedRevision& row : rows) *out.add_revisions() = encode(row.record, row.place);
  if (more) {
    const RevisionKey last = key_of(rows.back(), page.order);
    out.set_next_page_token(list.token(last.value, last.id, last.number, last.design));
  }
  return out;
}

v1::ListDesignsResponse list_designs(Session& session, const v1::ListDesignsRequest& request) {
  const ListIdentity list("designs", request.filter(), request.order(), request.descending());
  const int limit = rows_of(request.page_size());
  DesignPage page{.order = order_of(request.order()),
                  .descending = request.descending(),
                  .after = std::nullopt,
                  .limit = limit + 1};
  if (!request.page_token().empty()) {
    const ListIdentity::Row row = list.read(request.page_token());
    page.after = {.value = row.value, .name = row.name};
  }
  auto rows = session.designs(filter_of(request.filter()), page);
  const bool more = cut(rows, limit);
  v1::ListDesignsResponse out;
  for (const DesignRecord& row : rows) *out.add_designs() = encode(row);
  if (more) {
    const DesignKey last = key_of(rows.back(), page.order);
    out.set_next_page_token(list.token(last.value, "", 0, last.name));
  }
  return out;
}

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "server/store/records.h"

namespace remeshd {

/// Which revisions are listed: those that meet every condition that is set.
struct RevisionFilter {
  std::string design, model_name, parent, root;
  bool heads = false;    ///< heads of designs only
  bool unfiled = false;  ///< those in no design only, else those in designs only
  std::optional<std::int64_t> created_from_ns, created_before_ns;
  std::optional<std::uint32_t> algorithm_version;
};

enum class RevisionOrder {
  Place,  ///< by name of the design, then number; those in no design by id
  Created,
  Nodes,
};

/// A row of a list of revisions.
struct ListedRevision {
  PlaceRecord place;  ///< empty where it is in no design
  RevisionRecord record;
};

/// Position of a row in a list; ties of `value` are ordered by id, then design.
struct RevisionKey {
  std::int64_t value = 0;  ///< what the order goes by; 0 with `Place`
  std::string id;
  std::string design;
  std::uint32_t number = 0;
};
RevisionKey key_of(const ListedRevision& row, RevisionOrder order);

struct DesignFilter {
  std::string prefix;  ///< of its name
  std::optional<std::int64_t> changed_from_ns, changed_before_ns;
};

enum class DesignOrder { Name, Changed, Revisions };

/// Position of a design in a list; ties of `value` are ordered by name.
struct DesignKey {
  std::int64_t value = 0;  ///< what the order goes by; 0 with `Name`
  std::string name;
};
DesignKey key_of(const DesignRecord& row, DesignOrder order);

/// The part of a list that is wanted: at most `limit` rows, after the position `after`.
template <typename Order, typename Key>
struct Page {
  Order order{};
  bool descending = false;
  std::optional<Key> after;
  int limit = 1000;
};
using RevisionPage = Page<RevisionOrder, RevisionKey>;
using DesignPage = Page<DesignOrder, DesignKey>;

}  // namespace remeshd

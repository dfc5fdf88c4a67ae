#include "server/store/listing.h"

#include <variant>
#include <vector>

#include "server/store/catalogue.h"
#include "server/store/catalogue_rows.h"

namespace remeshd {
namespace {

/// A WHERE clause with the values of its parameters.
class Conditions {
 public:
  template <typename... Values>
  void add(const std::string& condition, const Values&... values) {
    text_ += " AND " + condition;
    (values_.emplace_back(values), ...);
  }
  void equal(const char* column, const std::string& value) {
    if (!value.empty()) add(std::string(column) + " = ?", value);
  }
  void within(const char* column, const std::optional<std::int64_t>& from,
              const std::optional<std::int64_t>& before) {
    if (from) add(std::string(column) + " >= ?", *from);
    if (before) add(std::string(column) + " < ?", *before);
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  void bind(Sqlite::Statement& statement) const {
    for (const auto& value : values_) std::visit([&](const auto& v) { statement.bind(v); }, value);
  }

 private:
  std::string text_ = "WHERE true";
  std::vector<std::variant<std::string, std::int64_t>> values_;
};

/// The columns that a list is sorted by, the most significant first.
using Columns = std::vector<std::string>;

/// ` ORDER BY a DESC, b DESC LIMIT ?`
std::string in_order(const Columns& columns, bool descending) {
  std::string text;
  for (const std::string& column : columns)
    text += (text.empty() ? " ORDER BY " : ", ") + column + (descending ? " DESC" : "");
  return text + " LIMIT ?";
}

/// `(a, b) < (?, ?)`: the condition of rows that come later.
std::string past(const Columns& columns, bool descending) {
  std::string names, marks;
  for (const std::string& column : columns) {
    names += (names.empty() ? "" : ", ") + column;
    marks += marks.empty() ? "?" : ", ?";
  }
  return "(" + names + ")" + (descending ? " < " : " > ") + "(" + marks + ")";
}

}  // namespace

RevisionKey key_of(const ListedRevision& row, RevisionOrder order) {
  RevisionKey key{.id = row.record.id, .design = row.place.design, .number = row.place.number};
  if (order == RevisionOrder::Created) key.value = row.record.created_ns;
  if (order == RevisionOrder::Nodes) key.value = row.record.nodes;
  return key;
}

DesignKey key_of(const DesignRecord& row, DesignOrder order) {
  DesignKey key{.name = row.name};
  if (order == DesignOrder::Changed) key.value = row.changed_ns;
  if (order == DesignOrder::Revisions) key.value = row.revisions;
  return key;
}

std::vector<ListedRevision> Catalogue::list(const RevisionFilter& filter,
                                            const RevisionPage& page) {
  const std::string rows =
      filter.unfiled
          ? "(SELECT '' AS design, 0 AS number, false AS head, r.* FROM revisions r "
            "WHERE r.id NOT IN (SELECT id FROM places)) r "
          : "(SELECT p.design AS design, p.number AS number, d.head = p.id AS head, r.* "
            "FROM places p JOIN designs d ON d.name = p.design JOIN revisions r ON r.id = p.id) r ";
  Conditions where;
  where.equal("r.design", filter.design);
  where.equal("r.model_name", filter.model_name);
  where.equal("r.parent", filter.parent);
  where.equal("r.root", filter.root);
  where.within("r.created_ns", filter.created_from_ns, filter.created_before_ns);
  if (filter.heads) where.add("r.head");
  if (filter.algorithm_version)
    where.add("r.algorithm_version = ?", std::int64_t{*filter.algorithm_version});

  const bool by_place = page.order == RevisionOrder::Place;
  const std::string value = page.order == RevisionOrder::Created ? "r.created_ns" : "r.nodes";
  const Columns columns =
      by_place ? Columns{"r.design", "r.number", "r.id"} : Columns{value, "r.id", "r.design"};
  if (page.after) {
    const RevisionKey& key = *page.after;
    const std::string condition = past(columns, page.descending);
    if (by_place) {
      where.add(condition, key.design, std::int64_t{key.number}, key.id);
    } else {
      where.add(condition, key.value, key.id, key.design);
    }
  }
  auto row = database_.prepare("SELECT r.design, r.number, r.head, " + kRevisionColumns + " FROM " +
                               rows + where.text() + in_order(columns, page.descending));
  where.bind(row);
  row.bind(std::int64_t{page.limit});
  std::vector<ListedRevision> found;
  while (row.step()) {
    ListedRevision next{.place = {.design = row.text(0),
                                  .number = static_cast<std::uint32_t>(row.number(1)),
                                  .head = row.number(2) != 0},
                        .record = read_revision(row, 3)};
    next.place.id = next.record.id;
    found.push_back(std::move(next));
  }
  return found;
}

std::vector<DesignRecord> Catalogue::designs(const DesignFilter& filter, const DesignPage& page) {
  Conditions where;
  if (!filter.prefix.empty())
    where.add("substr(name, 1, length(?)) = ?", filter.prefix, filter.prefix);
  where.within("changed", filter.changed_from_ns, filter.changed_before_ns);
  const bool by_name = page.order == DesignOrder::Name;
  const std::string value = page.order == DesignOrder::Changed ? "changed" : "revisions";
  const Columns columns = by_name ? Columns{"name"} : Columns{value, "name"};
  if (page.after) {
    const std::string condition = past(columns, page.descending);
    if (by_name) {
      where.add(condition, page.after->name);
    } else {
      where.add(condition, page.after->value, page.after->name);
    }
  }
  auto row = database_.prepare(kSelectDesigns + where.text() + in_order(columns, page.descending));
  where.bind(row);
  row.bind(std::int64_t{page.limit});
  std::vector<DesignRecord> found;
  while (row.step()) found.push_back(read_design(row));
  return found;
}

}  // namespace remeshd

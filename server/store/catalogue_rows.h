#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "proto/checksum.h"
#include "server/store/packs.h"
#include "server/store/records.h"
#include "server/store/sqlite.h"

namespace remeshd {

/// A list of numbers as the bytes of a column, and back.
inline std::string_view bytes_of(const std::vector<double>& numbers) {
  if (numbers.empty()) return "";  // an empty list may have no address, which would be NULL
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}
inline std::vector<double> numbers_in(const std::string& bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

/// The columns that `read_revision` takes, of a table called `r`.
inline const std::string kRevisionColumns =
    "r.id, r.parent, r.root, r.model_name, r.model, r.algorithm_version, r.created_ns, r.nodes, "
    "r.tets, r.bytes, r.base, r.seconds, r.pinned, r.mid_nodes";

inline RevisionRecord read_revision(const Sqlite::Statement& row, int first) {
  return {.id = row.text(first),
          .parent = row.text(first + 1),
          .root = row.text(first + 2),
          .model_name = row.text(first + 3),
          .model = row.text(first + 4),
          .algorithm_version = static_cast<std::uint32_t>(row.number(first + 5)),
          .created_ns = row.number(first + 6),
          .nodes = static_cast<std::uint32_t>(row.number(first + 7)),
          .tets = static_cast<std::uint32_t>(row.number(first + 8)),
          .mid_nodes = static_cast<std::uint32_t>(row.number(first + 13)),
          .bytes = static_cast<std::uint64_t>(row.number(first + 9)),
          .base = row.text(first + 10),
          .seconds = numbers_in(row.text(first + 11)),
          .pinned = row.number(first + 12) != 0};
}

/// An id as the columns of recipes have it: 32 bytes in place of 64 digits. A recipe is kept for
/// every ancestor of a revision, so that these tables grow with every edit, and they are in memory.
inline std::string key_of(const std::string& id) {
  return is_full_id(id) ? from_hex(id) : id;  // empty where there is no parent
}
inline std::string id_of(const std::string& key) {
  constexpr std::size_t kKeyBytes = 32;
  return key.size() == kKeyBytes ? to_hex(key) : key;
}

/// The recipe of a row that begins with the columns recipe, line_start, line_length.
inline KeptRecipe read_recipe(const Sqlite::Statement& row) {
  if (row.number(2) == 0) return {row.text(0)};
  return {JournalPlace{.start = static_cast<std::uint64_t>(row.number(1)),
                       .length = static_cast<std::uint64_t>(row.number(2))}};
}

/// Designs that are on the list, with the columns that `read_design` takes. Where the time of the
/// last change is not known, it is that of the newest revision.
inline const std::string kSelectDesigns =
    "SELECT * FROM (SELECT d.name AS name, d.head AS head, d.next_number AS next_number, "
    "(SELECT count(*) FROM places p WHERE p.design = d.name) AS revisions, "
    "(SELECT p.number FROM places p WHERE p.design = d.name AND p.id = d.head) AS head_number, "
    "CASE WHEN d.changed_ns > 0 THEN d.changed_ns ELSE coalesce((SELECT max(r.created_ns) "
    "FROM places p JOIN revisions r ON r.id = p.id WHERE p.design = d.name), 0) END AS changed "
    "FROM designs d WHERE d.listed) ";

inline DesignRecord read_design(const Sqlite::Statement& row) {
  return {.name = row.text(0),
          .head = row.text(1),
          .head_number = static_cast<std::uint32_t>(row.number(4)),
          .next_number = static_cast<std::uint32_t>(row.number(2)),
          .revisions = static_cast<std::uint32_t>(row.number(3)),
          .changed_ns = row.number(5)};
}

}  // namespace remeshd

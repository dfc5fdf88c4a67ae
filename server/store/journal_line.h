#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "server/store/records.h"

namespace remeshd {

/// A line of the journal.
struct JournalLine {
  /// Of this line, one more than that of the line before; 0 in a line of the first version, which
  /// had no numbers.
  std::uint64_t number = 0;
  Transaction transaction;
};

/// The checked line (see `checked_line`) of a transaction, line break included. Pre: its recipes
/// are there in full, not by their place.
std::string write_journal_line(const JournalLine& line);

/// Nothing where the line is damaged, of a newer version, or has an operation that is not known.
std::optional<JournalLine> read_journal_line(std::string_view line);

}  // namespace remeshd

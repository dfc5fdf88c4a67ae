#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/goals.h"
#include "tests/bench/results.h"

namespace remeshd::bench {

using Cells = std::vector<std::string>;
/// A row of a table in Markdown.
std::string row(const Cells& cells);

/// Remesh against regular run, phase by phase: a row for each case, size and number of iterations.
std::string timing_table(const Results& results);

/// Ours and the peers: a row for each case, size and mesher.
std::string peer_table(const Results& results);

/// Chains of edits; empty where none was measured.
std::string chain_table(const Results& results);

/// What was asked and what came out, missed ones in bold.
std::string goal_table(const std::vector<Goal>& goals);

/// A document with the tables in place of what lies between the marks below, or nothing where it
/// has no such marks.
std::optional<std::string> between_marks(const std::string& document, const std::string& tables);
inline constexpr const char* kBeginMark = "<!-- remesh-bench begin -->";
inline constexpr const char* kEndMark = "<!-- remesh-bench end -->";

/// All of it with machine, date and command, in Markdown; of runs that were `sized` that table.
std::string report(const Results& results, bool sized = false);

}  // namespace remeshd::bench

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "client/cli/report/content.h"

namespace remeshd::cli {

/// Of a tet, as the page colours it. The values are those of the page's arrays.
enum class TetState : std::uint8_t {
  New = 0,    ///< has a new node, or joins kept nodes anew
  Kept = 1,   ///< its four nodes are kept and formed a tet
  Moved = 2,  ///< no node is new, at least one was moved
  Gone = 3,   ///< of the base: not kept
};

/// Nodes or tets of the new mesh by where they come from, and those of the base that have gone.
struct StateCounts {
  std::size_t kept = 0, moved = 0, added = 0, gone = 0;
};

/// How the nodes and tets of two meshes correspond.
struct Correspondence {
  std::vector<TetState> base;      ///< by tet of the base: Kept or Gone; empty without a base
  std::vector<TetState> modified;  ///< by tet: New, Kept or Moved
  StateCounts nodes, tets;
};

/// Uses the maps of the new mesh where it is an edit of the base. Where several edits lie between,
/// uses permanent ids: a node at another place counts as moved, even if it moved with its feature.
/// Else all is new, and all of the base is gone.
Correspondence correspond(const ReportContent& content);

}  // namespace remeshd::cli

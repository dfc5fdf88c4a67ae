#pragma once

#include <string>

#include "server/session/commands.h"

namespace remeshd {

/// A revision that is filed in a design, and the design's head, as the decision sees them.
struct HeadSituation {
  std::string id;           ///< of the revision
  std::string head;         ///< id of the design's head; empty where it has none
  bool is_new = true;       ///< to the design
  bool first_mesh = false;  ///< of a model, not of an edit
  bool same_model = true;   ///< as the design's first revision
};

struct HeadDecision {
  bool move = false;      ///< it becomes the head
  bool conflict = false;  ///< the head is not the expected one, and the rule moves or requires it
  /// The head stays: the request did not say whether to move it, and the revision is a first mesh
  /// whose model is not that of the design's first revision.
  bool kept = false;
};

HeadDecision decide_head(const HeadRule& rule, const HeadSituation& now);

}  // namespace remeshd

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
  bool kept = false;      ///< it does not: the request left that open, and its model is another one
};

HeadDecision decide_head(const HeadRule& rule, const HeadSituation& now);

}  // namespace remeshd

#pragma once

#include <string>

#include "server/session/commands.h"

namespace remeshd {

/// How a revision stands to the head of the design that it is filed in.
struct HeadSituation {
  std::string id;           ///< of the revision
  std::string head;         ///< id of the design's head; empty where it has none
  bool is_new = true;       ///< to the design
  bool first_mesh = false;  ///< of a model, not of an edit
  bool same_model = true;   ///< as the design's first revision
};

struct HeadDecision {
  bool move = false;      ///< it becomes the head
  bool conflict = false;  ///< it was to, but the head is not the expected one
  bool kept = false;      ///< it does not, for nobody asked for it and its model is another one
};

HeadDecision decide_head(const HeadRule& rule, const HeadSituation& now);

}  // namespace remeshd

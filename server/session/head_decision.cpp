#include "server/session/head_decision.h"

namespace remeshd {

HeadDecision decide_head(const HeadRule& rule, const HeadSituation& now) {
  if (now.head.empty()) return {.move = !rule.never};
  if (now.head == now.id) return {};
  const bool expected = rule.expected.empty() || now.head == rule.expected;
  const bool unasked = !rule.advance && now.first_mesh;
  const bool wanted = unasked ? now.is_new && now.same_model : rule.advance.value_or(true);
  return {.move = wanted && expected,
          .conflict = !expected && (wanted || rule.require),
          .kept = unasked && !now.same_model};
}

}  // namespace remeshd

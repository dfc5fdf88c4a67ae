#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tests/campaign/campaign_case.h"
#include "tests/campaign/parts/lost_nodes.h"

namespace remeshd::campaign {

/// What came of a first mesh (step 0) or of an edit (step k: the case's steps[k - 1]).
struct Outcome {
  std::size_t step = 0;
  std::string kind;  ///< `valid`, `invalid`, `refused`, `exception`; of a process: `crash`, `hang`
  std::string reason;    ///< of a refusal; the failed checks of an invalid mesh; a signal
  std::string message;   ///< one sentence
  bool placed = true;    ///< a refusal names a feature and says where
  std::string strategy;  ///< as in Report
  int inserted = 0;      ///< nodes, to make the boundary complete
  double seconds = 0, verifier_seconds = 0;
  double processor_seconds =
      0;  ///< for `seconds`, with those of helpers; other work leaves it as it is
  double least_angle = 0, least_quality = 0;  ///< degrees; volume-length
  int nodes = 0;
  double kept = 0;         ///< share of nodes
  double away_angle = 0;   ///< least dihedral angle away from the model's sharp places, degrees
  double last_resort = 0;  ///< share of the tets that a last resort made
  double newly_last_resort = 0;  ///< of them those that it made in this step
  LostNodes lost;                ///< of an edit

  [[nodiscard]] bool valid() const { return kind == "valid"; }
  /// Of what failed: kind and reason.
  [[nodiscard]] std::string failure() const { return kind + " " + reason; }
};

nlohmann::json write_outcome(const Outcome& outcome);
Outcome read_outcome(const nlohmann::json& j);

/// Makes and verifies the first mesh and each edit's. A mesh that is not valid is no base: the next
/// edit starts from the last valid one; without a first mesh, none is tried.
///
/// `before`: called with each step before it is tried; `after`: with what came of it.
void run_case(const CampaignCase& c, const std::function<void(std::size_t)>& before,
              const std::function<void(const Outcome&)>& after);

}  // namespace remeshd::campaign

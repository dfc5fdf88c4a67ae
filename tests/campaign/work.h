#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tests/campaign/campaign_case.h"
#include "tests/campaign/run_case.h"

namespace remeshd::campaign {

/// What the tally needs to know about one step; step 0 is the first mesh.
struct StepFacts {
  bool measured = false;      ///< the CAD kernel did not fail at either of its models
  bool good_natured = false;  ///< both models of the edit are
  bool topology_changed = false;
  bool tangent = false, coincident = false, wedge = false;  ///< in the model after the step
  double smallest = 0;                                      ///< of the model after the step, in l
  std::string kind;                                         ///< of the edit
  double size = 0;
  std::vector<std::string> types;  ///< of the features after the step
};

/// A case as a worker process did it: everything that it could write down before it ended.
struct WorkedCase {
  CampaignCase campaign_case;
  bool gentle = false;
  std::vector<StepFacts> facts;
  std::map<std::string, int> discarded;
  std::vector<Outcome> outcomes;  ///< the last may be a crash or hang
  bool made = false;              ///< false: the process ended while the case was made
};

nlohmann::json write_worked(const WorkedCase& worked);
WorkedCase read_worked(const nlohmann::json& j);

/// The worker's side: prints an event a line.
void work_on_request(const CaseRequest& request);
void work_on_file(const std::string& file);

/// The runner's side: has another process work on it, for this long at most (wall clock).
WorkedCase have_worked(const CaseRequest& request, double seconds);
WorkedCase have_worked(const std::string& file, double seconds);

}  // namespace remeshd::campaign

#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/campaign/campaign_case.h"
#include "tests/campaign/model_facts.h"

namespace remeshd::campaign {

/// A case with what is known of its models: facts[k] is about the model after k steps.
struct RandomCase {
  CampaignCase campaign_case;
  bool gentle = false;  ///< made to be good-natured
  double length = 0;    ///< target edge length l of all its meshes
  std::vector<ModelFacts> facts;
  bool measured = true;                  ///< facts hold measures; of detailed parts they do not
  std::map<std::string, int> discarded;  ///< models not used, by the reason of their refusal
};

/// Whether the case is meant to be good-natured.
bool is_gentle(std::uint64_t seed, std::uint64_t number);

/// Case `number` of a campaign: always the same for the same seed and number. Models that are
/// rightly refused are made anew. An edit that the CAD kernel fails at stays, and is undone; a
/// first model ends the case.
///
/// `before_look`: called with each model before it is looked at, which may crash.
RandomCase make_case(std::uint64_t seed, std::uint64_t number,
                     const std::function<void(const CampaignCase&)>& before_look);
/// The same, or that of a detailed part.
RandomCase make_case(const CaseRequest& request,
                     const std::function<void(const CampaignCase&)>& before_look);

}  // namespace remeshd::campaign

#pragma once

#include "tests/campaign/random_case.h"

namespace remeshd::campaign {

/// A detailed part, one of the four of tests/cases/detailed or one made at random, and a loop of
/// ten to twenty edits of it: drifts, sweeps and jumps of parameters, moves, additions, removals.
/// Always the same for the same request.
///
/// Models that are rightly refused, or drawn worse than the one before, are made anew; one that the
/// CAD kernel fails at stays as an edit, and is undone. Facts hold no measures.
///
/// Pre: the request asks for parts.
RandomCase make_part_case(const CaseRequest& request,
                          const std::function<void(const CampaignCase&)>& before_look);

}  // namespace remeshd::campaign

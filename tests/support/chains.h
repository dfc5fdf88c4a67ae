#pragma once

#include <string>
#include <vector>

#include "engine/remesh/remesh.h"

namespace remeshd::test {

/// Edits of one parameter each, one after the other.
struct Chain {
  struct Step {
    std::string parameter;
    double value;
    MeshOptions options;
  };
  std::string model;  ///< of tests/cases
  std::vector<Step> steps;
};

/// Chains of which the steps are answered by an unchanged, a morphed, a local and a renewed mesh.
inline std::vector<Chain> chains_that_go_all_ways() {
  const MeshOptions poor{.iterations = 1, .start = MeshOptions::Start::Random};
  return {{"tool1-a",
           {{"hole_circle", 36.02, {}}, {"pin_radius", 5, {}}, {"pin_radius", 5 + 1e-13, {}}}},
          {"tool3-a", {{"width", 72, poor}, {"boss_x", 33, {}}, {"boss_x", 33.02, {}}}}};
}

}  // namespace remeshd::test

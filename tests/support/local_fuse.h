#pragma once

#include <string>
#include <vector>

#include "engine/local_fuse/arrangement/intersection_curves.h"
#include "engine/local_fuse/arrangement/planar_arrangement.h"
#include "engine/local_fuse/gave_up.h"
#include "tests/support/cases.h"

namespace remeshd::test {

/// Why something was given up, `slabs: two heights are ...`; empty where it was not.
template <typename T>
std::string reason_of(const Tried<T>& tried) {
  return tried ? "" : text_of(tried.why());
}

/// A model with what the functions of local_fuse ask for, all its features taken.
struct FuseInput {
  FeatureModel model;
  Membership membership;
  std::vector<int> features;
  double diagonal = 0;
  Clearance clearance;

  explicit FuseInput(const ModelSource& source)
      : model(evaluate(source)), membership(model), features(all_of(model)) {
    Box box;
    for (const Solid& solid : membership.solids()) box.add(solid.bounds());
    diagonal = box.diagonal();
    clearance = {kSameOutline * diagonal, kClearOutline * diagonal};
  }
};

}  // namespace remeshd::test

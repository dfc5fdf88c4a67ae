#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/model/feature_model.h"
#include "engine/model/source.h"

namespace remeshd::test {

/// A model of tests/cases by its file's name without ending: `case_model("tool1-a")`. This reader
/// takes the cases as they are and checks nothing: documents of clients go through the protocol.
ModelSource case_model(const std::string& name);

/// An edit of tests/cases: `case_edit("tool1-ac")`.
ModelEdit case_edit(const std::string& name);

/// `evaluate(case_model(name))`.
FeatureModel case_features(const std::string& name);

/// An edit case of tests/cases: `tool1-ac` takes `tool1-a` to `tool1-c`.
struct EditCase {
  std::string original, edit, modified;
  double original_volume, modified_volume;  ///< exact, mm^3, from tests/cases/README.md
};

/// The paper's six cases (Fig. 17) and tool2-cd.
const std::vector<EditCase>& seven_cases();

/// Parts with details finer than one edge length, by their names: models `detailed/valve` and edits
/// of the same name.
const std::vector<std::string>& detailed_parts();

/// Models for tests that need no document.
ModelSource one_feature(FeatureSource feature);
ModelSource model_of(std::vector<FeatureSource> features);

/// The value of a parameter that the model has.
Scalar& parameter(ModelSource& model, const std::string& name);

/// An additive feature at the origin.
FeatureSource feature(std::string id, std::string type,
                      std::map<std::string, Scalar> parameters = {});

/// An additive feature at the origin with a profile.
FeatureSource feature(std::string id, std::string type, std::vector<ProfileEntry> profile,
                      std::map<std::string, Scalar> parameters);

/// Additive features at the origin, sizes in model units.
FeatureSource block(std::string id, double dx, double dy, double dz);
FeatureSource cylinder(std::string id, double radius, double height);

/// The feature elsewhere.
FeatureSource placed(FeatureSource feature, double x, double y, double z,
                     Nature nature = Nature::Additive);

/// The feature with the z and x axes given.
FeatureSource turned(FeatureSource feature, std::array<double, 3> z, std::array<double, 3> x);

/// The indices of its features.
std::vector<int> all_of(const FeatureModel& model);

/// Entries of a profile: a point, and an arc that ends at (x, y) by way of (tx, ty).
ProfileEntry point(Scalar x, Scalar y);
ProfileEntry arc(Scalar x, Scalar y, Scalar tx, Scalar ty);

}  // namespace remeshd::test

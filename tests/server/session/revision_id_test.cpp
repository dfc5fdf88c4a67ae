#include "server/session/revision_id.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace remeshd {
namespace {

ModelSource model() {
  FeatureSource plate{.id = "plate", .nature = Nature::Additive, .type = "prism"};
  plate.parameters = {{"height", 4.0}};
  plate.profile = {{.x = 0.0, .y = 0.0, .through = {}}, {.x = 1.0, .y = 0.0, .through = {}}};
  FeatureSource hole{.id = "hole", .nature = Nature::Subtractive, .type = "cylinder"};
  hole.parameters = {{"radius", "r"}, {"height", 4.0}};
  return {.name = "m", .unit = "mm", .parameters = {{"r", 4.0}}, .features = {plate, hole}};
}

TEST(RevisionId, IsSixtyFourHexadecimalDigitsAndTheSameEverywhere) {
  // Ids are stored and shared: a change here orphans every store, and takes a new algorithm
  // version.
  EXPECT_EQ(revision_id(model(), {.nodes = 100}, "", 1),
            "80879f7d9dae109d6d678909e8f79a7c1df845d860d4e582afd81f0aa3c3dce9");
  EXPECT_EQ(revision_id({}, {}, "", 1).find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(revision_id({}, {}, "", 1).size(), 64U);
}

TEST(RevisionId, DiffersWithEverythingThatADocumentSays) {
  const std::vector<std::function<void(ModelSource&)>> changes{
      [](ModelSource&) {},
      [](ModelSource& m) { m.name = "n"; },
      [](ModelSource& m) { m.unit = "cm"; },
      [](ModelSource& m) { m.parameters[0].value = 5.0; },
      [](ModelSource& m) { m.parameters[0].value = "4"; },
      [](ModelSource& m) {
        m.parameters.push_back({"s", 4.0});
      },
      [](ModelSource& m) {
        m.parameters.insert(m.parameters.begin(), {"s", 4.0});
      },
      [](ModelSource& m) { m.parameters[0].lower = 4.0; },
      [](ModelSource& m) { m.parameters[0].upper = 4.0; },
      [](ModelSource& m) { m.parameters[0].integer = true; },
      [](ModelSource& m) { m.parameters[0].unit = "mm"; },
      [](ModelSource& m) { std::swap(m.features[0], m.features[1]); },
      [](ModelSource& m) { m.features[1].id = "bore"; },
      [](ModelSource& m) { m.features[1].nature = Nature::Additive; },
      [](ModelSource& m) { m.features[1].type = "cone"; },
      [](ModelSource& m) { m.features[1].parameters["radius"] = 4.0; },
      [](ModelSource& m) { m.features[1].parameters["height"] = -0.0; },
      [](ModelSource& m) { m.features[1].parameters["height"] = 0.0; },
      [](ModelSource& m) { m.features[0].profile.reset(); },
      [](ModelSource& m) { (*m.features[0].profile)[1].x = 2.0; },
      [](ModelSource& m) {
        (*m.features[0].profile)[1].through = {{0.5, 1.0}};
      },
      [](ModelSource& m) { m.features[1].placement.origin[2] = 1.0; },
      [](ModelSource& m) {
        m.features[1].placement.z_axis = {{0.0, 0.0, 1.0}};
      },
      [](ModelSource& m) {
        m.features[1].placement.x_axis = {{0.0, 0.0, 1.0}};
      },
      [](ModelSource& m) { m.features[1].reference = ReferenceKind::Centre; },
      [](ModelSource& m) {
        m.features[1].reference = std::array<Scalar, 3>{0.0, 0.0, 0.0};
      },
      [](ModelSource& m) { m.features.pop_back(); }};
  std::set<std::string> ids;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    ModelSource changed = model();
    changes[i](changed);
    EXPECT_TRUE(ids.insert(revision_id(changed, {}, "", 1)).second) << "change " << i;
  }
}

TEST(RevisionId, DiffersWithTheSizesOfTheModel) {
  const std::vector<std::vector<SizeControlSource>> all{
      {},
      {{"a", "b", "c"}},
      {{"b", "b", "c"}},
      {{"a", "c", "c"}},
      {{"a", "b", 1.0}},
      {{"a", "b", "c"}, {"d", "b", "c"}},
      {{"d", "b", "c"}, {"a", "b", "c"}},
      {{"a", BallSource{0.0, 0.0, 0.0, 1.0}, "c"}},
      {{"a", BallSource{0.0, 0.0, 0.0, 2.0}, "c"}},
      {{"a", BoxSource{0.0, 0.0, 0.0, 1.0, 1.0, 1.0}, "c"}},
      {{"a", BoxSource{0.0, 0.0, 0.0, 1.0, 1.0, 2.0}, "c"}}};
  std::set<std::string> ids, digests;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ModelSource changed = model();
    changed.sizes = all[i];
    EXPECT_TRUE(ids.insert(revision_id(changed, {}, "", 1)).second) << "sizes " << i;
    EXPECT_TRUE(digests.insert(model_digest(changed)).second) << "sizes " << i;
  }
}

TEST(RevisionId, DescriptionsOfParametersAreForPeople) {
  ModelSource described = model();
  described.parameters[0].description = "radius of the hole";
  EXPECT_EQ(revision_id(described, {}, "", 1), revision_id(model(), {}, "", 1));
  EXPECT_EQ(model_digest(described), model_digest(model()));
}

TEST(RevisionId, TheDigestOfAModelDiffersWithTheModelAlone) {
  ModelSource other = model();
  other.parameters[0].upper = 5;
  EXPECT_NE(model_digest(other), model_digest(model()));
  EXPECT_NE(model_digest(model()), revision_id(model(), {}, "", 1));
}

TEST(RevisionId, DiffersWithOptionsParentAndAlgorithm) {
  std::set<std::string> ids;
  for (const MeshOptions& options :
       {MeshOptions{}, MeshOptions{.nodes = 100}, MeshOptions{.nodes = 101},
        MeshOptions{.size = 100}, MeshOptions{.nodes = 100, .iterations = 5},
        MeshOptions{.nodes = 100, .seed = 2}, MeshOptions{.nodes = 100, .clean_up = false},
        MeshOptions{.nodes = 100, .inside = MeshOptions::Inside::ControlMesh},
        MeshOptions{.nodes = 100, .start = MeshOptions::Start::Random},
        MeshOptions{.nodes = 100, .threshold = 0.4}, MeshOptions{.nodes = 100, .order = 2}})
    EXPECT_TRUE(ids.insert(revision_id(model(), options, "", 1)).second);
  EXPECT_TRUE(ids.insert(revision_id(model(), {}, std::string(64, 'a'), 1)).second);
  EXPECT_TRUE(ids.insert(revision_id(model(), {}, "", 2)).second);
}

TEST(RevisionId, OfAnEvenMeshSaysNothingOfItsSizing) {
  MeshOptions options{.nodes = 100};
  options.sizing = {.even = true, .edges_per_circle = 20, .layers = 3, .min_size = 1, .growth = 2};
  EXPECT_EQ(revision_id(model(), options, "", 1),
            "80879f7d9dae109d6d678909e8f79a7c1df845d860d4e582afd81f0aa3c3dce9");
}

TEST(RevisionId, DiffersWithTheSizing) {
  std::set<std::string> ids{revision_id(model(), {}, "", 1)};
  for (const Sizing& sizing :
       {Sizing{.even = false}, Sizing{.even = false, .edges_per_circle = 20},
        Sizing{.even = false, .layers = 20}, Sizing{.even = false, .min_size = 20},
        Sizing{.even = false, .growth = 2}})
    EXPECT_TRUE(ids.insert(revision_id(model(), {.sizing = sizing}, "", 1)).second);
  MeshOptions options{.nodes = 100};
  options.sizing = {
      .even = false, .edges_per_circle = 20, .layers = 3, .min_size = 0.5, .growth = 1.5};
  EXPECT_EQ(revision_id(model(), options, "", 1),
            "897c5bfac1aca64fc3daec668bf4a7386e8a3537c23008e67729aa240b5278d7");
}

TEST(RevisionId, DoesNotMixUpNeighbouringTexts) {
  ModelSource a = model(), b = model();
  a.name = "xy";
  a.unit = "z";
  b.name = "x";
  b.unit = "yz";
  EXPECT_NE(revision_id(a, {}, "", 1), revision_id(b, {}, "", 1));
}

}  // namespace
}  // namespace remeshd

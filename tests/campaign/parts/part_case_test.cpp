#include "tests/campaign/parts/part_case.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/cellular/cellular_model.h"
#include "tests/campaign/parts/drawing.h"
#include "tests/campaign/parts/drawn_part.h"

namespace remeshd::campaign {
namespace {

constexpr std::uint32_t kNodes = 2000;

RandomCase make(std::uint64_t seed, std::uint64_t number, bool even = false) {
  return make_case(CaseRequest{seed, number, kNodes, even}, [](const CampaignCase&) {});
}

/// A block, made once.
const RandomCase& some_case() {
  static const RandomCase made = make(1, 5);
  return made;
}

TEST(PartCase, IsTheSameForTheSameSeedAndNumber) {
  EXPECT_EQ(write_case(make(1, 5).campaign_case), write_case(some_case().campaign_case));
}

/// Points of all edges.
std::vector<Vec3> edge_points(const BoundaryModel& boundary) {
  std::vector<Vec3> result;
  for (const BoundaryEdge& edge : boundary.edges)
    result.insert(result.end(), edge.points.begin(), edge.points.end());
  return result;
}

TEST(PartCase, ChangesTheBoundaryWithEveryEdit) {
  const RandomCase made = make(1, 2);
  const CampaignCase& c = made.campaign_case;
  std::vector<Vec3> before;
  for (std::size_t k = 0; k < made.facts.size(); ++k) {
    if (!made.facts[k].refused.empty()) continue;
    const CellularModel cells = build_cells(evaluate(model_after(c, k)), remeshd::Run{});
    EXPECT_DOUBLE_EQ(made.facts[k].volume, cells.volume);
    const std::vector<Vec3> now = edge_points(cells.boundary);
    EXPECT_NE(now, before) << k;
    before = now;
  }
}

/// Of a case that nothing more is made of.
ModelSource first_model(std::uint64_t seed, std::uint64_t number) {
  struct Enough {};
  ModelSource first;
  try {
    make_case(CaseRequest{seed, number, 15000}, [&](const CampaignCase& c) {
      first = c.model;
      throw Enough{};
    });
  } catch (const Enough&) {
  }
  return first;
}

TEST(PartCase, IsAnotherForAnotherNumberOrSeed) {
  EXPECT_EQ(first_model(1, 5), first_model(1, 5));
  EXPECT_NE(first_model(1, 5), first_model(1, 2));
  EXPECT_NE(first_model(1, 5), first_model(2, 5));
}

TEST(PartCase, IsOneOfTheFourDetailedPartsInThreeOfTen) {
  std::map<std::string, int> names;
  for (std::uint64_t k = 0; k < 60; ++k) ++names[first_model(1, k).name];
  EXPECT_EQ(names.size(), 8U);
  EXPECT_NEAR(names["valve"] + names["mount"] + names["coldplate"] + names["carrier"], 18, 8);
}

TEST(PartCase, AsksForTheMeshesOfItsRequestAndComesBackFromItsFile) {
  const CampaignCase c = make(1, 5, true).campaign_case;
  EXPECT_EQ(c.options.nodes, kNodes);
  EXPECT_TRUE(c.options.sizing.even);
  EXPECT_FALSE(some_case().campaign_case.options.sizing.even);
  EXPECT_EQ(c.part, "block");
  const nlohmann::json document = write_case(c);
  const CampaignCase back = read_case(nlohmann::json::parse(document.dump()));
  EXPECT_EQ(write_case(back), document);
  EXPECT_EQ(back.options, c.options);
  EXPECT_EQ(back.part, c.part);
}

TEST(PartCase, HasALoopOfEditsEachOfTheModelBefore) {
  const RandomCase& made = some_case();
  const CampaignCase& c = made.campaign_case;
  EXPECT_GE(c.steps.size(), 10U);
  EXPECT_LE(c.steps.size(), 20U);
  EXPECT_EQ(made.facts.size(), c.steps.size() + 1);
  const std::set<std::string> kinds{"drift",    "sweep",   "jump", "move",
                                    "addition", "removal", "given"};
  ModelSource before = c.model;
  for (std::size_t k = 0; k < c.steps.size(); ++k) {
    EXPECT_TRUE(kinds.contains(c.steps[k].kind)) << c.steps[k].kind;
    const ModelSource after = apply(before, c.steps[k].edit);
    EXPECT_EQ(after, model_after(c, k + 1));
    EXPECT_FALSE(same_geometry(evaluate(before), evaluate(after)));
    if (!c.steps[k].undone) before = after;
  }
}

TEST(PartCase, IsDrawnNoWorseByAnEditThanItWas) {
  const CampaignCase& c = some_case().campaign_case;
  Drawing before;
  for (std::size_t k = 0; k <= c.steps.size(); ++k) {
    if (k > 0 && c.steps[k - 1].undone) continue;
    const FeatureModel model = evaluate(model_after(c, k));
    const Drawing now = look_at_drawing(model, build_cells(model, remeshd::Run{}).boundary);
    if (k > 0 && c.steps[k - 1].kind != "given") {
      EXPECT_TRUE(now.as_good_as(before)) << k;
    }
    before = now;
  }
}

TEST(DrawnPart, HasDetailsOfThreeScalesAndManyBodies) {
  std::set<std::string> bodies;
  int fine = 0, large = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const DrawnPart part = draw_part(seed, 15000);
    bodies.insert(part.body);
    const FeatureModel model = evaluate(part.model);
    for (const Feature& feature : model.features) {
      fine += least_size(feature) < 1;
      large += least_size(feature) > 8 && feature.id.starts_with("d");
    }
  }
  EXPECT_EQ(bodies, (std::set<std::string>{"plate", "block", "disc", "flange"}));
  EXPECT_GT(fine, 10);
  EXPECT_GT(large, 5);
}

}  // namespace
}  // namespace remeshd::campaign

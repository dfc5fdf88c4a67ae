#include <gtest/gtest.h>

#include "engine/model/feature_model.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

/// A plate with a lug whose top is flush with the plate's, both as high as a parameter says, and a
/// hole. The diagonal is 60.
ModelSource flush(double height, double radius) {
  FeatureSource plate = test::block("plate", 40, 40, 20);
  plate.parameters["dz"] = "h";
  FeatureSource lug = test::placed(test::block("lug", 10, 10, 20), 20, 0, 0);
  ModelSource model = test::model_of(
      {plate, lug, test::placed(test::cylinder("hole", 4, 30), 0, 0, -5, Nature::Subtractive)});
  model.features[2].parameters["radius"] = radius;
  model.parameters.push_back({"h", height});
  return model;
}

TEST(TinyMotions, AreUndoneInNumbers) {
  const TinyMotions tiny = without_tiny_motions(flush(20 + 1e-6, 5), flush(20, 4));
  EXPECT_EQ(tiny.features, std::vector<std::string>{"plate"});
  EXPECT_EQ(tiny.source.features[0].parameters.at("dz"), Scalar(20.0));
  EXPECT_EQ(tiny.source.features[2].parameters.at("radius"), Scalar(5.0));
  EXPECT_EQ(tiny.source.parameters, flush(20 + 1e-6, 5).parameters);
}

TEST(TinyMotions, AreLessThanWhatMatters) {
  EXPECT_TRUE(without_tiny_motions(flush(20 + 1e-3, 4), flush(20, 4)).features.empty());
}

TEST(TinyMotions, AreMoreThanRounding) {
  const ModelSource source = flush(20 + 1e-13, 4);
  const TinyMotions none = without_tiny_motions(source, flush(20, 4));
  EXPECT_TRUE(none.features.empty());
  EXPECT_EQ(none.source, source);
}

TEST(TinyMotions, LeaveFeaturesThatAreNew) {
  ModelSource before = flush(20, 4);
  before.features.erase(before.features.begin() + 1);
  EXPECT_TRUE(without_tiny_motions(flush(20, 4), before).features.empty());
}

TEST(TinyMotions, AreTheSameOnceUndone) {
  const ModelSource source = flush(20 + 1e-6, 5);
  const TinyMotions once = without_tiny_motions(source, flush(20, 4));
  const TinyMotions again = without_tiny_motions(source, once.source);
  EXPECT_EQ(again.source, once.source);
}

TEST(TinyMotions, CanBeUndoneOfEveryNumber) {
  const auto model = [](double by) {
    FeatureSource web = test::feature("web", "prism",
                                      {test::point(0.0, 0.0), test::point(9.0, 0.0),
                                       test::arc(9.0, 9.0 + by, 10.0, 4.0), test::point(0.0, 9.0)},
                                      {{"height", 9.0}});
    web = test::turned(web, {0, 0, 1}, {1, by, 0});
    web.placement.origin = {by, 0.0, "p"};
    web.reference = std::array<Scalar, 3>{1.0, "p", 2.0};
    ModelSource source = test::model_of({test::block("base", 60, 60, 60), web});
    source.parameters.push_back({"p", 3.0});
    return source;
  };
  const TinyMotions tiny = without_tiny_motions(model(1e-7), model(0));
  ASSERT_EQ(tiny.features, std::vector<std::string>{"web"});
  EXPECT_EQ(tiny.source.features[1].placement.origin, (std::array<Scalar, 3>{0.0, 0.0, 3.0}));
  EXPECT_EQ(motion_bound(evaluate(tiny.source), evaluate(model(0))), 0);
}

}  // namespace
}  // namespace remeshd

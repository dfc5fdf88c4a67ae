#include "engine/remesh/node_limit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::error_of;
using test::feature;
using test::model_of;
using test::placed;
using testing::HasSubstr;

ModelSource plate_of_length(double dx) {
  return model_of(
      {block("plate", dx, 40, 10), placed(cylinder("hole", 5, 10), 0, 0, 0, Nature::Subtractive)});
}

Run limited(std::uint32_t max_nodes) {
  Run run;
  run.max_nodes = max_nodes;
  return run;
}

/// What a computation is refused with; fails the test where it went on to make nodes.
ErrorInfo refused(const Revision& original, const ModelSource& source, const MeshOptions& options,
                  std::uint32_t max_nodes = kDefaultMaxNodes) {
  Run run = limited(max_nodes);
  std::set<std::string> stages;
  run.on_progress = [&](const Progress& p) { stages.emplace(p.stage); };
  ErrorInfo info = error_of([&] { make_revision(original, source, options, run); });
  EXPECT_FALSE(stages.contains("nodes"));
  EXPECT_EQ(info.kind, ErrorKind::InvalidArgument);
  return info;
}

/// What a request is refused with before anything is computed.
ErrorInfo refused_at_once(const Revision& original, const ModelSource& source,
                          const MeshOptions& options) {
  return error_of([&] { check_node_limit(original, evaluate(source), options, {}); });
}

const Revision& base() {
  static const Revision made =
      make_revision(Revision::none(), plate_of_length(80), {.nodes = 1000, .iterations = 1}, {});
  return made;
}

TEST(NodeLimit, HoldsForANumberOfNodes) {
  const ErrorInfo info = refused(Revision::none(), plate_of_length(80), {.nodes = 1001}, 1000);
  EXPECT_EQ(test::place_of(info), "MESH_TOO_LARGE - nodes");
  EXPECT_EQ(info.message, "the request asks for 1001 nodes, more than the limit of 1000");
  EXPECT_THAT(info.hint, HasSubstr("--max-nodes"));
  EXPECT_EQ(refused_at_once(Revision::none(), plate_of_length(80), {.nodes = 5'000'001}).message,
            "the request asks for 5000001 nodes, more than the limit of 5000000");
}

TEST(NodeLimit, HoldsForAnEdgeLength) {
  const ErrorInfo info = refused(Revision::none(), plate_of_length(80), {.size = 0.01});
  EXPECT_EQ(test::place_of(info), "MESH_TOO_LARGE - size");
  EXPECT_THAT(info.message, HasSubstr("an edge length of 0.01 needs about 4.4"));
  EXPECT_THAT(info.message, HasSubstr("e+10 nodes, more than the limit of 5000000"));
  EXPECT_THAT(info.hint, testing::Not(HasSubstr("--max-nodes")));  // no daemon takes more
  EXPECT_EQ(test::place_of(refused_at_once(Revision::none(), plate_of_length(80), {.size = 0.01})),
            "MESH_TOO_LARGE plate size");
}

TEST(NodeLimit, HoldsForTheEdgeLengthThatAnEditTakesOver) {
  const ErrorInfo info = refused(base(), plate_of_length(1e9), {});
  EXPECT_EQ(test::place_of(info), "MESH_TOO_LARGE - -");
  EXPECT_THAT(info.message, HasSubstr("the base's edge length of "));
  EXPECT_THAT(info.hint, HasSubstr("mesh the edited model anew"));
  const ErrorInfo at_once = refused_at_once(base(), plate_of_length(1e9), {});
  EXPECT_EQ(test::place_of(at_once), "MESH_TOO_LARGE plate -");
  EXPECT_THAT(at_once.message, HasSubstr("for the feature 'plate' alone at least "));
}

TEST(NodeLimit, HoldsForAnEditThatAsksForFewNodesBecauseItsEdgeLengthIsNoLargerThanItsBases) {
  for (const MeshOptions& options : {MeshOptions{.nodes = 100}, MeshOptions{.size = 1e6}}) {
    EXPECT_EQ(refused(base(), plate_of_length(1e9), options).reason, "MESH_TOO_LARGE");
    EXPECT_EQ(refused_at_once(base(), plate_of_length(1e9), options).reason, "MESH_TOO_LARGE");
  }
}

TEST(NodeLimit, TakesTheExactVolumeWhereFeaturesOverlap) {
  // Six blocks in one place: closed formulas cannot tell that they are one.
  std::vector<FeatureSource> features;
  for (int k = 0; k < 6; ++k) features.push_back(block("b" + std::to_string(k), 10, 10, 10));
  check_node_limit(Revision::none(), evaluate(model_of(features)), {.size = 1}, limited(2000));
  EXPECT_EQ(refused(Revision::none(), model_of(features), {.size = 1}, 1500).reason,
            "MESH_TOO_LARGE");
  make_revision(Revision::none(), model_of(features), {.size = 1, .iterations = 1}, limited(2000));
}

TEST(NodeLimit, HoldsForBodiesSoThinThatVolumeAndAreaComeToNothing) {
  const MeshOptions few{.nodes = 1000};
  const ErrorInfo bar =
      refused(Revision::none(), model_of({block("bar", 1e6, 1e-3, 1e-3)}), few, 100'000);
  EXPECT_EQ(test::place_of(bar), "MESH_TOO_LARGE - nodes");
  EXPECT_THAT(bar.message, HasSubstr("which 1000 nodes come to, needs about"));
  const FeatureSource ring =
      feature("ring", "torus", {{"major_radius", 1e3}, {"minor_radius", 0.1}});
  EXPECT_EQ(refused(Revision::none(), model_of({ring}), few, 1500).reason, "MESH_TOO_LARGE");
}

TEST(NodeLimit, HoldsForWhatTheModelAsksForOnItsFaces) {
  // Even, the plate has some hundred nodes.
  ModelSource source = plate_of_length(80);
  MeshOptions options{.size = 8, .iterations = 1};
  options.sizing.even = false;
  const auto refusal = [&](double size) {
    source.sizes = {{"fine", "plate.top", size}};
    return error_of([&] { make_revision(Revision::none(), source, options, limited(2000)); });
  };
  for (const double size : {0.5, 0.01}) {
    const ErrorInfo info = refusal(size);
    EXPECT_EQ(info.reason, "MESH_TOO_LARGE") << size;
    EXPECT_THAT(info.message, HasSubstr("the edge lengths asked for need ")) << size;
    EXPECT_THAT(info.hint, HasSubstr("--max-nodes"));
  }
}

TEST(NodeLimit, NamesTheOptionWhereTheStartHasTooManyNodes) {
  MeshOptions options{.size = 8, .iterations = 1};
  options.sizing = {.even = false, .edges_per_circle = 24};
  const ErrorInfo info = error_of(
      [&] { make_revision(Revision::none(), plate_of_length(80), options, limited(700)); });
  EXPECT_EQ(test::place_of(info), "MESH_TOO_LARGE - size");
}

TEST(NodeLimit, LetsAnEditOfAMeshThatIsJustAtItPass) {
  const auto& original = base();
  EXPECT_NO_THROW(check_node_limit(original, evaluate(plate_of_length(80)), {}, limited(1000)));
  const Revision same = make_revision(original, plate_of_length(80), {}, limited(1000));
  EXPECT_EQ(same.report.strategy, MeshStrategy::Unchanged);
  EXPECT_EQ(refused(original, plate_of_length(81), {}, 1000).reason, "MESH_TOO_LARGE");
}

}  // namespace
}  // namespace remeshd

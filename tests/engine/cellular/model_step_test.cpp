// Models as STEP files, read back by a reader that knows nothing of the model.
#include "engine/cellular/model_step.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "engine/kernel/step/exchange_text.h"
#include "engine/kernel/step/step_file.h"
#include "tests/engine/cellular/simple_features.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using std::numbers::pi;
using test::arc;
using test::feature;
using test::kRun;
using test::point;
using testing::HasSubstr;

struct Written {
  CellularModel cells;
  std::string text;
  kernel::StepContent content;
};

ModelLabels labels_of(const std::string& name, const std::string& unit = "mm") {
  return {.name = name,
          .unit = unit,
          .file = "0123.step",
          .description = {"revision 0123"},
          .origin = "remeshd"};
}

Written write(const ModelSource& source, const kernel::LengthUnit& unit = {}) {
  const FeatureModel model = evaluate(source);
  Written out{build_cells(model, kRun), {}, {}};
  out.text = model_step(model, out.cells, labels_of(source.name, source.unit), kRun);
  out.content = kernel::read_step(out.text, unit, out.cells.scale, kRun);
  return out;
}

std::multiset<std::string> names_of(const kernel::StepContent& content) {
  std::multiset<std::string> names;
  for (const kernel::StepFace& face : content.faces) names.insert(face.name);
  return names;
}

std::multiset<std::string> names_of(const BoundaryModel& boundary, const FeatureModel& model) {
  std::multiset<std::string> names;
  for (const BoundaryFace& face : boundary.faces) {
    std::string name;
    for (const FaceName& one : face.names)
      name += (name.empty() ? "" : "+") + model.features[one.feature].id + "." + one.face;
    names.insert(name);
  }
  return names;
}

/// Volume, area, box and faces are the model's.
void expect_same(const Written& written, const ModelSource& source, const std::string& what) {
  const kernel::StepContent& content = written.content;
  const BoundaryModel& boundary = written.cells.boundary;
  EXPECT_EQ(content.solids, 1) << what;
  EXPECT_NEAR(content.volume, written.cells.volume, 2e-9 * written.cells.volume) << what;
  EXPECT_NEAR(content.area, written.cells.area, 2e-9 * written.cells.area) << what;
  EXPECT_EQ(names_of(content), names_of(boundary, evaluate(source))) << what;
  std::multiset<long> expected, areas;
  for (const BoundaryFace& face : boundary.faces)
    expected.insert(std::lround(1e5 * face.area / written.cells.area));
  for (const kernel::StepFace& face : content.faces)
    areas.insert(std::lround(1e5 * face.area / written.cells.area));
  EXPECT_EQ(areas, expected) << what;
  EXPECT_GE(content.edges, static_cast<int>(boundary.edges.size())) << what;
  EXPECT_LE(norm(content.box.lo - boundary.bounds.lo), 0.01 * boundary.bounds.diagonal()) << what;
  EXPECT_LE(norm(content.box.hi - boundary.bounds.hi), 0.01 * boundary.bounds.diagonal()) << what;
}

ModelSource named(ModelSource source, const std::string& name) {
  source.name = name;
  return source;
}

TEST(ModelStep, HoldsTheFacesEdgesAndVolumeOfTheSevenCases) {
  std::set<std::string> cases;
  for (const test::EditCase& edit : test::seven_cases()) {
    cases.insert(edit.original);
    cases.insert(edit.modified);
  }
  for (const std::string& name : cases) {
    const ModelSource source = test::case_model(name);
    const Written written = write(source);
    expect_same(written, source, name);
    EXPECT_EQ(written.content.shells, 1);
    // Where a seam ends on a curve of no kind, that is cut there.
    const int cut = name == "tool2-d" ? 1 : 0;
    EXPECT_EQ(written.content.edges, static_cast<int>(written.cells.boundary.edges.size()) + cut)
        << name;
  }
}

TEST(ModelStep, HoldsTheDetailedParts) {
  for (const std::string& name : test::detailed_parts()) {
    const ModelSource source = test::case_model("detailed/" + name);
    expect_same(write(source), source, name);
  }
}

TEST(ModelStep, HoldsRoundFeaturesWithTheirPolesApexesAndSeams) {
  std::vector<FeatureSource> features{
      feature("ball", "sphere", {{"radius", 3.0}}),
      feature("ring", "torus", {{"major_radius", 5.0}, {"minor_radius", 1.0}}),
      feature("tip", "cone", {{"radius_bottom", 3.0}, {"radius_top", 0.0}, {"height", 4.0}}),
      feature("stand", "cone", {{"radius_bottom", 0.0}, {"radius_top", 3.0}, {"height", 4.0}}),
      feature("can", "cylinder", {{"radius", 5.0}, {"height", 10.0}}),
      feature("track", "slot", {{"length", 5.0}, {"width", 2.0}, {"height", 3.0}}),
      // Arcs that end on the axis.
      feature("nose", "revolution", {point(0.0, 0.0), point(1.0, 0.0), arc(0.0, 3.0, 0.7, 1.8)},
              {}),
      feature("nut", "revolution", {point(0.0, 0.0), point(2.0, 0.0), arc(0.0, 2.0, 1.5, 2.2)}, {}),
      feature("half_lemon", "revolution", {point(0.0, -1.0), arc(0.0, 1.0, 0.5, 0.0)},
              {{"angle", 180.0}}),
      feature("half_apple", "revolution", {point(0.0, -1.0), arc(0.0, 1.0, 2.0, 0.0)},
              {{"angle", 180.0}}),
      feature("barrel", "revolution",
              {point(0.0, -1.0), point(1.0, -1.0), arc(1.0, 1.0, 1.2, 0.0), point(0.0, 1.0)}, {}),
      feature("quarter", "revolution",
              {point(1.0, 0.0), point(3.0, 0.0), arc(3.0, 2.0, 4.0, 1.0), point(1.0, 2.0)},
              {{"angle", 90.0}}),
      feature("jaws", "revolution",
              {point(0.0, 0.0), point(2.0, 0.5), point(2.0, 2.0), point(0.0, 2.0)},
              {{"angle", 300.0}})};
  for (FeatureSource& source : features) {
    source.placement.origin = {12.0, -7.0, 3.0};
    source.placement.z_axis = {1.0, 2.0, 2.0};
    const ModelSource model = named(test::one_feature(source), source.id);
    const Written written = write(model);
    expect_same(written, model, source.id);
    EXPECT_EQ(written.content.edges, static_cast<int>(written.cells.boundary.edges.size()))
        << source.id;
  }
}

TEST(ModelStep, IsRefusedForAFaceOfTwoPolesWithoutAnEdgeWhichDoesNotReadBack) {
  for (const double through : {0.5, 2.0}) {
    const ModelSource source = test::one_feature(
        feature("lemon", "revolution", {point(0.0, -1.0), arc(0.0, 1.0, through, 0.0)}, {}));
    const ErrorInfo info = test::error_of([&] { write(source); });
    EXPECT_EQ(info.reason, "KERNEL_FAILURE");
    EXPECT_THAT(info.message, HasSubstr("the STEP file reads back with volume"));
  }
}

TEST(ModelStep, HasAShellOfItsOwnForEachVoid) {
  FeatureSource bubble = minus(feature("bubble", "sphere", {{"radius", 1.0}}));
  bubble.placement.origin = {2.0, 0.0, 5.0};
  FeatureSource box = minus(test::block("box", 2, 2, 2));
  box.placement.origin = {-2.0, 0.0, 4.0};
  const ModelSource model =
      named(test::model_of({test::block("base", 10, 10, 10), bubble, box}), "hollow");
  const Written written = write(model);
  expect_same(written, model, "hollow");
  EXPECT_EQ(written.content.shells, 3);
  EXPECT_NEAR(written.content.volume, 1000 - 8 - 4 * pi / 3, 1e-6);
  EXPECT_THAT(written.text, HasSubstr("BREP_WITH_VOIDS('hollow'"));
}

TEST(ModelStep, NamesFacesAfterAllFeaturesFacesAndTheSolidAfterTheModel) {
  ModelSource model = named(test::model_of({test::block("left", 10, 10, 5),
                                            test::placed(test::block("right", 10, 10, 5), 8, 0, 0),
                                            minus(cylinder("hole", {0.0, 0.0, -1.0}, 2, 7))}),
                            "plate");
  const Written written = write(model);
  expect_same(written, model, "plate");
  const auto names = names_of(written.content);
  EXPECT_EQ(names.count("hole.wall"), 1u);
  EXPECT_EQ(names.count("right.top+left.top"), 1u);
  EXPECT_THAT(written.content.solid_names, testing::ElementsAre("plate"));
  EXPECT_THAT(written.text, HasSubstr("FILE_NAME('0123.step','1970-01-01T00:00:00',"));
  EXPECT_THAT(written.text, HasSubstr("FILE_DESCRIPTION(('revision 0123')"));
  EXPECT_THAT(written.text, HasSubstr("PRODUCT('plate','plate',"));
  EXPECT_THAT(written.text, HasSubstr("AUTOMOTIVE_DESIGN"));
}

TEST(ModelStep, KeepsTheRimsOfGroupsAsEdges) {
  ModelSource model =
      named(test::model_of({test::block("left", 10, 10, 5),
                            test::placed(test::block("right", 10, 10, 5), 8, 0, 0)}),
            "two");
  const Written plain = write(model);
  model.groups = {{"seat", "right.top", {}}};
  const Written grouped = write(model);
  expect_same(grouped, model, "grouped");
  EXPECT_EQ(plain.content.faces.size(), 6u);
  EXPECT_EQ(grouped.content.faces.size(), 7u);
}

TEST(ModelStep, TellsTheUnitOfTheModelAndMillimetresWhereItKnowsNone) {
  const auto text_in = [](const std::string& unit, const kernel::LengthUnit& read) {
    ModelSource model = test::one_feature(test::block("a", 0.1, 0.2, 0.3));
    model.unit = unit;
    const Written written = write(model, read);
    EXPECT_NEAR(written.content.volume, 0.006, 1e-12) << unit;
    return written.text;
  };
  EXPECT_THAT(text_in("mm", {"MM", 1}), HasSubstr("SI_UNIT(.MILLI.,.METRE.)"));
  EXPECT_THAT(text_in("m", {"M", 1000}), HasSubstr("SI_UNIT($,.METRE.)"));
  EXPECT_THAT(text_in("um", {"UM", 0.001}), HasSubstr("SI_UNIT(.MICRO.,.METRE.)"));
  EXPECT_THAT(text_in("in", {"INCH", 25.4}), HasSubstr("CONVERSION_BASED_UNIT('INCH'"));
  for (const char* other : {"", "furlong", "MM"})
    EXPECT_THAT(text_in(other, {}), HasSubstr("SI_UNIT(.MILLI.,.METRE.)")) << other;
}

TEST(ModelStep, HasCoordinatesToTheBitWhateverTheSize) {
  for (const double size : {1e-5, 0.3, 7.1e4}) {
    const ModelSource model =
        named(test::model_of({test::block("base", size, size, size),
                              minus(cylinder("hole", {0.0, 0.0, -size}, 0.2 * size, 3 * size))}),
              "sized");
    const Written written = write(model);
    expect_same(written, model, std::to_string(size));
  }
  EXPECT_THAT(write(test::one_feature(test::block("a", 0.2, 0.6, 0.7))).text,
              HasSubstr("CARTESIAN_POINT('',(-0.1,-0.3,0.7))"));
}

TEST(ModelStep, IsTheSameWhateverWasWrittenBefore) {
  const ModelSource valve = test::case_model("detailed/valve");
  const std::string before = write(valve).text;
  ModelSource inches = test::one_feature(test::block("a", 1, 2, 3));
  inches.unit = "inch";
  write(inches, {"INCH", 25.4});
  EXPECT_EQ(write(valve).text, before);
}

TEST(ModelStep, EndsWithAStopRequest) {
  std::stop_source stop;
  stop.request_stop();
  const remeshd::Run stopped{.stop = stop.get_token()};
  const FeatureModel model = test::case_features("tool1-a");
  const CellularModel cells = build_cells(model, kRun);
  const ErrorInfo info =
      test::error_of([&] { model_step(model, cells, labels_of("tool1-a"), stopped); });
  EXPECT_EQ(info.kind, ErrorKind::Cancelled);
}

TEST(ModelStep, IsRefusedWhereVolumeOrAreaAreNotTheModels) {
  const FeatureModel model = test::case_features("simple-a");
  for (const double wrong : {1 - 2e-6, 1 + 2e-6}) {
    CellularModel cells = build_cells(model, kRun);
    cells.volume *= wrong;
    const ErrorInfo info =
        test::error_of([&] { model_step(model, cells, labels_of("simple-a"), kRun); });
    EXPECT_EQ(info.reason, "KERNEL_FAILURE");
    EXPECT_THAT(info.message, HasSubstr("volume"));
  }
}

TEST(ExchangeText, HasOneLineAnEntityAndNoSuperfluousZeros) {
  EXPECT_EQ(kernel::tidy_exchange_text(
                "#1 = A(1.000000,\n   -0.5000,10,\n  1.500000E-10,2.);\n#2 = B();\n"),
            "#1 = A(1.,-0.5,10,1.5E-10,2.);\n#2 = B();\n");
}

TEST(ExchangeText, KeepsStringsAndSpellsWhatIsBeyondAscii) {
  EXPECT_EQ(kernel::tidy_exchange_text("A('it''s 1.500',\n  'long \nline;')"),
            "A('it''s 1.500','long line;')");
  EXPECT_EQ(kernel::tidy_exchange_text("A('Br\xC3\xBC"
                                       "cke \xF0\x9F\x94\xA9')"),
            R"(A('Br\X2\00FC\X0\cke \X4\0001F529\X0\'))");
  EXPECT_EQ(kernel::tidy_exchange_text("A('\xFF')"), "A('?')");
}

}  // namespace
}  // namespace remeshd

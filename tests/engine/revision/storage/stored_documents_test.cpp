#include "engine/revision/storage/stored_documents.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "tests/support/cases.h"

namespace remeshd {
namespace {

/// A revision of which there are documents alone.
Revision revision() {
  Revision r;
  r.source = r.meshed_source = test::model_of({test::block("plate", 8, 4, 1)});
  r.cells.parts = std::make_shared<const BoundaryParts>();
  r.delaunay_state = std::make_shared<const DelaunayState>();
  return r;
}

Revision read(const std::string& bytes) {
  Revision r;
  r.options.sizing = {.even = false, .layers = 9};  // whatever was there before
  read_documents(bytes, r);
  return r;
}

TEST(StoredDocuments, KeepTheSizing) {
  Revision r = revision();
  r.options.sizing = {
      .even = false, .edges_per_circle = 20, .layers = 3, .min_size = 0.25, .growth = 1.5};
  EXPECT_EQ(read(write_documents(r)).options, r.options);
  r.options.sizing = {.even = false};
  EXPECT_EQ(read(write_documents(r)).options, r.options) << "without a least size";
  r.options.sizing = {};
  EXPECT_EQ(read(write_documents(r)).options, r.options);
}

TEST(StoredDocuments, KeepByHowMuchTheRulesOfSizesAreWeakened) {
  Revision r = revision();
  r.rules_weakening = 1.25;
  Revision back;
  read_documents(write_documents(r), back);
  EXPECT_EQ(back.rules_weakening, 1.25);
}

TEST(StoredDocuments, KeepHowManyNodesADetailNeeds) {
  Revision r = revision();
  r.report.warnings = {{.code = WarningCode::Fallback, .message = "another"},
                       {.code = WarningCode::DetailNotResolved, .nodes_needed = 4440}};
  Revision back;
  read_documents(write_documents(r), back);
  ASSERT_EQ(back.report.warnings.size(), 2U);
  EXPECT_EQ(back.report.warnings[0].nodes_needed, 0U);
  EXPECT_EQ(back.report.warnings[1].nodes_needed, 4440U);
}

TEST(StoredDocuments, KeepPlacesWithADensityOfTheirOwn) {
  Revision r = revision();
  r.dense_places = {{.centre = {1, 2, 3}, .radius = 0.5, .size = 1},
                    {.centre = {4, 5, 6}, .size = 2}};
  Revision back;
  read_documents(write_documents(r), back);
  EXPECT_EQ(back.dense_places, r.dense_places);
}

TEST(StoredDocuments, KeepTheSizesOfEachModel) {
  Revision r = revision();
  r.source.sizes = {{"holes", "hole*.wall", "radius/4"},
                    {"spot", BallSource{1.0, "p", 0.1, 2.0}, 0.5}};
  r.meshed_source.sizes = {{"end", BoxSource{0.0, 0.0, 0.0, 1.0, 2.0, "q"}, 1.0}};
  Anchor anchor;
  anchor.source.sizes = {{"top", "plate.top", 2.0}};
  r.anchor = std::make_shared<const Anchor>(anchor);
  const std::string bytes = write_documents(r);
  EXPECT_EQ(read(bytes).source, r.source);
  EXPECT_EQ(read(bytes).meshed_source, r.meshed_source);
  Revision with_anchor;
  EXPECT_EQ(read_documents(bytes, with_anchor).anchor_source, anchor.source);
}

TEST(StoredDocuments, KeepTheGroupsOfEachModelAndWhatBecameOfThem) {
  Revision r = revision();
  r.source.groups = {{"load", "plate.top & z > 1", {.max_area_change = 0.2, .fail_emptied = true}},
                     {"rim", "plate.x_*", {}}};
  r.meshed_source.groups = {{"load", "plate.top", {}}};
  r.report.figures = {{.group = "plate.top", .state = GroupState::Resized},
                      {.group = "load",
                       .of_model = true,
                       .state = GroupState::Split,
                       .exact_area = 12.5,
                       .mesh_area = 12.25,
                       .centroid = {1, 2, 3},
                       .normal = {0, 0, 1},
                       .nodes = 5,
                       .facets = 6,
                       .tets = 7,
                       .parts = 2}};
  Anchor anchor;
  anchor.source.groups = {{"other", "plate", {}}};
  r.anchor = std::make_shared<const Anchor>(anchor);
  Revision back;
  EXPECT_EQ(read_documents(write_documents(r), back).anchor_source, anchor.source);
  EXPECT_EQ(back.source, r.source);
  EXPECT_EQ(back.meshed_source, r.meshed_source);
  ASSERT_EQ(back.report.figures.size(), 2U);
  EXPECT_FALSE(back.report.figures[0].exact_area);
  const GroupFigures& load = back.report.figures[1];
  EXPECT_EQ(load.group, "load");
  EXPECT_TRUE(load.of_model);
  EXPECT_EQ(load.state, GroupState::Split);
  EXPECT_EQ(load.exact_area, 12.5);
  EXPECT_EQ(load.mesh_area, 12.25);
  EXPECT_EQ(load.centroid, (Vec3{1, 2, 3}));
  EXPECT_EQ(load.normal, (Vec3{0, 0, 1}));
  EXPECT_EQ((std::array{load.nodes, load.facets, load.tets, load.parts}),
            (std::array{5U, 6U, 7U, 2U}));
}

TEST(StoredDocuments, OfBeforeThereWereSizesAreEven) {
  std::string bytes = write_documents(revision());
  ASSERT_EQ(bytes[1], 18);
  // Format 17 held no connectivity.
  bytes[1] = 17;
  bytes.resize(bytes.size() - sizeof(double));
  EXPECT_EQ(read(bytes).options.hold, 0);
  // Format 16 had no groups of the two models after it, and nothing of what became of them.
  bytes[1] = 16;
  bytes.resize(bytes.size() - 3 * sizeof(std::uint64_t));
  EXPECT_EQ(read(bytes).source, revision().source);
  // Format 15 had no order after it, and nothing of mid-nodes: an id and two counts.
  bytes[1] = 15;
  bytes.resize(bytes.size() - 3 * sizeof(std::uint32_t) - sizeof(std::uint64_t));
  EXPECT_EQ(read(bytes).options.order, 1U);
  // Format 14 had no sizes of the two models after it, none here.
  bytes[1] = 14;
  bytes.resize(bytes.size() - 2 * sizeof(std::uint64_t));
  EXPECT_EQ(read(bytes).source, revision().source);
  // Format 13 had no sizing before them: a switch, two counts, no least size, two factors;
  // nor an empty list.
  bytes[1] = 13;
  bytes.resize(bytes.size() - 2 - 2 * sizeof(std::uint32_t) - 2 * sizeof(double) -
               sizeof(std::uint64_t));
  const Revision r = read(bytes);
  EXPECT_EQ(r.source, revision().source);
  EXPECT_EQ(r.options.sizing, Sizing{.even = true});
}

}  // namespace
}  // namespace remeshd

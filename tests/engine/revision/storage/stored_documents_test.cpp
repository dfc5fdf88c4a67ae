#include "engine/revision/storage/stored_documents.h"

#include <gtest/gtest.h>

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

TEST(StoredDocuments, OfBeforeThereWereSizesAreEven) {
  std::string bytes = write_documents(revision());
  ASSERT_EQ(bytes[1], 14);
  // Format 13 had no sizing at its end: a switch, two counts, no least size, two factors;
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

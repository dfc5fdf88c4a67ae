#include "engine/revision/storage/memory_use.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

std::size_t bytes_of(const Revision& revision) {
  std::size_t bytes = 0;
  for (const MemoryBlock& block : memory_blocks(revision)) bytes += block.bytes;
  return bytes;
}

/// What a revision has that another has not.
std::size_t own_bytes(const Revision& revision, const Revision& other) {
  std::set<const void*> shared;
  for (const MemoryBlock& block : memory_blocks(other)) shared.insert(block.address);
  std::size_t bytes = 0;
  for (const MemoryBlock& block : memory_blocks(revision))
    if (!shared.contains(block.address)) bytes += block.bytes;
  return bytes;
}

TEST(MemoryBlocks, AreCountedOnce) {
  const Revision r = make_revision(Revision::none(), test::case_model("simple-a"),
                                   {.nodes = 2000, .iterations = 1}, kRun);
  std::set<const void*> seen;
  for (const MemoryBlock& block : memory_blocks(r)) EXPECT_TRUE(seen.insert(block.address).second);
  const double nodes = r.report.counts.nodes;
  EXPECT_GT(bytes_of(r), 300 * nodes);
  EXPECT_LT(bytes_of(r), 700 * nodes);
}

TEST(MemoryBlocks, OfAChildAreItsParentsWhereNothingChanged) {
  const auto pin = [](double radius) {
    return ModelEdit{{SetFeatureParameter{"pin1", "radius", radius}}};
  };
  const Revision first = make_revision(Revision::none(), test::case_model("tool1-a"),
                                       {.nodes = 15000, .iterations = 5}, kRun);
  const Revision child = make_revision(first, apply(first.source, pin(4.5)), {}, kRun);
  const Revision grandchild = make_revision(child, apply(child.source, pin(4.2)), {}, kRun);
  ASSERT_EQ(grandchild.report.strategy, MeshStrategy::Local);
  // Of the first edit all maps are its own.
  EXPECT_LT(own_bytes(child, first), bytes_of(child) / 3);
  EXPECT_LT(own_bytes(grandchild, child), bytes_of(grandchild) / 4);
}

TEST(MemoryBlocks, OfTheSameGeometryAreAllShared) {
  const Revision first = make_revision(Revision::none(), test::case_model("simple-a"),
                                       {.nodes = 2000, .iterations = 1}, kRun);
  const Revision child = make_revision(first, first.source, {}, kRun);
  ASSERT_EQ(child.report.strategy, MeshStrategy::Unchanged);
  const Revision grandchild = make_revision(child, first.source, {}, kRun);
  // But for facets, which have an array of their own.
  const std::size_t facets = grandchild.output.groups.facets.capacity() * sizeof(MeshFacet);
  EXPECT_EQ(own_bytes(grandchild, child), facets);
}

TEST(MemoryBlocks, OfASizeFieldAreItsOwn) {
  MeshOptions options{.nodes = 1000, .iterations = 1};
  options.sizing.even = false;
  Revision r = make_revision(Revision::none(), test::case_model("tool1-a"), options, kRun);
  const std::size_t bytes = bytes_of(r);
  EXPECT_GT(r.sizes->bytes(), 1000U);
  const std::size_t field = r.sizes->bytes();
  r.sizes.reset();
  EXPECT_EQ(bytes - bytes_of(r), field);
}

}  // namespace
}  // namespace remeshd

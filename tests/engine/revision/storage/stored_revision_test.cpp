#include "engine/revision/storage/stored_revision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <set>

#include "engine/base/error.h"
#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/remesh/remesh.h"
#include "engine/revision/delaunay_state.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using test::kRun;

Revision first() {
  return make_revision(Revision::none(), test::case_model("tool1-a"), {.nodes = 600}, kRun);
}
Revision edited(const Revision& base, double radius) {
  ModelSource source = base.source;
  test::parameter(source, "pin_radius") = radius;
  return make_revision(base, source, {}, kRun);
}

std::size_t shared_pieces(const StoredArrays& a, const StoredArrays& b) {
  std::set<const void*> of_a;
  for (const StoredArray& array : a.arrays)
    if (!array.owned)
      for (const std::string_view piece : array.pieces) of_a.insert(piece.data());
  std::size_t shared = 0;
  for (const StoredArray& array : b.arrays)
    for (const std::string_view piece : array.pieces) shared += of_a.contains(piece.data());
  return shared;
}

TEST(Image, NamesAndTypesEveryArrayOnce) {
  const Revision revision = first();
  const StoredArrays image = image_of(revision);
  std::set<std::string> names;
  for (const StoredArray& array : image.arrays) {
    EXPECT_TRUE(names.insert(array.name).second) << array.name;
    EXPECT_EQ(array.size() % (bytes_of(array.type) * array.components), 0U) << array.name;
  }
  const StoredArray* nodes = image.find("delivery.nodes");
  ASSERT_NE(nodes, nullptr);
  EXPECT_EQ(nodes->type, StoredType::F64);
  EXPECT_EQ(nodes->components, 3U);
  EXPECT_EQ(nodes->size(), 24 * revision.output.mesh.nodes.size());
  EXPECT_EQ(image.find("no such array"), nullptr);
}

TEST(Image, EqualRevisionsGiveEqualBytesWhateverTheirSeconds) {
  const Revision base = first();
  const Revision a = edited(base, 4.5), b = edited(base, 4.5);
  EXPECT_NE(a.report.seconds.total, b.report.seconds.total);
  EXPECT_TRUE(test::stored_bytes(a) == test::stored_bytes(b));
}

TEST(Image, ARevisionThatIsLoadedSharesMemoryWithTheOneThatIsAlike) {
  const Revision base = first();
  const Revision edit = edited(base, 4.1);
  const Revision loaded = test::stored_and_loaded(edit, &base);
  EXPECT_TRUE(test::stored_bytes(loaded) == test::stored_bytes(edit));
  const StoredArrays of_base = image_of(base);
  EXPECT_GE(shared_pieces(of_base, image_of(loaded)), shared_pieces(of_base, image_of(edit)));
}

TEST(Image, ZerosOfBothSignsAreNotTheSame) {
  const std::vector<double> plus(8, 0.0), minus(8, -0.0);
  const CowVector<double> other(plus);
  const CowVector<double> shared{std::span<const double>(minus), other};
  EXPECT_TRUE(std::signbit(shared[0]));
}

TEST(Image, AMissingArrayOrOneOfAnotherTypeIsAnError) {
  const Revision revision = first();
  const StoredArrays whole = test::copied(image_of(revision));
  for (std::size_t i = 0; i < whole.arrays.size(); ++i) {
    StoredArrays image = whole;
    image.arrays.erase(image.arrays.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_THROW(revision_of(image, nullptr, kRun), Error) << whole.arrays[i].name;
    image = whole;
    image.arrays[i].components += 1;
    EXPECT_THROW(revision_of(image, nullptr, kRun), Error) << whole.arrays[i].name;
  }
  EXPECT_THROW(revision_of({}, nullptr, kRun), Error);
}

TEST(Image, NoIndexBeyondAnArrayIsLetPass) {
  const Revision revision = first();
  const StoredArrays whole = test::copied(image_of(revision));
  for (std::size_t i = 0; i < whole.arrays.size(); ++i) {
    const StoredArray& array = whole.arrays[i];
    if (array.type != StoredType::I32 || array.size() == 0) continue;
    if (array.name == "delivery.original_nodes" || array.name == "delivery.original_tets")
      continue;  // of the parent
    std::string bytes = array.flat();
    const std::int32_t far = 1 << 30;
    std::memcpy(bytes.data() + bytes.size() - 4, &far, 4);
    StoredArrays image = whole;
    image.arrays[i].own(bytes);
    EXPECT_THROW(revision_of(image, nullptr, kRun), Error) << array.name;
  }
}

/// What is thrown for the image of a revision whose boundary was changed.
template <typename Change>
std::string fault_of_boundary(const Revision& revision, const Change& change) {
  auto parts = std::make_shared<BoundaryParts>(*revision.cells.parts);
  change(*parts);
  Revision changed = revision;
  changed.cells.parts = parts;
  try {
    revision_of(test::copied(image_of(changed)), nullptr, kRun);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(Image, NoIndexIntoTheBoundaryBeyondItIsLetPass) {
  const Revision revision = first();
  const auto fault = [&](const auto& change) { return fault_of_boundary(revision, change); };
  const int far = 1 << 20;
  EXPECT_EQ(fault([](BoundaryParts&) {}), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.faces[0].triangles[0][1] = far; }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.faces[0].edges[0] = far; }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.edges[0].vertices[1] = -1; }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.edges[0].chain[0] = far; }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.edges[0].points.clear(); }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.points.clear(); }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.vertices[0].position.x = HUGE_VAL; }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.edges[0].centre.y = HUGE_VAL; }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.edges[0].axis.z = HUGE_VAL; }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.edges[0].radius = HUGE_VAL; }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.brep.edges[0].length = HUGE_VAL; }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.pieces.pop_back(); }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.pieces[0].other_names.push_back({far, "x"}); }), "");
  EXPECT_NE(fault([&](BoundaryParts& p) { p.pieces[0].surface.kind = Surface::Kind{9}; }), "");
}

TEST(Image, AGroupOfFacetsWithoutAFaceIsAnError) {
  Revision revision = first();
  revision.output.groups.facet_groups.front().clear();
  EXPECT_THROW(revision_of(test::copied(image_of(revision)), nullptr, kRun), Error);
}

TEST(Image, NodesNowhereAreAnError) {
  const StoredArrays whole = test::copied(image_of(first()));
  for (const char* name : {"delivery.nodes", "delaunay.points"})
    for (const double x : {std::nan(""), HUGE_VAL, 1e200}) {
      StoredArrays image = whole;
      const auto nodes = std::ranges::find(image.arrays, name, &StoredArray::name);
      ASSERT_NE(nodes, image.arrays.end());
      std::string bytes = nodes->flat();
      std::memcpy(bytes.data() + 8, &x, sizeof x);
      nodes->own(bytes);
      EXPECT_THROW(revision_of(image, nullptr, kRun), Error) << name << " " << x;
    }
}

TEST(Image, TetsThatAreNotEachOthersNeighboursAreAnError) {
  const StoredArrays whole = test::copied(image_of(first()));
  StoredArrays image = whole;
  const auto slots = std::ranges::find(image.arrays, "delaunay.slots", &StoredArray::name);
  ASSERT_NE(slots, image.arrays.end());
  std::string bytes = slots->flat();
  // The first tet's first neighbour, behind its four vertices, becomes its second one.
  std::memcpy(bytes.data() + 16, bytes.data() + 20, 4);
  slots->own(bytes);
  EXPECT_THROW(revision_of(image, nullptr, kRun), Error);
}

TEST(Image, ArraysThatAreCutOffAreAnError) {
  const Revision revision = first();
  const StoredArrays whole = test::copied(image_of(revision));
  for (std::size_t i = 0; i < whole.arrays.size(); ++i) {
    const StoredArray& array = whole.arrays[i];
    if (array.size() == 0) continue;
    const std::size_t row =
        array.name == "documents" ? array.size() / 2 : bytes_of(array.type) * array.components;
    StoredArrays image = whole;
    image.arrays[i].own(array.flat().substr(0, array.size() - row));
    EXPECT_THROW(revision_of(image, nullptr, kRun), Error) << array.name;
  }
}

}  // namespace
}  // namespace remeshd

#include "engine/local_fuse/sewing/replace_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/cellular/cellular_model.h"
#include "tests/support/local_fuse.h"
#include "tests/support/run.h"
#include "tests/support/same_boundary.h"

namespace remeshd {
namespace {

using test::kRun;

using kernel::Brep;
using kernel::BrepEdge;
using kernel::BrepFace;
using test::block;
using test::cylinder;
using test::difference_of;
using test::model_of;
using test::placed;
using test::reason_of;

/// What there is of an edit when parts of its base are to be replaced; each can be spoilt.
struct Replacement {
  FeatureModel before, model;
  Membership membership{model};
  BoundaryParts base;
  Changes changes;
  TouchedParts touched;
  FusedPrisms fused;

  Replacement(const ModelSource& from, const ModelSource& to)
      : before(evaluate(from)),
        model(evaluate(to)),
        base(*build_cells(before, kRun).parts),
        changes(find_changes(before, model, membership)),
        touched(base, changes.boxes),
        fused(fuse(test::all_of(model))) {}

  FusedPrisms fuse(const std::vector<int>& features) const {
    FuseFrame frame = fuse_frame(membership);
    frame.reference = base.brep.reference;
    return *fuse_parallel_prisms(model, membership, features, frame);
  }
  Tried<BoundaryParts> parts() const {
    return replace_parts(base, changes, fused, touched, membership);
  }
  std::string reason() const { return reason_of(parts()); }

  int index_of(const BoundaryParts& parts, const std::string& face) const {
    const auto at = std::ranges::find_if(parts.pieces, [&](const BoundaryPiece& piece) {
      const FaceName& name = piece.material_names.front();
      return model.features[name.feature].id + "." + std::string(name.face) == face;
    });
    return static_cast<int>(at - parts.pieces.begin());
  }
  BrepFace& base_face(const std::string& name) { return base.brep.faces.at(index_of(base, name)); }
  BrepFace& fused_face(const std::string& name) {
    return fused.parts.brep.faces.at(index_of(fused.parts, name));
  }
};

void turn_over(BrepFace& face) {
  for (auto& triangle : face.triangles) std::swap(triangle[1], triangle[2]);
}

/// The edge of a B-rep with this point in the middle between its ends.
int edge_at(const Brep& brep, const Vec3& middle) {
  const auto at = std::ranges::find_if(brep.edges, [&](const BrepEdge& edge) {
    return distance(0.5 * (edge.points.front() + edge.points.back()), middle) < 1e-9;
  });
  return static_cast<int>(at - brep.edges.begin());
}

/// A plate of 20 x 20 x 2 with a block across the middle of its right side, from z = 1 up, that
/// gets higher. Behind and before it, and to the left, all stays.
Replacement higher_step() {
  const auto with = [](double height) {
    return model_of({block("plate", 20, 20, 2), placed(block("step", 4, 4, height), 10, 0, 1)});
  };
  return {with(4), with(5)};
}

/// A pin on a plate whose top is in a cap, which gets higher: the pin's wall is new above, and its
/// lower end stays.
Replacement higher_cap() {
  const auto with = [](double height) {
    return model_of({block("plate", 20, 20, 2), placed(cylinder("pin", 3, 10), 0, 0, 1),
                     placed(block("cap", 8, 8, height), 0, 0, 10)});
  };
  return {with(3), with(4)};
}

TEST(ReplaceParts, GivesTheBoundaryOfTheEditedModel) {
  for (const Replacement& edit : {higher_step(), higher_cap()}) {
    const auto parts = edit.parts();
    ASSERT_EQ(reason_of(parts), "");
    EXPECT_EQ(difference_of(build_cells(edit.model, kRun), restore_cells(edit.model, *parts)), "");
  }
}

TEST(ReplaceParts, KeepsEdgesThatNothingTouchedToTheBit) {
  const Replacement edit = higher_cap();
  const BoundaryParts parts = *edit.parts();
  int kept = 0;
  for (std::size_t e = 0; e < edit.base.brep.edges.size(); ++e) {
    if (edit.touched.edges[e]) continue;
    ++kept;
    const auto& points = edit.base.brep.edges[e].points;
    EXPECT_TRUE(std::ranges::any_of(parts.brep.edges, [&](const BrepEdge& other) {
      return other.points == points;
    })) << e;
  }
  EXPECT_EQ(kept, 13) << "twelve of the plate, and the circle where the pin stands on it";
}

TEST(ReplaceParts, AVertexThatIsNearTwoOfTheBaseIsGivenUp) {
  Replacement edit = higher_step();
  Brep& brep = edit.base.brep;
  ASSERT_EQ(brep.points.size(), brep.vertices.size());
  // An end of a side that the step is on is the end of two edges that stay: one of them gets
  // another vertex there.
  const Vec3 corner{10, -10, 2};
  BrepEdge& upright = brep.edges.at(edge_at(brep, {10, -10, 1}));
  for (int& v : upright.vertices)
    if (distance(brep.vertices[v].position, corner) < 1e-9)
      v = static_cast<int>(brep.vertices.size());
  brep.vertices.push_back({corner});
  brep.points.push_back(corner);
  EXPECT_EQ(edit.reason(), "replace_parts: a vertex of the fuse is near two of the base");
}

TEST(ReplaceParts, FacesHaveToMeetAlongEdgesInOppositeDirections) {
  Replacement edit = higher_step();
  // Beside the top of the plate, which is made anew; itself it stays.
  turn_over(edit.base_face("plate.y_min"));
  EXPECT_EQ(edit.reason(),
            "replace_parts: two faces do not go along their edge in opposite directions");
}

TEST(ReplaceParts, TwoFacesHaveToMeetAtEveryEdge) {
  Replacement less = higher_step(), more = higher_step();
  const std::string reason = "replace_parts: an edge bounds one face or more than two";
  less.base_face("plate.y_min").edges.pop_back();
  EXPECT_EQ(less.reason(), reason);
  more.base_face("plate.y_min").edges.push_back(edge_at(more.base.brep, {0, 10, 0}));
  EXPECT_EQ(more.reason(), reason);
}

TEST(ReplaceParts, AFaceThatStaysHasEdgesThatStayAndAFeatureThatDoes) {
  Replacement edit = higher_step();
  edit.touched.faces[edit.index_of(edit.base, "plate.top")] = 0;
  EXPECT_EQ(edit.reason(), "replace_parts: a kept face has an edge that the change meets");
  edit = higher_step();
  edit.changes.kept[0] = -1;
  EXPECT_EQ(edit.reason(), "replace_parts: a kept face is one of a changed feature");
  std::ranges::fill(edit.touched.faces, 1);
  EXPECT_EQ(edit.reason(), "replace_parts: a plane face of a changed feature has a kept edge");
}

TEST(ReplaceParts, ARoundFaceHasToEndWhereItDidInTheBase) {
  const std::string reason =
      "replace_parts: an edge of a round face is in the fuse but not in the base";
  Replacement edit = higher_cap();
  edit.fused = edit.fuse({1, 2});  // without the plate, which hides the pin's lower end
  EXPECT_EQ(edit.reason(), reason);
  edit = higher_cap();
  Brep& brep = edit.base.brep;
  const auto circle = std::ranges::find_if(brep.edges, [](const BrepEdge& edge) {
    return edge.kind == BrepEdge::Kind::Circle && edge.centre.z < 3;
  });
  brep.points[circle->chain[5]].z += 1e-4;
  EXPECT_EQ(edit.reason(), reason) << "another polyline";
}

TEST(ReplaceParts, EachNewFaceHasMaterialOnItsInnerSideOnly) {
  Replacement edit = higher_cap();
  turn_over(edit.fused_face("pin.wall"));
  EXPECT_EQ(edit.reason(),
            "replace_parts: a round face does not have material on its inner side only");
  edit = higher_cap();
  char& along = edit.fused.along[edit.index_of(edit.fused.parts, "cap.top")];
  along = along != 0 ? 0 : 1;
  EXPECT_EQ(edit.reason(),
            "replace_parts: a plane face does not have material on its inner side only");
}

TEST(ReplaceParts, WhyAPlaneFaceCannotBeMadeIsPassedOn) {
  Replacement edit = higher_step();
  edit.fused_face("step.top").edges.pop_back();
  EXPECT_EQ(edit.reason(), "plane_face: the border does not close, or crosses or touches itself");
}

TEST(ReplaceParts, MaterialInTwoPiecesIsGivenUpAndACavityIsNone) {
  const auto plate_with = [](const FeatureSource& f) {
    return model_of({block("plate", 20, 20, 6), f});
  };
  const FeatureSource boss = block("boss", 4, 4, 4);
  const auto boss_at = [&](double z) { return plate_with(placed(boss, 0, 0, z)); };
  EXPECT_EQ(Replacement(boss_at(5), boss_at(6)).reason(), "");
  EXPECT_EQ(Replacement(boss_at(5), boss_at(7)).reason(),
            "replace_parts: the material is not in one piece");
  const auto hole_at = [&](double z) {
    return plate_with(placed(boss, 0, 0, z, Nature::Subtractive));
  };
  EXPECT_EQ(Replacement(hole_at(4), hole_at(1)).reason(), "");
}

}  // namespace
}  // namespace remeshd

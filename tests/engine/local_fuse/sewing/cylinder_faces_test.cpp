#include "engine/local_fuse/sewing/cylinder_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/kernel/curve_points.h"
#include "tests/support/local_fuse.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::BrepEdge;

constexpr double kPi = std::numbers::pi;

/// The border of a cylinder of radius 2 about z, from z = 0 up to z = 3 + slope x, open at a seam.
struct Tube {
  Brep brep;

  explicit Tube(double slope) {
    brep.reference = {1, -2, 5};
    for (const double top : {0.0, 1.0}) {
      const auto at = [&](double t) {
        const double c = 2 * std::cos(t), s = 2 * std::sin(t);
        return kernel::CurvePoint{{c, s, top * (3 + slope * c)}, {-s, c, -top * slope * s}};
      };
      const int seam = static_cast<int>(brep.points.size());
      BrepEdge edge;
      edge.kind = BrepEdge::Kind::Other;
      for (int i = 0; i < 60; ++i) {
        edge.chain.push_back(static_cast<int>(brep.points.size()));
        brep.points.push_back(at(2 * kPi * i / 60).p);
      }
      edge.chain.push_back(seam);
      edge.samples = kernel::integration_samples(at, 0, 2 * kPi, 60);
      brep.edges.push_back(edge);
    }
    BrepEdge seam;
    seam.kind = BrepEdge::Kind::Line;
    seam.chain = {0, 60};
    brep.edges.push_back(seam);
  }
};

TEST(WallFacesTest, ATubeThatIsCutOffAskewHasItsMeanHeight) {
  const Surface cylinder{Surface::Kind::Cylinder, {}, 2, 0};
  for (const double slope : {0.0, 0.7}) {
    const Tube tube(slope);
    const std::vector<CylinderUse> uses{{0}, {1}, {2, true}, {2, false}};
    const auto faces = cylinder_faces(tube.brep, uses, cylinder, 0);
    ASSERT_TRUE(faces);
    ASSERT_EQ(faces->size(), 1U);
    const kernel::BrepFace& face = faces->front();
    EXPECT_EQ(face.edges, (std::vector{0, 1, 2, 2}));
    EXPECT_EQ(face.triangles.size(), 120U);
    EXPECT_NEAR(face.area, 4 * kPi * 3, 1e-9);
    EXPECT_NEAR(face.centroid.x, 2 * slope / 3, 1e-9);
    EXPECT_NEAR(face.centroid.y, 0, 1e-9);
    EXPECT_NEAR(face.centroid.z, (9 + 2 * slope * slope) / 6, 1e-9);
    // Pyramids from the reference: radius times area, less what the reference is off the axis.
    EXPECT_NEAR(face.swept_volume, (2 * face.area - 4 * kPi * slope) / 3, 1e-9);
  }
}

TEST(WallFacesTest, ABorderThatDoesNotCloseHasNoFaces) {
  const Surface cylinder{Surface::Kind::Cylinder, {}, 2, 0};
  const std::vector<CylinderUse> uses{{0}, {2, true}, {2, false}};
  EXPECT_EQ(test::reason_of(cylinder_faces(Tube(0).brep, uses, cylinder, 0)),
            "plane_face: the border does not close, or crosses or touches itself");
}

}  // namespace
}  // namespace remeshd

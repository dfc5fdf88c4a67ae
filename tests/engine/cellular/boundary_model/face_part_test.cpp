#include "engine/cellular/boundary_model/face_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

const BoundaryFace& face_named(const CellularModel& cells, const std::string& name) {
  for (const BoundaryFace& face : cells.boundary.faces)
    if (face.names.front().face == name) return face;
  throw std::out_of_range(name);
}

/// Area of the triangles of the part of a face where a condition holds.
double area_of_part(const FeatureModel& model, const std::string& face,
                    const std::string& condition, double length) {
  const CellularModel cells = build_cells(model, kRun);
  double area = 0;
  for (const auto& t : part_where(face_named(cells, face), {condition, {}}, length, kRun))
    area += 0.5 * norm(cross(t[1] - t[0], t[2] - t[0]));
  return area;
}

FeatureModel plate() { return evaluate(test::model_of({test::block("plate", 60, 40, 8)})); }
FeatureModel pin() { return evaluate(test::model_of({test::cylinder("pin", 5, 20)})); }

TEST(FacePart, OfAPlaneIsAsLargeAsWhatTheConditionCutsOff) {
  EXPECT_NEAR(area_of_part(plate(), "top", "x > 7.3", 0.2), 22.7 * 40, 0.2 * 40);
  EXPECT_NEAR(area_of_part(plate(), "top", "x*x + y*y < 100", 0.2), 100 * M_PI, 0.2 * 20 * M_PI);
  EXPECT_NEAR(area_of_part(plate(), "top", "nz > 0.5", 1), 2400, 1e-9);
  EXPECT_EQ(area_of_part(plate(), "top", "nz < 0.5", 1), 0);
  EXPECT_EQ(area_of_part(plate(), "top", "z > 50", 1), 0);
}

TEST(FacePart, OfACurvedFaceLiesOnIt) {
  EXPECT_NEAR(area_of_part(pin(), "wall", "nx > 0.5", 0.1), 5 * 20 * 2 * M_PI / 3, 6);
  const CellularModel cells = build_cells(pin(), kRun);
  for (const auto& t : part_where(face_named(cells, "wall"), {"z > 12", {}}, 0.1, kRun))
    for (const Vec3& p : t) {
      EXPECT_NEAR(std::hypot(p.x, p.y), 5, 1e-6);
      EXPECT_GT(p.z, 12 - 0.2);
    }
}

TEST(FacePart, IsNothingWhereTheConditionHasNoValue) {
  EXPECT_EQ(area_of_part(plate(), "top", "sqrt(-1 - x*x) < 5", 1), 0);
  EXPECT_NEAR(area_of_part(plate(), "top", "sqrt(x) >= 0", 0.2), 1200, 10);
}

/// By quadrature, where margins cannot be told.
double measured(const FeatureModel& model, const std::string& face,
                const std::function<bool(const Vec3&, const Vec3&)>& holds) {
  const CellularModel cells = build_cells(model, kRun);
  const PlaceTest untold = [&](const Vec3& p, const Vec3& normal) {
    return Held{holds(p, normal), std::nan("")};
  };
  return area_where(face_named(cells, face), untold, kRun);
}

/// By quadrature, with the margins of a condition; `tested` counts the places.
double measured_where(const FeatureModel& model, const std::string& face,
                      const std::string& condition, int* tested = nullptr) {
  const CellularModel cells = build_cells(model, kRun);
  ConditionTest test({condition, {}});
  const PlaceTest holds = [&](const Vec3& p, const Vec3& normal) {
    if (tested != nullptr) ++*tested;
    return Held{test(p, normal), test.margin(p, normal)};
  };
  return area_where(face_named(cells, face), holds, kRun);
}

TEST(AreaWhere, FindsPartsHoweverNarrow) {
  for (const double half : {1.0, 0.15, 0.01, 0.001}) {
    SCOPED_TRACE(half);
    const std::string strip = "abs(x + 17.3) < " + std::to_string(half);
    int tested = 0;
    EXPECT_NEAR(measured_where(plate(), "top", strip, &tested), 80 * half, 0.02 * 80 * half);
    EXPECT_NEAR(measured_where(plate(), "top", strip + " && y > 5 && y < 15"), 20 * half,
                0.02 * 20 * half);
    EXPECT_LT(tested, 1'000'000);
  }
  for (const double r : {5.0, 0.6, 0.05})
    EXPECT_NEAR(
        measured_where(plate(), "top", "(x-7.1)^2 + (y+3.3)^2 < " + std::to_string(r) + "^2"),
        M_PI * r * r, 5e-3 * M_PI * r * r)
        << r;
}

TEST(AreaWhere, IsAllOrNothingWhereMarginsAreTheSameEverywhere) {
  int tested = 0;
  EXPECT_NEAR(measured_where(plate(), "top", "z >= 8", &tested), 2400, 1e-9);
  EXPECT_EQ(measured_where(plate(), "top", "z > 8", &tested), 0);
  EXPECT_NEAR(measured_where(plate(), "top", "nz > 0.5", &tested), 2400, 1e-9);
  EXPECT_LT(tested, 100'000);
}

TEST(AreaWhere, OfAChoiceIsFoundWithoutMargins) {
  EXPECT_NEAR(measured_where(plate(), "top", "x > 0 ? y > 0 : y > 10"), 30 * 20 + 30 * 10, 1);
}

TEST(AreaWhere, OfAPlaneIsExactForStraightBorders) {
  EXPECT_NEAR(measured(plate(), "top", [](auto& p, auto&) { return p.x > 7.3; }), 22.7 * 40, 1e-3);
  EXPECT_NEAR(measured(plate(), "top", [](auto& p, auto&) { return p.x + p.y > 10; }), 800, 1e-3);
  EXPECT_NEAR(measured(plate(), "top", [](auto&, auto& n) { return n.z > 0.5; }), 2400, 1e-9);
  EXPECT_EQ(measured(plate(), "top", [](auto& p, auto&) { return p.z > 50; }), 0);
}

TEST(AreaWhere, IsNearlyExactForRoundOnes) {
  EXPECT_NEAR(measured(plate(), "top", [](auto& p, auto&) { return p.x * p.x + p.y * p.y < 100; }),
              100 * M_PI, 1e-4 * 100 * M_PI);
}

TEST(AreaWhere, OfACurvedFaceIsItsOwnNotThatOfChords) {
  EXPECT_NEAR(measured(pin(), "wall", [](auto& p, auto&) { return p.z > 12; }), 80 * M_PI, 1e-2);
  EXPECT_NEAR(measured(pin(), "wall", [](auto&, auto& n) { return n.x > 0.5; }),
              5 * 20 * 2 * M_PI / 3, 2e-2);
}

}  // namespace
}  // namespace remeshd

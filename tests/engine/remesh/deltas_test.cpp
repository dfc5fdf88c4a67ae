#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/stopwatch.h"
#include "engine/kernel/brep.h"
#include "engine/model/solid.h"
#include "engine/remesh/density.h"
#include "engine/remesh/remesh.h"
#include "engine/verify/verify.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"
#include "tests/support/strategy_name.h"

/// Deltas from rounding to the model's size on every number that the models of the seven cases
/// hold: one for each in every run of the tests, all of them with REMESHD_DELTAS=all (README.md).
namespace remeshd {
namespace {

using test::kRun;

constexpr MeshOptions kOfDeltas{.nodes = 2000};
/// x edge length; two more stand for these: a thousandth of the motion that is none, and the
/// diagonal.
constexpr std::array kDeltas{1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 5e-3, 0.009,
                             0.03, 0.1,  0.3,  1.0,  3.0,  10.0};
constexpr std::size_t kSizes = kDeltas.size() + 2;
constexpr double kNone = 1e-12;     // of the diagonal: a motion that is none
constexpr double kSmallest = 0.01;  // x edge length: surface motion below which meshes continue
constexpr double kNearly = 0.99;    // of it, where rounding decides nothing
constexpr double kFollowed = 0.05;  // x edge length: hidden surfaces that move this far may end it
constexpr double kCoincident = 5e-7;  // of the CAD kernel's unit: faces this near it takes for one
constexpr double kRadius = 3;         // x edge length: from moved surfaces to nodes that may move
constexpr double kLeverage = 5;       // node motion over surface motion
constexpr double kFilm = 0.3;         // x edge length: a change of topology below is thin
constexpr double kAngle = 25, kLargestAngle = 145, kMeasure = 0.42;  // goals of quality

/// A number of a document.
struct Literal {
  std::string name;  ///< `hole1.radius`, `stiffener.profile[2].x`
  Scalar* value;
};

std::vector<Literal> literals(ModelSource& model) {
  std::vector<Literal> all;
  const auto add = [&](const std::string& name, Scalar& value) {
    if (std::holds_alternative<double>(value)) all.push_back({name, &value});
  };
  const auto add_vector = [&](const std::string& name, std::array<Scalar, 3>& v) {
    for (int k = 0; k < 3; ++k) add(name + "[" + std::to_string(k) + "]", v[k]);
  };
  for (ParameterSource& p : model.parameters) add(p.name, p.value);
  for (FeatureSource& f : model.features) {
    for (auto& [name, value] : f.parameters) add(f.id + "." + name, value);
    if (f.profile)
      for (std::size_t k = 0; k < f.profile->size(); ++k) {
        ProfileEntry& entry = (*f.profile)[k];
        const std::string place = f.id + ".profile[" + std::to_string(k) + "]";
        add(place + ".x", entry.x);
        add(place + ".y", entry.y);
        if (entry.through) add(place + ".through.x", (*entry.through)[0]);
        if (entry.through) add(place + ".through.y", (*entry.through)[1]);
      }
    add_vector(f.id + ".origin", f.placement.origin);
    if (f.placement.z_axis) add_vector(f.id + ".zAxis", *f.placement.z_axis);
    if (f.placement.x_axis) add_vector(f.id + ".xAxis", *f.placement.x_axis);
    if (auto* point = std::get_if<std::array<Scalar, 3>>(&f.reference))
      add_vector(f.id + ".referencePoint", *point);
  }
  return all;
}

/// `model` with its n-th literal changed.
ModelSource changed(ModelSource model, std::size_t n, double by) {
  Scalar& value = *literals(model)[n].value;
  value = std::get<double>(value) + by;
  return model;
}

std::vector<std::vector<FaceName>> face_names(const BoundaryModel& boundary) {
  std::vector<std::vector<FaceName>> names;
  for (const BoundaryFace& face : boundary.faces) names.push_back(face.names);
  std::sort(names.begin(), names.end());
  return names;
}

bool same_topology(const BoundaryModel& a, const BoundaryModel& b) {
  return a.vertices.size() == b.vertices.size() && a.edges.size() == b.edges.size() &&
         face_names(a) == face_names(b);
}

/// How far each face of `from` lies from that of the same names in `to`, by its points; infinite
/// where there is none.
std::vector<double> face_motions(const BoundaryModel& from, const BoundaryModel& to) {
  std::vector<double> motions;
  for (const BoundaryFace& face : from.faces) {
    double least = HUGE_VAL;
    for (const BoundaryFace& other : to.faces) {
      if (other.names != face.names || other.surface.kind != face.surface.kind) continue;
      double furthest = 0;
      for (const Vec3& p : face.points)
        furthest = std::max(furthest, std::fabs(signed_distance(other.surface, p)));
      least = std::min(least, furthest);
    }
    motions.push_back(least);
  }
  return motions;
}

/// Delivered nodes of `r` on the faces that are marked.
std::vector<Vec3> nodes_on(const Revision& r, const std::vector<bool>& faces) {
  std::vector<Vec3> nodes;
  const auto supports = r.supports();
  for (std::size_t n = 0; n < supports.size(); ++n) {
    if (supports[n].kind == Support::Kind::Interior) continue;
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (faces[f] && incident(r.cells.boundary, supports[n],
                               {Support::Kind::Face, static_cast<std::int32_t>(f)})) {
        nodes.push_back(r.output.mesh.nodes[n]);
        break;
      }
  }
  return nodes;
}

bool says_why(const Report& report) {
  const auto& tried = report.attempts;
  return !tried.empty() && tried[0].strategy == "morphed" && !tried[0].reason.empty() &&
         std::any_of(report.warnings.begin(), report.warnings.end(), [](const Warning& w) {
           return w.message.find("the connectivity could not be kept: ") == 0;
         });
}

/// What holds for every mesh, whatever way led to it.
void expect_valid_edit(const Revision& from, const Revision& r) {
  const Membership membership(r.model);
  const Verification v = verify(r.output.mesh, r.supports(), r.cells.boundary, r.cells.volume, kRun,
                                {.material = [&](const Vec3& p) { return membership.inside(p); }});
  EXPECT_TRUE(v.valid) << v.failures.front().what;
  const NodeMap& map = r.output.map;
  for (std::size_t n = 0; n < map.node_origin.size(); ++n)
    if (map.node_origin[n] == NodeOrigin::Kept) {
      const Transform& transform = map.transforms[map.node_transform[n]];
      ASSERT_EQ(r.output.mesh.nodes[n],
                transform.apply(from.output.mesh.nodes[map.original_node[n]]));
    }
}

/// No change: all of `from`, to the bit.
void expect_unchanged(const Revision& from, const Revision& r) {
  EXPECT_EQ(r.output.mesh.nodes, from.output.mesh.nodes);
  EXPECT_EQ(r.output.mesh.tets, from.output.mesh.tets);
  EXPECT_EQ(r.output.node_ids, from.output.node_ids);
  EXPECT_EQ(r.output.tet_ids, from.output.tet_ids);
  EXPECT_EQ(r.report.counts.nodes_kept, from.output.mesh.nodes.size());
  EXPECT_EQ(r.report.counts.tets_kept, from.output.mesh.tets.size());
}

/// Continuity, from the revision that the connectivity was made for.
void expect_continued(const Revision& anchor, const Revision& r,
                      const std::vector<double>& motions) {
  const double l = anchor.edge_length;
  const double none = kNone * anchor.cells.boundary.bounds.diagonal();
  const double largest = *std::max_element(motions.begin(), motions.end());
  EXPECT_LT(largest, kSmallest * l);
  EXPECT_EQ(r.output.mesh.tets, anchor.output.mesh.tets);
  EXPECT_EQ(r.output.node_ids, anchor.output.node_ids);
  // Hidden surfaces move too: where one lies on a face, the kernel may draw its edges on either.
  const double drawn = std::min(motion_bound(anchor.model, r.model), kCoincident / r.cells.scale);
  std::vector<bool> moved;
  for (const double m : motions) moved.push_back(m > none);
  std::vector<Vec3> sources = nodes_on(anchor, moved);
  for (std::size_t n = 0; n < r.output.mesh.nodes.size(); ++n)
    if (r.supports()[n].kind > Support::Kind::Face &&
        distance(anchor.output.mesh.nodes[n], r.output.mesh.nodes[n]) <= drawn)
      sources.push_back(anchor.output.mesh.nodes[n]);
  for (std::size_t n = 0; n < r.output.mesh.nodes.size(); ++n) {
    const Vec3& before = anchor.output.mesh.nodes[n];
    const double by = distance(before, r.output.mesh.nodes[n]);
    if (by == 0) continue;
    ASSERT_LE(by, std::max(kLeverage * largest, drawn) + none) << "node " << n;
    ASSERT_TRUE(std::any_of(sources.begin(), sources.end(),
                            [&](const Vec3& p) { return distance(p, before) <= kRadius * l; }))
        << "node " << n;
  }
  const Quality &now = r.report.quality, &then = anchor.report.quality;
  EXPECT_GE(now.dihedral_min, std::min(kAngle, then.dihedral_min - 0.06));
  EXPECT_LE(now.dihedral_max, std::max(kLargestAngle, then.dihedral_max + 0.06));
  EXPECT_GE(now.volume_length_min, std::min(kMeasure, then.volume_length_min - 1e-3));
}

struct Result {
  std::string what;              ///< the way, or the reason of a refusal
  std::optional<Revision> made;  ///< nothing where the model is refused
};

/// Remeshes `from` for `source` and holds the result against the contract; `anchor` is what the
/// connectivity of `from` was made for.
Result expect_contract(const Revision& anchor, const Revision& from, const ModelSource& source) {
  Result result;
  MeshOptions inherited;
  inherited.sizing = from.options.sizing;
  try {
    result.made = make_revision(from, source, inherited, kRun);
  } catch (const Error& e) {
    result.what = e.info().reason;
    EXPECT_NE(result.what, "");
    EXPECT_NE(result.what, "INTERNAL") << e.what();
    if (result.what != "EMPTY_MODEL") {  // which is the whole model's
      EXPECT_NE(test::joined(e.info().features) + e.info().parameter, "") << e.what();
    }
    return result;
  }
  const Revision& r = *result.made;
  result.what = test::name_of(r.report.strategy);
  expect_valid_edit(from, r);
  const std::vector<double> motions = face_motions(anchor.cells.boundary, r.cells.boundary);
  const double largest = *std::max_element(motions.begin(), motions.end());
  const double l = sizes_of(anchor, kRun).least();
  const bool none = same_geometry(from.meshed_model, r.model);
  EXPECT_EQ(none, r.report.strategy == MeshStrategy::Unchanged);
  if (none) expect_unchanged(from, r);
  if (r.report.strategy == MeshStrategy::Morphed) expect_continued(anchor, r, motions);
  // Surfaces that are not on the boundary count too.
  if (!none && largest < kNearly * kSmallest * l &&
      motion_bound(anchor.model, r.model) < kFollowed * l &&
      same_topology(anchor.cells.boundary, r.cells.boundary)) {
    EXPECT_TRUE(r.report.strategy == MeshStrategy::Morphed || says_why(r.report));
  }
  return result;
}

/// Which edits the environment asks for: `all` of even meshes, or `sized`: all with default sizes.
std::string deltas_asked_for() {
  const char* which = std::getenv("REMESHD_DELTAS");
  return which != nullptr ? which : "";
}
bool all_deltas() { return deltas_asked_for() == "all" || deltas_asked_for() == "sized"; }

MeshOptions options() {
  MeshOptions options = kOfDeltas;
  options.sizing.even = deltas_asked_for() != "sized";
  return options;
}

/// By how much the k-th edit of 2 * kSizes changes a number.
double delta(std::size_t k, const Revision& base) {
  const double diagonal = base.cells.boundary.bounds.diagonal();
  const double sign = k % 2 == 0 ? 1 : -1;
  const std::size_t size = k / 2;
  if (size == 0) return sign * 1e-3 * kNone * diagonal;
  return sign * (size < kSizes - 1 ? kDeltas[size - 1] * base.edge_length : diagonal);
}

/// Whether a delta far below the edge length changes the topology: it leaves a film or a step that
/// TetGen may take a minute over.
bool leaves_a_film(const Revision& base, const ModelSource& source, double by) {
  if (std::fabs(by) >= kFilm * base.edge_length) return false;
  try {
    const CellularModel cells = build_cells(evaluate(source), kRun);
    return !same_topology(base.cells.boundary, cells.boundary);
  } catch (const Error&) {
    return false;
  }
}

/// The one of the edits of the n-th number that every run of the tests makes: eleven has no divisor
/// in common with how many there are, so that every delta has its turn.
std::size_t selected(const ModelSource& source, std::size_t n, const Revision& base) {
  std::size_t k = 11 * n % (2 * kSizes);
  const auto leaves = [&](double by) { return leaves_a_film(base, changed(source, n, by), by); };
  while (leaves(delta(k, base))) k = (k + 11) % (2 * kSizes);
  return k;
}

/// `hole1.radius -0.009 l local 0.08 s 25.2 134.8 0.52`: the last three are the worst dihedral
/// angles and the worst measure.
void print(const std::string& edit, const Result& result, double seconds) {
  std::cout << edit << " " << result.what << " " << seconds << " s";
  if (result.made) {
    const Quality& q = result.made->report.quality_away;
    std::cout << " " << q.dihedral_min << " " << q.dihedral_max << " " << q.volume_length_min;
  }
  std::cout << std::endl;
}

class EveryDelta : public testing::TestWithParam<std::string> {};

TEST_P(EveryDelta, GivesAValidMeshThatIsAsContinuousAsPromisedOrARefusal) {
  ModelSource source = test::case_model(GetParam());
  const Revision base = make_revision(Revision::none(), source, options(), kRun);
  const std::vector<Literal> all = literals(source);
  const auto check = [&](std::size_t n, std::size_t k) {
    const double by = delta(k, base);
    std::ostringstream edit;
    edit << all[n].name << " " << by / base.edge_length << " l";
    SCOPED_TRACE(edit.str());
    const Stopwatch watch;
    const Result result = expect_contract(base, base, changed(source, n, by));
    if (all_deltas()) print(edit.str(), result, watch.total());
    if (k / 2 == 0) {
      EXPECT_EQ(result.what, "unchanged");
    }
    // Once more, counted from the base: 0.0095 l is near enough to continue, 0.0171 l is not.
    if (result.what == "morphed" && std::fabs(by) > 0.004 * base.edge_length)
      expect_contract(base, *result.made, changed(source, n, 1.9 * by));
  };
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (!all_deltas())
      check(n, selected(source, n, base));
    else
      for (std::size_t k = 0; k < 2 * kSizes; ++k) check(n, k);
  }
}

std::vector<std::string> originals() {
  std::vector<std::string> names;
  for (const test::EditCase& c : test::seven_cases()) names.push_back(c.original);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Cases, EveryDelta, testing::ValuesIn(originals()), [](const auto& test) {
  std::string name = test.param;
  std::erase(name, '-');
  return name;
});

}  // namespace
}  // namespace remeshd

#include "engine/remesh/last_resort/tetgen_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/stopwatch.h"
#include "engine/boundary/material.h"
#include "engine/boundary/mesh_surface.h"
#include "engine/delivery/failure_place.h"
#include "engine/extract/peel.h"
#include "engine/improve/improve.h"
#include "engine/mesh/quality.h"
#include "engine/nodes/density.h"
#include "engine/remesh/attempt.h"
#include "engine/remesh/finish/faults.h"

namespace remeshd {

namespace {

/// One way to ask TetGen.
struct Question {
  const char* name;       ///< as an attempt's strategy
  double surface_length;  ///< x edge length
  bool split_surface;
};
// Mostly the first suffices. A finer surface is tried before TetGen may add points on one: where a
// thin wall makes its tets bad, it adds them by the ten thousand.
constexpr std::array kQuestions{
    Question{"TetGen, facets of 1 edge length", 1, false},
    Question{"TetGen, facets of 0.7 edge lengths", 0.7, false},
    Question{"TetGen, facets of 1 edge length, points added on them", 1, true},
    Question{"TetGen, facets of 0.5 edge lengths", 0.5, false},
    Question{"TetGen, facets of 0.5 edge lengths, points added on them", 0.5, true}};
struct TetGenBounds {
  double most_times = 10;            ///< facets and nodes inside, x what a regular mesh has,
  std::uint32_t most_more = 10'000;  ///< and some more
  double max_volume = 0.2;           ///< x edge length^3; a regular tet has 0.118
};
constexpr TetGenBounds kBounds;
// First markers of faces and edges. For segments TetGen uses 1 itself: those that it makes of the
// other sides of facets.
constexpr std::int32_t kFirstFace = 1, kFirstEdge = 2;

kernel::MarkedSurface mark(const SurfaceMesh& surface) {
  kernel::MarkedSurface marked;
  marked.surface.points = surface.nodes;
  for (const FaceFacet& f : surface.facets) {
    marked.surface.triangles.push_back(f.nodes);
    marked.triangle_markers.push_back(kFirstFace + f.face);
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = f.nodes[i], b = f.nodes[(i + 1) % 3];
      if (f.edge[i] < 0 || a > b) continue;
      marked.segments.push_back({a, b});
      marked.segment_markers.push_back(kFirstEdge + f.edge[i]);
    }
  }
  return marked;
}

/// Supports of all nodes: those of the surface keep theirs, those that TetGen added on it get
/// theirs from the markers.
std::vector<Support> find_supports(const SurfaceMesh& surface, const kernel::QualityMesh& out) {
  std::vector<Support> supports = surface.supports;
  supports.resize(out.filling.mesh.nodes.size());
  const auto set = [&](std::int32_t n, const Support& support) {
    if (static_cast<std::size_t>(n) >= surface.nodes.size()) supports[n] = support;
  };
  for (std::size_t f = 0; f < out.facets.size(); ++f)
    for (const std::int32_t n : out.facets[f])
      set(n, {Support::Kind::Face, out.facet_markers[f] - kFirstFace});
  for (std::size_t s = 0; s < out.segments.size(); ++s)
    if (out.segment_markers[s] >= kFirstEdge)
      for (const std::int32_t n : out.segments[s])
        set(n, {Support::Kind::Edge, out.segment_markers[s] - kFirstEdge});
  return supports;
}

/// Adds the points that the tets use to `nodes`, brought onto their supports, and returns the mesh
/// of the tets over these.
TetMesh take_used(std::vector<Tet> tets, const std::vector<Vec3>& points,
                  const std::vector<Support>& supports, const BoundaryModel& boundary,
                  NodeSet& nodes) {
  std::vector<std::int32_t> number(points.size(), -1);
  for (const Tet& t : tets)
    for (const std::int32_t n : t) number[n] = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (number[n] < 0) continue;
    number[n] = nodes.size();
    nodes.add_new(project(boundary, supports[n], points[n]), supports[n]);
  }
  for (Tet& t : tets) t = renamed(t, number);
  return {nodes.positions, std::move(tets)};
}

DelaunayMesh triangulate(const NodeSet& nodes, const Box& bounds, const Run& run) {
  DelaunayMesh mesh(bounds);
  std::vector<std::int32_t> all(nodes.positions.size());
  std::iota(all.begin(), all.end(), 0);
  mesh.insert(nodes.positions, all, run);
  return mesh;
}

std::uint32_t most_nodes_inside(const TetGenInput& input) {
  const CellularModel& cells = input.cells;
  const double expected = expected_nodes(cells.volume, cells.area, input.sizes.base());
  return kBounds.most_more +
         static_cast<std::uint32_t>(kBounds.most_times * std::fmin(expected, 1e7));
}

std::size_t most_facets(const TetGenInput& input) {
  const double l = input.sizes.base();
  const double expected = 4 / std::numbers::sqrt3 * input.cells.area / (l * l);
  return kBounds.most_more +
         static_cast<std::size_t>(kBounds.most_times * std::fmin(expected, 1e7));
}

/// Throws what run_tetgen throws. The candidate may be invalid; then it has no Delaunay mesh.
Candidate try_tetgen(const SurfaceMesh& surface, bool split_surface, const TetGenInput& input,
                     const kernel::TetGenLimits& limits, const Run& run) {
  const double l = input.sizes.base();
  const CellularModel& cells = input.cells;
  const kernel::MarkedSurface marked = mark(surface);
  const kernel::QualityMesh out = kernel::run_tetgen(marked,
                                                     {.max_volume = kBounds.max_volume * l * l * l,
                                                      .split_surface = split_surface,
                                                      .most_added = most_nodes_inside(input)},
                                                     limits, run);
  Candidate c;
  TetMesh mesh = take_used(tets_in_material(out.filling, marked.surface), out.filling.mesh.nodes,
                           find_supports(surface, out), cells.boundary, c.nodes);
  Stopwatch watch;
  c.verification = verify(mesh, c.nodes.supports, cells.boundary, cells.volume, run);
  watch.lap(c.verify_seconds);
  const auto unfinished = [&] {
    c.whole.mesh = paged(mesh);
    return std::move(c);
  };
  if (!can_be_improved(mesh, c.verification)) return unfinished();
  if (input.clean_up) {
    const std::vector<std::uint8_t> dirty(mesh.tets.size(), 1);
    mesh =
        improve(mesh, c.nodes.supports, cells.boundary, dirty, {.threshold = input.threshold}, run)
            .mesh;
  }
  const auto inside = [&](const Vec3& p) { return input.plan.modified().inside(p); };
  Stopwatch again;
  c.verification =
      verify(mesh, c.nodes.supports, cells.boundary, cells.volume, run, {.material = inside});
  again.lap(c.verify_seconds);
  if (!c.verification.valid) return unfinished();
  c.nodes.positions = mesh.nodes;  // no Delaunay mesh needs them where they were before clean-up
  c.loop.mesh = triangulate(c.nodes, cells.boundary.bounds, run);
  c.delaunay = peel(c.nodes, c.loop.mesh, cells.boundary, inside,
                    KnownClassification::nothing(c.loop.mesh), {}, run);
  c.whole = stitch(Revision::none(), {}, {}, {c.nodes, c.loop.mesh, c.delaunay, mesh, {}},
                   input.plan, run);
  for (SurfaceFacet& facet : c.verification.surface) facet.tet = c.whole.new_tets[facet.tet];
  std::ranges::stable_sort(c.verification.surface, {}, &SurfaceFacet::tet);
  return c;
}

/// Whether nothing is wrong but flat tets: then the model itself is flat there, however fine the
/// surface.
bool is_flat_only(const Candidate& c) {
  const Verification& v = c.verification;
  const auto& counts = v.counts;
  return std::accumulate(counts.begin(), counts.end(), 0U) == v.count(MeshFailure::BadTet) &&
         can_be_improved(c.whole.mesh, v);
}

FailurePlace place_of(const MeshDefect& defect, const TetGenInput& input) {
  return find_failure(defect, input.model, input.plan.modified(), input.cells.boundary,
                      input.sizes.base());
}

std::string fault_of(const Verification& failed, const TetGenInput& input) {
  if (failed.failures.empty()) return "the mesh did not pass verification";
  const MeshDefect& defect = failed.failures.front();
  return describe(defect, place_of(defect, input));
}

Error not_recovered(const TetGenInput& input, const Verification& failed, const std::string& also) {
  if (failed.failures.empty()) return error::boundary_not_recovered(also, {}, {});
  const MeshDefect& defect = failed.failures.front();
  const FailurePlace place = place_of(defect, input);
  std::optional<Vec3> at;
  if (!place.faces.empty()) at = defect.place;
  return error::boundary_not_recovered(describe(defect, place) + (also.empty() ? "" : "; " + also),
                                       at, place.features);
}

bool tetgen_failed(const Error& e) {
  return e.info().reason.starts_with("TETGEN_") && e.info().reason != "TETGEN_MISSING";
}

/// The first valid mesh; `given_up` gets the tries before it.
Candidate first_valid(const TetGenInput& input, const Run& run,
                      std::vector<TriedStrategy>& given_up) {
  const Stopwatch watch;
  std::optional<Error> failure;
  kernel::TetGenLimits limits = input.limits;
  const std::size_t facets = std::min(SurfaceMeshOptions{}.most_facets, most_facets(input));
  for (const Question& question : kQuestions) {
    const Stopwatch tried;
    try {
      const SurfaceMesh surface = mesh_surface(
          input.cells.boundary,
          {.sizes = input.sizes, .share = question.surface_length, .most_facets = facets}, run);
      limits.seconds = input.limits.seconds - watch.total();
      if (limits.seconds <= 0) throw error::tetgen_too_slow(input.limits.seconds);
      Candidate c = try_tetgen(surface, question.split_surface, input, limits, run);
      if (c.verification.valid) return c;
      failure = not_recovered(input, c.verification, {});
      given_up.push_back({question.name, fault_of(c.verification, input), tried.total()});
      if (!question.split_surface && is_flat_only(c)) break;
    } catch (const Error& e) {
      if (!tetgen_failed(e)) throw;
      given_up.push_back({question.name, e.info().message, tried.total()});
      if (e.info().reason == "TETGEN_TOO_SLOW") throw error::tetgen_too_slow(input.limits.seconds);
      failure = e;
    }
  }
  throw Error(*failure);
}

}  // namespace

Candidate mesh_by_tetgen(const TetGenInput& input, const Run& run) {
  std::vector<TriedStrategy> given_up;
  try {
    Candidate c = first_valid(input, run, given_up);
    c.given_up = std::move(given_up);
    return c;
  } catch (Error& error) {
    error.info().attempts = in_words(given_up);
    throw;
  }
}

Candidate tetgen_mesh(const TetGenInput& input, const Verification& failed, const Run& run) {
  try {
    return mesh_by_tetgen(input, run);
  } catch (const Error& e) {
    const std::string& reason = e.info().reason;
    if (!tetgen_failed(e) && reason != "KERNEL_FAILURE") throw;
    Error error = not_recovered(input, failed, e.info().message);
    error.info().attempts = e.info().attempts;
    throw error;
  }
}

}  // namespace remeshd

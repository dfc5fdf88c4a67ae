#include "engine/cellular/fuse_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/base/angle.h"
#include "engine/base/error.h"
#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/cellular/check_cells.h"
#include "engine/cellular/feature_brep.h"
#include "engine/cellular/features_at.h"
#include "engine/cellular/owners.h"
#include "engine/kernel/brep.h"
#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

using kernel::Brep;

/// Renumbers the parts in history order, after a fuse of the features in reverse order.
void restore_order(kernel::Fusion& fusion, int parts) {
  for (auto* kind : {&fusion.cells, &fusion.faces, &fusion.edges, &fusion.vertices})
    for (std::vector<kernel::Source>& sources : *kind) {
      for (kernel::Source& source : sources) source.part = parts - 1 - source.part;
      std::ranges::sort(sources);
    }
}

/// A general fuse of all parts, made by fusing one part after the other with the result so far.
kernel::Fusion fuse_in_turn(const std::vector<kernel::Part>& parts, const Run& run,
                            const std::optional<Vec3>& reference) {
  kernel::Fusion all = kernel::general_fuse(std::span(parts).first(1), run, reference);
  for (int p = 1; p < static_cast<int>(parts.size()); ++p) {
    std::vector<int> cells(all.brep.cells.size());
    std::iota(cells.begin(), cells.end(), 0);
    kernel::Fusion next = kernel::general_fuse(
        std::array{kernel::Part{&all.brep, cells, Transform()}, parts[p]}, run, reference);
    const auto trace = [&](auto kernel::Fusion::*kind) {
      for (std::vector<kernel::Source>& sources : next.*kind) {
        std::vector<kernel::Source> traced;
        for (const kernel::Source& source : sources)
          if (source.part == 1)
            traced.push_back({p, source.element});
          else
            std::ranges::copy((all.*kind)[source.element], std::back_inserter(traced));
        sort_unique(traced);
        sources = std::move(traced);
      }
    };
    trace(&kernel::Fusion::cells);
    trace(&kernel::Fusion::faces);
    trace(&kernel::Fusion::edges);
    trace(&kernel::Fusion::vertices);
    all = std::move(next);
  }
  return all;
}

/// The general fuse of all features, with what is known about each feature's own faces.
struct Fused {
  std::vector<Brep> features;  ///< in history order; part i of the fusion is feature i
  kernel::Fusion fusion;
};

/// Whether the CAD kernel begins and ends the feature's faces at a seam in its xz plane.
bool has_seam(const Shape& shape) {
  if (const auto* revolution = std::get_if<Revolution>(&shape))
    return revolution->angle > kTurn - 1e-12;
  return !std::holds_alternative<Block>(shape) && !std::holds_alternative<Prism>(shape) &&
         !std::holds_alternative<Slot>(shape);
}

/// Choices on which the model does not depend, but the CAD kernel's success does.
struct FuseAttempt {
  double seam;           ///< rad about their axis: where round features are cut open
  bool last_first;       ///< features are the kernel's arguments in reverse history order
  int doublings = 0;     ///< of the kernel's unit of length; negative: halvings
  bool in_turn = false;  ///< by fuse_in_turn instead of one general fuse
};

constexpr std::size_t kMaxInTurn = 16;  // features; more would take too long

/// Tried in this order until one succeeds. With a smaller unit of length the kernel tells apart
/// what nearly coincides. With a larger one it takes points for equal that are up to 1e-7 units
/// apart, which is at most 1.3e-8 of the model's diagonal, and moves nothing by more than that.
/// Owners and volumes are checked against the exact model either way. If all attempts fail, they
/// take about as long as ten fuses.
constexpr std::array kAttempts{FuseAttempt{0.0, false, 0}, FuseAttempt{0.7, false, 0},
                               FuseAttempt{2.5, false, 0}, FuseAttempt{0.7, false, -4},
                               FuseAttempt{2.5, true, 4},  FuseAttempt{0.0, false, 0, true}};

Fused fuse(const FeatureModel& model, const FuseFrame& frame, const FuseAttempt& attempt,
           const Run& run) {
  const double scale = std::ldexp(frame.scale, -attempt.doublings);
  Fused fused;
  for (const Feature& feature : model.features) {
    fused.features.push_back(feature_brep(feature, scale));
    run.poll();
  }
  const double c = std::cos(attempt.seam), t = std::sin(attempt.seam);
  const Transform turn = Transform::frame({c, t, 0}, {-t, c, 0}, {0, 0, 1}, {});
  std::vector<kernel::Part> parts;
  for (std::size_t i = 0; i < model.features.size(); ++i) {
    const Feature& feature = model.features[i];
    const bool turned = attempt.seam != 0 && has_seam(feature.shape);
    parts.push_back(
        {&fused.features[i], {0}, turned ? feature.placement * turn : feature.placement});
  }
  if (attempt.last_first) std::ranges::reverse(parts);
  fused.fusion = attempt.in_turn ? fuse_in_turn(parts, run, frame.reference)
                                 : kernel::general_fuse(parts, run, frame.reference);
  if (attempt.last_first) restore_order(fused.fusion, static_cast<int>(parts.size()));
  return fused;
}

/// The surface of this name, of the feature with this id and solid, that the face of the B-rep lies
/// on.
const Surface& surface_of(const Solid& solid, const std::string& id, const std::string& name,
                          const Brep& brep, int face) {
  const SolidFace* best = nullptr;
  double nearest = HUGE_VAL;
  for (const SolidFace& candidate : solid.faces()) {
    if (candidate.name != name) continue;
    double gap = 0;
    for (const auto& triangle : brep.faces[face].triangles)
      for (const int p : triangle)
        gap = std::max(gap, std::fabs(signed_distance(candidate.surface, brep.points[p])));
    if (gap < nearest) {
      nearest = gap;
      best = &candidate;
    }
  }
  if (best == nullptr || nearest > 100 * kernel_tolerance(brep))
    throw error::kernel_failure("a face lies on no surface " + id + "." + name,
                                brep.edges[brep.faces[face].edges.front()].points.front());
  return best->surface;
}

void fill_cells_and_faces(FusedFeatures& fused_features, const kernel::Fusion& fusion,
                          const Membership& membership) {
  const Brep& brep = fusion.brep;
  CellComplex& out = fused_features.cells;
  for (std::size_t c = 0; c < brep.cells.size(); ++c) {
    Cell cell;
    for (const kernel::Source& source : fusion.cells[c]) cell.owners.push_back(source.part);
    cell.positive = membership.nature(cell.owners.back()) == Nature::Additive;
    cell.volume = brep.cells[c].volume;
    out.cells.push_back(std::move(cell));
  }
  const auto positive = [&](int cell) { return cell >= 0 && out.cells[cell].positive; };
  for (const kernel::BrepFace& face : brep.faces) {
    CellFace cell_face;
    cell_face.cells = face.cells;
    cell_face.area = face.area;
    cell_face.boundary = positive(face.cells[0]) != positive(face.cells[1]);
    for (const int c : face.cells)
      if (c >= 0) merge_owners(cell_face.owners, out.cells[c].owners);
    out.faces.push_back(std::move(cell_face));
  }
}

/// Names and surface of every face of the B-rep, boundary or not.
std::vector<BoundaryPiece> describe_faces(const CellComplex& model, const Fused& fused,
                                          const Membership& membership,
                                          const std::vector<Feature>& features) {
  const Brep& brep = fused.fusion.brep;
  std::vector<BoundaryPiece> pieces(brep.faces.size());
  for (int f = 0; f < static_cast<int>(brep.faces.size()); ++f) {
    const CellFace& face = model.faces[f];
    BoundaryPiece& piece = pieces[f];
    piece.boundary = face.boundary;
    piece.outward = face.cells[0] >= 0 && model.cells[face.cells[0]].positive;
    const int material = face.boundary ? face.cells[piece.outward ? 0 : 1] : -1;
    // Latest owner first: its surface, in the feature's own numbers, stands for all.
    for (auto it = fused.fusion.faces[f].rbegin(); it != fused.fusion.faces[f].rend(); ++it) {
      const FaceName name{it->part, fused.features[it->part].faces[it->element].label};
      const bool owns =
          material >= 0 && std::ranges::binary_search(model.cells[material].owners, it->part);
      auto& names = owns ? piece.material_names : piece.other_names;
      names.push_back(name);
    }
    const FaceName& first =
        piece.material_names.empty() ? piece.other_names.front() : piece.material_names.front();
    piece.surface = surface_of(membership.solids()[first.feature], features[first.feature].id,
                               first.face, brep, f);
  }
  return pieces;
}

}  // namespace

FuseFrame fuse_frame(const Membership& membership) {
  return {kernel::unit_scale(membership.bounds_of_all().diagonal()), {}};
}

void fuse_features(const FeatureModel& model, const Membership& membership, const FuseFrame& frame,
                   const Run& run, const std::function<void(FusedFeatures)>& use) {
  // Where all attempts fail, the first failure is thrown.
  std::optional<Error> first;
  for (const FuseAttempt& attempt : kAttempts) {
    if (attempt.in_turn && model.features.size() > kMaxInTurn) continue;
    try {
      Fused fused = fuse(model, frame, attempt, run);
      FusedFeatures out;
      fill_cells_and_faces(out, fused.fusion, membership);
      check_cells(out.cells, fused.fusion.brep, model, membership);
      run.poll();
      out.pieces = describe_faces(out.cells, fused, membership, model.features);
      out.cells.brep = std::make_shared<const Brep>(std::move(fused.fusion.brep));
      return use(std::move(out));
    } catch (Error& failure) {
      const ErrorInfo& info = failure.info();
      if (info.place && info.features.empty())
        failure.info().features = features_at(model, membership, *info.place);
      if (info.reason != "KERNEL_FAILURE") throw;
      if (!first) first = failure;
    }
  }
  throw std::move(*first);
}

}  // namespace remeshd

#include "engine/local_fuse/sewing/sew.h"

#include <algorithm>
#include <functional>

#include "engine/base/error.h"
#include "engine/base/stopwatch.h"
#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/cellular/changes.h"
#include "engine/cellular/fuse_features.h"
#include "engine/local_fuse/prisms/crossing_prisms.h"
#include "engine/local_fuse/sewing/replace_parts.h"

namespace remeshd {
namespace {

constexpr double kFarReference = 8;  // diagonals from the model: beyond, swept volumes lose digits

/// The features to fuse, by index in the edited model: those that reach into the boxes, or to edges
/// and round faces of the base that meet a box and are replaced as a whole.
std::vector<int> features_to_fuse(const FeatureModel& model, const BoundaryParts& base,
                                  const TouchedParts& touched, const std::vector<Box>& boxes) {
  const double margin = kernel_tolerance(base.brep);
  const auto near = [&](const Feature& feature) {
    std::vector<Box> round = boxes_round(feature);
    for (Box& box : round) box = grown(box, margin);
    if (std::ranges::any_of(round, [&](const Box& box) { return touch(boxes, box); })) return true;
    for (std::size_t f = 0; f < base.pieces.size(); ++f)
      if (touched.faces[f] && !is_plane(base.pieces[f]) && touch(round, base.pieces[f].box) &&
          touches(round, base.brep, base.brep.faces[f], base.pieces[f].surface))
        return true;
    for (std::size_t e = 0; e < base.brep.edges.size(); ++e)
      if (touched.edges[e] && touches(round, base.brep.edges[e])) return true;
    return false;
  };
  std::vector<int> features;
  for (int f = 0; f < static_cast<int>(model.features.size()); ++f)
    if (near(model.features[f])) features.push_back(f);
  return features;
}

/// Fuses these features by the CAD kernel. Gives up where they are all of the model's.
///
/// Throws what fuse_features throws.
Tried<FusedPrisms> fuse_some(const EditedModel& edited, const std::vector<int>& features,
                             const FuseFrame& frame, const Run& run) {
  if (features.size() >= edited.model.features.size())
    return GaveUp{"sew", "every feature is near the change"};
  BoundaryParts out;
  out.brep.scale = frame.scale;
  FeatureModel some;
  for (const int f : features) some.features.push_back(edited.model.features[f]);
  fuse_features(some, Membership(some), frame, run, [&](const FusedFeatures& fused) {
    out = boundary_parts(*fused.cells.brep, fused.pieces);
  });
  for (BoundaryPiece& piece : out.pieces)
    for (auto* names : {&piece.material_names, &piece.other_names})
      for (FaceName& name : *names) name.feature = features[name.feature];
  std::vector<char> along;
  for (std::size_t f = 0; f < out.pieces.size(); ++f)
    along.push_back(looks_along(out.brep, out.brep.faces[f], out.pieces[f].surface) ? 1 : 0);
  return FusedPrisms{std::move(out), std::move(along)};
}

/// What a fuse of no features gives.
FusedPrisms fuse_nothing(const FuseFrame& frame) {
  FusedPrisms fused;
  fused.parts.brep.scale = frame.scale;
  return fused;
}

}  // namespace

Sewn sew(const EditedModel& edited, const SewingBase& base, const Run& run) {
  const Changes changes = find_changes(base.model, edited.model, edited.membership);
  const TouchedParts touched(base.parts, changes.boxes);
  const std::vector<int> features =
      features_to_fuse(edited.model, base.parts, touched, changes.boxes);
  const Box& bounds = edited.membership.bounds();
  const bool far_reference =
      distance(base.parts.brep.reference, bounds.lo) > kFarReference * bounds.diagonal();
  FuseFrame frame = fuse_frame(edited.membership);
  frame.reference = base.parts.brep.reference;

  struct Route {
    std::string_view name;
    std::function<Tried<FusedPrisms>()> fuse;
  };
  std::vector<Route> routes{
      {"swept",
       [&] { return fuse_parallel_prisms(edited.model, edited.membership, features, frame); }},
      {"crossed",
       [&] { return fuse_crossing_prisms(edited.model, edited.membership, features, frame); }},
      {"fused in part", [&] { return fuse_some(edited, features, frame, run); }}};
  if (features.empty()) routes = {{"kept", [&] { return fuse_nothing(frame); }}};
  const auto follow = [&](const Route& route) -> Tried<BoundaryParts> {
    if (far_reference) return GaveUp{"sew", "the base's point of reference is far from the model"};
    const auto fused = route.fuse();
    if (!fused) return fused.why();
    return replace_parts(base.parts, changes, *fused, touched, edited.membership);
  };
  Sewn out;
  for (const Route& route : routes) {
    const Stopwatch watch;
    const auto give_up = [&](std::string reason) {
      out.given_up.push_back({std::string(route.name), std::move(reason), watch.total()});
    };
    try {
      auto parts = follow(route);
      if (parts) {
        out.parts = *std::move(parts);
        out.parts->geometry = route.name;
        break;
      }
      give_up(text_of(parts.why()));
    } catch (const Error& failure) {
      if (failure.info().kind == ErrorKind::Cancelled) throw;
      give_up(failure.what());
    }
  }
  return out;
}

}  // namespace remeshd

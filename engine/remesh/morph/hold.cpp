#include "engine/remesh/morph/hold.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <utility>

#include "engine/mesh/quality.h"
#include "engine/motion/carried_boundary.h"
#include "engine/motion/held_places.h"

namespace remeshd {
namespace {

struct HoldLimits {
  double partner_reach = 0.3;  ///< x edge length: of an entity from where it is expected, at most
  double least_measure = 0.25;
  double least_dihedral = 10 * std::numbers::pi / 180;
  double largest_dihedral = 165 * std::numbers::pi / 180;
};
constexpr HoldLimits kHoldLimits;

bool is_good_enough(const Tet& t, const CowVector<Vec3>& now, const CowVector<Vec3>& anchor) {
  const auto [least, largest] = std::ranges::minmax(dihedral_angles(now, t));
  const double measure = volume_length(now, t);
  if (least >= kHoldLimits.least_dihedral && largest <= kHoldLimits.largest_dihedral &&
      measure >= kHoldLimits.least_measure)
    return true;
  const auto [least_then, largest_then] = std::ranges::minmax(dihedral_angles(anchor, t));
  return least >= least_then && largest <= largest_then && measure >= volume_length(anchor, t);
}

std::string in_short(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

/// Whether the models have the same features in the same order, but for the values of parameters.
bool same_features(const FeatureModel& a, const FeatureModel& b) {
  return std::ranges::equal(a.features, b.features, [](const Feature& f, const Feature& g) {
    return f.id == g.id && f.nature == g.nature && f.shape.index() == g.shape.index();
  });
}

}  // namespace

std::variant<MorphedMesh, NotMorphed> hold_mesh(const Revision& original, const Revision& modified,
                                                const Run& run) {
  if (!same_features(original.model, modified.model))
    return NotMorphed("features came, went or changed their types or order");
  const double l = original.edge_length;
  const BoundaryModel& boundary = modified.cells.boundary;
  const auto match = match_carried(original.cells.boundary, original.model, boundary,
                                   modified.model, kHoldLimits.partner_reach * l);
  if (!match) return NotMorphed("the topology of the boundary changed");

  std::vector<Support> supports = original.supports().flat();
  for (Support& support : supports) support = (*match)(support);
  const CowVector<Vec3>& anchor = original.delaunay_nodes();
  const MeshSpread spread(original, anchor, run);
  HeldPlaces places = held_places(anchor, spread, supports, boundary, run);
  const double most = modified.options.hold * l;
  if (places.surface_motion > most)
    return NotMorphed("a surface is " + in_short(places.surface_motion / l) +
                      " edge lengths from where it was when the connectivity was made");
  MorphedMesh held;
  held.supports = CowVector<Support>(std::span<const Support>(supports), original.supports());
  held.mesh.tets = original.output.mesh.tets;
  held.mesh.nodes = CowVector<Vec3>(std::span<const Vec3>(places.nodes), anchor);
  for (std::size_t n = 0; n < anchor.size(); ++n)
    if (places.nodes[n] != anchor[n]) ++held.nodes_moved;
  Polling poll(run);
  for (const Tet& t : held.mesh.tets) {
    poll();
    if (!is_good_enough(t, held.mesh.nodes, anchor))
      return NotMorphed("a tet would have missed what a held mesh has to keep of its quality");
  }
  return verified(std::move(held), original, modified, run);
}

}  // namespace remeshd

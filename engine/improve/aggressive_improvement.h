#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/improve/boundary_rules.h"
#include "engine/improve/local_mesh.h"
#include "engine/improve/reconnect.h"
#include "engine/improve/score.h"
#include "engine/improve/smooth.h"

namespace remeshd {

/// Operations on a residual tet: a bad tet that is still below the goals after reconnections and
/// moves of single nodes that compare the volume-length measure. These operations compare scores,
/// so that dihedral angles count too, and take more time.
class AggressiveImprovement {
 public:
  AggressiveImprovement(LocalMesh& mesh, const BoundaryRules& rules, Smoother& smoother,
                        const Score& score, int max_ring)
      : mesh_(mesh), rules_(rules), smoother_(smoother), score_(score), max_ring_(max_ring) {}

  /// Tets with their stamps, ascending.
  using Neighbourhood = std::vector<std::pair<std::int32_t, std::uint32_t>>;
  /// The tets that the operations look at to improve t: one that failed on t fails again until one
  /// of these changes.
  [[nodiscard]] Neighbourhood neighbourhood(std::int32_t t) const;
  /// Whether a neighbourhood is as large as only in a broken mesh, with nodes in hundreds of tets:
  /// the operations would take minutes there, for nothing.
  [[nodiscard]] static bool is_crowded(const Neighbourhood& neighbourhood);

  /// Moves all nodes round a tet together, in rounds of small energy descent steps, though most of
  /// their tets are good enough: where two nodes of a model edge are too near each other, neither
  /// can move alone. Takes the moves back unless the tets that they touch rank better (`Rank`) and
  /// the worst score is no worse.
  bool descend(std::int32_t t);

  /// Applies the reconnection that takes the tet out and whose worst new tet is best, by score or
  /// by `quality`. Returns false where none beats the tet.
  bool reconnect(std::int32_t t) { return reconnect(t, TetQuality(score_)); }
  bool reconnect(std::int32_t t, const TetQuality& quality);

  /// Moves the tet's nodes, one after the other, in shrinking steps along the axes wherever the
  /// worst score of the node's tets gets better.
  bool compass_search(std::int32_t t);

  /// Works on all tets round a tet at once, in rounds: energy descent steps of their nodes, which
  /// spread the deficits evenly, then reconnections of the tets that are not good. The worst may
  /// get worse for some rounds. Takes everything back unless in the end the worst score is better,
  /// or no worse and the sum of the deficits smaller.
  bool optimise_neighbourhood(std::int32_t t);

  /// The same from other starts: first one of the edges or facets of the tet is taken out, even if
  /// the new tets are worse; each in turn until it helps. It can help where moves alone cannot: two
  /// tets share a segment of a model edge, say, and what one gains the other loses.
  bool perturb_and_optimise(std::int32_t t);

  /// The tets that the last operation that returned true changed or may have changed, but for those
  /// at corners beyond the neighbourhood, which its compass search may move.
  [[nodiscard]] const std::vector<std::int32_t>& touched() const { return touched_; }

 private:
  /// How a group of tets does by their scores.
  struct Rank {
    double worst = 1;
    double deficit = 0;  ///< what the scores lack to 1, summed
    [[nodiscard]] bool better_than(const Rank& other) const;
  };

  [[nodiscard]] bool good(std::int32_t t) const { return score_(mesh_, t) >= 1; }
  [[nodiscard]] std::vector<std::int32_t> nodes_round(std::int32_t t) const;
  [[nodiscard]] std::vector<std::int32_t> tets_at(const std::vector<std::int32_t>& nodes) const;
  [[nodiscard]] Rank rank(const std::vector<std::int32_t>& tets) const;
  /// Worst score of the node's tets with the node at p; stops once one is at or below `floor`.
  [[nodiscard]] double worst_at(std::int32_t node, const Vec3& p, double floor) const;
  bool compass_search_node(std::int32_t node);
  /// Finds the reconnection that takes out an edge (`way` 0 to 5) or a facet (6 to 9) of the tet,
  /// even if the new tets are worse than the old, as long as they score above `start_score`.
  /// Returns false where there is none.
  bool take_out(std::int32_t t, int way, Reconnection& out) const;
  /// `start`: applied first, unless it is empty.
  bool optimise_from(const Reconnection& start, const std::vector<std::int32_t>& nodes);
  void optimise_round(const std::vector<std::int32_t>& nodes, int steepness);
  /// Keeps what was tried, where it helped; else takes it back.
  bool end_trial(bool helped, std::vector<std::int32_t> tets);
  void compass_search_all(const std::vector<std::int32_t>& tets);

  LocalMesh& mesh_;
  const BoundaryRules& rules_;
  Smoother& smoother_;
  const Score& score_;
  int max_ring_;
  Reconnection trial_, best_;
  std::vector<Triangle> facets_;
  std::vector<std::int32_t> touched_;
};

}  // namespace remeshd

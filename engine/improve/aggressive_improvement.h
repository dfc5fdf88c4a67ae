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

/// Operations on a residual bad tet: one that reconnections and moves of single nodes by measure
/// left below the goals. They go by scores, so that angles count, and cost more.
class AggressiveImprovement {
 public:
  AggressiveImprovement(LocalMesh& mesh, const BoundaryRules& rules, Smoother& smoother,
                        const Score& score, int max_ring)
      : mesh_(mesh), rules_(rules), smoother_(smoother), score_(score), max_ring_(max_ring) {}

  /// Tets with their stamps, ascending.
  using Neighbourhood = std::vector<std::pair<std::int32_t, std::uint32_t>>;
  /// What the operations look at to improve a tet: one that failed there fails until this changes.
  [[nodiscard]] Neighbourhood neighbourhood(std::int32_t t) const;
  /// Whether so many tets surround a tet as only do in a mesh that is broken there, with nodes in
  /// hundreds of tets: the operations would take minutes there, for nothing.
  [[nodiscard]] static bool is_crowded(const Neighbourhood& neighbourhood);

  /// Moves all nodes round a tet a little, several times, though most of their tets are good
  /// enough: where two nodes of a model edge are too near, each holds the other. Takes the moves
  /// back unless all tets that they touch get better taken together, and the worst no worse.
  bool descend(std::int32_t t);

  /// Applies the reconnection that takes the tet out and has the best worst score, or measure.
  bool reconnect(std::int32_t t) { return reconnect(t, TetQuality(score_)); }
  bool reconnect(std::int32_t t, const TetQuality& quality);

  /// Moves the tet's nodes, one after the other, in shrinking steps along the axes wherever the
  /// worst score of the node's tets gets better.
  bool compass_search(std::int32_t t);

  /// Works on all that surrounds a tet at once: rounds of moves that share out what the tets lack,
  /// and reconnections of those that lack, though the worst may get worse for some rounds. Takes
  /// everything back unless in the end the worst score is better, or as good and what all of them
  /// lack less.
  bool optimise_neighbourhood(std::int32_t t);

  /// The same from another start: each of the edges and facets of the tet in turn is taken out
  /// first, at the price of worse tets. It helps where no motion can with the tets as they are: two
  /// of them stand on a segment of a model edge, say, and what one gains the other loses.
  bool perturb_and_optimise(std::int32_t t);

  /// The tets that the last of these that returned true changed or may have changed.
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
  /// One of the ten ways to take the tet out, whether it gets worse or not.
  bool take_out(std::int32_t t, int way, Reconnection& out) const;
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

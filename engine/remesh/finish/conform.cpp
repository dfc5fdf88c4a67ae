#include "engine/remesh/finish/conform.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "engine/remesh/finish/faults.h"
#include "engine/remesh/finish/insert_nodes.h"
#include "engine/remesh/finish/opposite_nodes.h"
#include "engine/remesh/finish/patch_mesh.h"
#include "engine/remesh/finish/stranded_nodes.h"

namespace remeshd {
namespace {

struct ConformLimits {
  int rounds = 8;      ///< at facets, and as many where verification finds faults
  double fewer = 0.7;  ///< x faults before a round: a round that leaves more has not helped
  double few = 12;     ///< faults: with no more, rounds go on though one has not helped
  double few_inserted = 200, most_inserted = 0.2;
};
constexpr ConformLimits kConformLimits;

/// A mesh on its way to one that has all of the boundary.
class Conforming {
 public:
  Conforming(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
             const SampledBoundary& boundary)
      : c_(c),
        task_(task),
        patch_(patch),
        boundary_(boundary),
        sized_(!task.options.sizing.even),
        most_(static_cast<std::uint32_t>(
            few_more_nodes(static_cast<double>(c.nodes.size() + c.nodes.elsewhere)))) {}

  std::uint32_t conform() {
    for (int rounds = 0;; ++rounds) {
      insert_at_facets();
      finish(rounds > 0);
      if (rounds == kConformLimits.rounds || !is_worth_another_round()) break;
      if (!insert_at(c_.verification.failures)) break;
    }
    if (stalled_ && !c_.verification.valid) take_back();
    return inserted_;
  }

 private:
  /// Inserts nodes near facets that lie on no face: no clean-up brings such a facet onto one.
  void insert_at_facets() {
    for (; facet_rounds_ < kConformLimits.rounds && !c_.delaunay.nonconforming.empty();
         ++facet_rounds_)
      if (!insert_at(nonconforming_facets(c_.delaunay))) return;
  }

  /// In a sized mesh, gives interior nodes on faces their supports, and makes nodes on both sides
  /// of thin places mirror images of each other. Returns whether that changed anything.
  bool set_right(std::span<const MeshDefect> defects) {
    if (!sized_) return false;
    const BoundaryModel& boundary = task_.cells.boundary;
    const SizeField& sizes = task_.density.sizes;
    const int stranded = support_stranded_nodes(c_.nodes, defects, boundary, sizes);
    return stranded + OppositeNodes(c_.nodes, boundary, sizes).set(defects) > 0;
  }

  /// Moves or inserts nodes near the defects, and extracts the mesh anew. Returns false where there
  /// is no room for any, or too many have been inserted.
  bool insert_at(std::span<const MeshDefect> defects) {
    const BoundaryModel& boundary = task_.cells.boundary;
    const SizeField& sizes = task_.density.sizes;
    const std::int32_t first = c_.nodes.size();
    if (c_.too_fine) return false;
    if (!set_right(defects)) {
      if (insert_where_missing(c_.nodes, defects, boundary, boundary_.samples, sizes, sized_) == 0)
        return false;
      set_right(defects);
    }
    insert_in_segments(c_.nodes, c_.loop.mesh, first, boundary,
                       {.sizes = sizes, .make_room = sized_}, task_.run);
    inserted_ += c_.nodes.size() - first;
    const double verified = c_.verify_seconds;
    c_ = extract(std::move(c_.nodes), std::move(c_.loop), task_, patch_, boundary_.inside);
    c_.verify_seconds = verified;
    c_.too_fine = inserted_ > most_;
    return true;
  }

  /// Puts the mesh back into the parent's and verifies it. One that is finished `again`, after
  /// nodes were inserted at faults, or a sized one with any nodes inserted is cleaned up only if it
  /// has all of the boundary without that.
  void finish(bool again) {
    const bool clean_up = task_.options.clean_up;
    const bool draft_first = again || (sized_ && inserted_ > 0);
    put_back(!draft_first && clean_up);
    if (draft_first && clean_up && boundary_is_complete(c_.verification)) put_back(true);
  }
  void put_back(bool clean_up) {
    remeshd::put_back(c_, cleaned_up(c_, task_, patch_, clean_up), task_, patch_);
  }

  /// Whether the mesh is not valid, and the last round helped or few faults are left.
  bool is_worth_another_round() {
    if (c_.verification.valid) return false;
    const auto& counts = c_.verification.counts;
    const double faults = std::accumulate(counts.begin(), counts.end(), 0.0);
    const double before = std::exchange(faults_, faults);
    if (!sized_) return true;
    if (faults <= kConformLimits.fewer * before) {
      stalled_.reset();
      return true;
    }
    if (faults > kConformLimits.few) return false;
    if (!stalled_) stalled_ = Stalled{c_, inserted_};
    return true;
  }
  /// Goes back to the mesh after the first round that did not help: nodes inserted since then would
  /// be in the way of the last resort.
  void take_back() {
    stalled_->mesh.verify_seconds = c_.verify_seconds;
    c_ = std::move(stalled_->mesh);
    inserted_ = stalled_->inserted;
  }

  struct Stalled {
    Candidate mesh;
    std::uint32_t inserted;
  };

  Candidate& c_;
  const MeshingTask& task_;
  const MeshPatch& patch_;
  const SampledBoundary& boundary_;
  bool sized_;  ///< not even: even meshes are to stay as older versions made them
  std::uint32_t most_;
  std::uint32_t inserted_ = 0;
  int facet_rounds_ = 0;
  double faults_ = HUGE_VAL;        ///< of the mesh verified last
  std::optional<Stalled> stalled_;  ///< the mesh after the first round that did not help
};

}  // namespace

double few_more_nodes(double nodes) {
  return kConformLimits.few_inserted + kConformLimits.most_inserted * nodes;
}

std::uint32_t conform(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                      const SampledBoundary& boundary) {
  return Conforming(c, task, patch, boundary).conform();
}

}  // namespace remeshd

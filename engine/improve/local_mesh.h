#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// The tets round one edge a-b in turning order: tet i is (a, b, node[i], node[i + 1]), positive.
/// `closed` for an edge of the interior (then the last tet ends at node[0] again); an open ring
/// begins and ends at the two boundary facets.
struct EdgeRing {
  static constexpr int kMaxTets = 12;
  int tets = 0;
  int nodes = 0;  ///< tets, or tets + 1 where open
  bool closed = false;
  std::array<std::int32_t, kMaxTets> tet{};
  std::array<std::int32_t, kMaxTets + 1> node{};
};

/// A tet mesh under local operations: the list of each node's tets is kept up to date, everything
/// else (rings, neighbours) is found through it. New tets take the slots of those they replace,
/// then older gaps, the latest first, so that untouched tets keep their place and the same
/// operations give the same bytes.
class LocalMesh {
 public:
  /// `locked`: nodes with smaller numbers are at a patch's interface: they stay, and so do the
  /// edges and the facets of the hull between them. The callers see to that.
  explicit LocalMesh(const TetMesh& mesh, std::int32_t locked = 0, const Run& run = {});

  [[nodiscard]] bool locked(std::int32_t node) const { return node < locked_; }

  [[nodiscard]] const std::vector<Vec3>& nodes() const { return nodes_; }
  [[nodiscard]] const Vec3& node(std::int32_t n) const { return nodes_[n]; }
  /// Number of slots; some may be empty.
  [[nodiscard]] std::int32_t slots() const { return static_cast<std::int32_t>(tets_.size()); }
  [[nodiscard]] bool used(std::int32_t t) const { return tets_[t][0] >= 0; }
  [[nodiscard]] const Tet& tet(std::int32_t t) const { return tets_[t]; }
  /// Volume-length measure, computed when first asked for.
  [[nodiscard]] double quality(std::int32_t t) const;
  /// Grows whenever the slot's tet or one of its nodes' positions changes.
  [[nodiscard]] std::uint32_t stamp(std::int32_t t) const { return stamps_[t]; }
  /// Grows whenever a tet at the node is made, goes or changes. Taking back a trial takes back the
  /// growth by its moves, too: a stamp read within a trial means nothing after it.
  [[nodiscard]] std::uint32_t star_stamp(std::int32_t node) const { return star_stamps_[node]; }
  [[nodiscard]] std::span<const std::int32_t> tets_of(std::int32_t node) const {
    return {pool_.data() + lists_[node].begin, static_cast<std::size_t>(lists_[node].size)};
  }
  /// The tet on the other side of the facet with these nodes; -1 on the boundary.
  [[nodiscard]] std::int32_t across(std::int32_t t, std::int32_t a, std::int32_t b,
                                    std::int32_t c) const;
  [[nodiscard]] bool joined(std::int32_t a, std::int32_t b) const;
  /// Post: false where the edge has no tet, more than `max_tets`, or no single ring.
  bool ring(std::int32_t a, std::int32_t b, int max_tets, EdgeRing& out) const;

  /// Replaces tets by others; appends the slots of the fresh ones to `slots`.
  void replace(std::span<const std::int32_t> old_tets, std::span<const Tet> fresh,
               std::vector<std::int32_t>& slots);
  void move(std::int32_t node, const Vec3& position);

  /// From now on changes can be taken back.
  void begin_trial();
  /// Ends the trial and keeps what it changed.
  void keep_trial();
  /// Ends the trial and takes back all that it changed: the same tets stand in the same slots, and
  /// with the same stamps.
  void undo_trial();

  /// The tets in use, in the order of their slots.
  [[nodiscard]] TetMesh result() const;

 private:
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();
  struct List {
    std::int32_t begin = 0, size = 0, capacity = 0;
  };
  /// What taking back one change of a trial needs: of a move the node and its position before, of a
  /// replacement both slots and the old tets.
  struct Change {
    std::int32_t node = -1;
    Vec3 position;
    std::vector<std::int32_t> old_slots, fresh_slots;
    std::vector<Tet> old_tets;
    std::int32_t slots = 0;  ///< how many there were
  };
  void set_position(std::int32_t node, const Vec3& position, std::int32_t stamps);
  void take_back(const Change& change);
  void link(std::int32_t node, std::int32_t t);
  void unlink(std::int32_t node, std::int32_t t);

  std::int32_t locked_;
  std::vector<Vec3> nodes_;
  std::vector<Tet> tets_;  ///< an empty slot has -1 in its first place
  mutable std::vector<double> qualities_;
  std::vector<std::uint32_t> stamps_, star_stamps_;
  std::vector<List> lists_;  ///< by node: where its tets are in `pool_`
  std::vector<std::int32_t> pool_;
  std::vector<std::int32_t> gaps_;
  bool on_trial_ = false;
  std::vector<Change> changes_;
};

}  // namespace remeshd

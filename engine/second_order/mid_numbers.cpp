#include "engine/second_order/mid_numbers.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "engine/mesh/tet_mesh.h"

namespace remeshd {

namespace {

using Edge = std::array<std::int32_t, 2>;
using TetMids = std::array<std::int32_t, 6>;

Edge edge_of(const Tet& tet, int k) {
  const std::int32_t a = tet[kTetEdges[k][0]], b = tet[kTetEdges[k][1]];
  return {std::min(a, b), std::max(a, b)};
}

/// The place of an edge in a tet that the original does not have.
struct EdgePlace {
  Edge edge;
  std::int32_t tet;
  int k;  ///< of the tet's edges
};

/// Mid-nodes of the original by the nodes that their edges' corners are now.
class OriginalMids {
 public:
  /// Of edges both of whose corners are among `places`.
  OriginalMids(const OutputMesh& output, const OutputMesh& original,
               const std::vector<EdgePlace>& places) {
    if (original.mids.edges.empty()) return;
    std::vector<std::int32_t> now(original.mesh.nodes.size(), -1);
    for (const EdgePlace& place : places)
      for (const std::int32_t node : place.edge)
        if (const std::int32_t o = output.map.original_node[node]; o >= 0) now[o] = node;
    original.mids.edges.for_each([&](std::size_t mid, const Edge& e) {
      const std::int32_t a = now[e[0]], b = now[e[1]];
      if (a >= 0 && b >= 0)
        known_.push_back({{std::min(a, b), std::max(a, b)}, static_cast<std::int32_t>(mid)});
    });
    std::ranges::sort(known_, {}, &Known::edge);
  }
  /// -1: there is none.
  [[nodiscard]] std::int32_t of(const Edge& edge) const {
    const auto found = std::ranges::lower_bound(known_, edge, {}, &Known::edge);
    return found != known_.end() && found->edge == edge ? found->mid : -1;
  }

 private:
  struct Known {
    Edge edge;
    std::int32_t mid;
  };
  std::vector<Known> known_;
};

/// The original's mid-nodes of a tet that the original has too, with the same nodes in the same
/// order; nothing of others.
std::optional<TetMids> kept_mids(const OutputMesh& output, const OutputMesh& original,
                                 std::size_t t, const Tet& tet) {
  if (original.mids.of_tets.empty()) return std::nullopt;
  std::int32_t was = output.map.original_tet[t];
  // A tet with a node that moved is not mapped to the original's, but may have its number.
  if (was < 0) was = static_cast<std::int32_t>(t);
  if (static_cast<std::size_t>(was) >= original.mids.of_tets.size()) return std::nullopt;
  const Tet& corners = original.mesh.tets[was];
  for (int k = 0; k < 4; ++k)
    if (output.map.original_node[tet[k]] != corners[k]) return std::nullopt;
  return original.mids.of_tets[was];
}

/// Gives out numbers: mid-nodes of the original keep theirs where it is below the number of edges,
/// the others get what is left.
class Numbering {
 public:
  /// `kept`: mid-nodes of the original, ascending; `others`: how many there are beside them.
  Numbering(const std::vector<std::int32_t>& kept, std::size_t originals, std::size_t others)
      : size_(kept.size() + others), number_(originals, -1), taken_(size_, 0) {
    for (const std::int32_t mid : kept)
      if (static_cast<std::size_t>(mid) < size_) {
        number_[mid] = mid;
        taken_[mid] = 1;
      }
    for (const std::int32_t mid : kept)
      if (number_[mid] < 0) number_[mid] = next();
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::int32_t of_original(std::int32_t mid) const { return number_[mid]; }
  /// Takes the lowest free number.
  std::int32_t next() {
    while (taken_[free_] != 0) ++free_;
    taken_[free_] = 1;
    return static_cast<std::int32_t>(free_);
  }

 private:
  std::size_t size_;
  std::vector<std::int32_t> number_;  ///< by mid-node of the original
  std::vector<std::uint8_t> taken_;
  std::size_t free_ = 0;
};

}  // namespace

MidNumbers number_mids(const OutputMesh& output, const OutputMesh& original, const Run& run) {
  Polling poll(run);
  const std::size_t originals = original.mids.edges.size();
  MidNumbers numbers;
  numbers.of_tets.resize(output.mesh.tets.size());  // first of all by the original's numbers
  std::vector<EdgePlace> places;
  std::vector<std::uint8_t> is_kept(originals, 0);
  output.mesh.tets.for_each([&](std::size_t t, const Tet& tet) {
    poll();
    if (const auto mids = kept_mids(output, original, t, tet)) {
      numbers.of_tets[t] = *mids;
      for (const std::int32_t mid : *mids) is_kept[mid] = 1;
      return;
    }
    for (int k = 0; k < 6; ++k)
      places.push_back({edge_of(tet, k), static_cast<std::int32_t>(t), k});
  });
  std::ranges::sort(places, {}, [](const EdgePlace& p) { return std::tuple(p.edge, p.tet, p.k); });
  const OriginalMids known(output, original, places);
  std::int32_t others = 0;  // new edges are numbered from -1 downwards for now
  for (std::size_t k = 0; k < places.size(); ++k) {
    poll();
    const EdgePlace& place = places[k];
    std::int32_t& mid = numbers.of_tets[place.tet][place.k];
    if (k > 0 && places[k - 1].edge == place.edge) {
      mid = numbers.of_tets[places[k - 1].tet][places[k - 1].k];
      continue;
    }
    mid = known.of(place.edge);
    if (mid >= 0) {
      is_kept[mid] = 1;
    } else {
      mid = --others;
    }
  }
  std::vector<std::int32_t> kept;
  for (std::size_t mid = 0; mid < originals; ++mid)
    if (is_kept[mid] != 0) kept.push_back(static_cast<std::int32_t>(mid));
  Numbering numbering(kept, originals, static_cast<std::size_t>(-others));
  std::vector<std::int32_t> of_new(static_cast<std::size_t>(-others));
  for (std::int32_t& number : of_new) number = numbering.next();
  numbers.edges.resize(numbering.size());
  numbers.original.assign(numbering.size(), -1);
  output.mesh.tets.for_each([&](std::size_t t, const Tet& tet) {
    poll();
    for (int k = 0; k < 6; ++k) {
      std::int32_t& mid = numbers.of_tets[t][k];
      const std::int32_t was = mid;
      mid = was >= 0 ? numbering.of_original(was) : of_new[-1 - was];
      numbers.edges[mid] = edge_of(tet, k);
      numbers.original[mid] = std::max(was, -1);
    }
  });
  return numbers;
}

}  // namespace remeshd

#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/cellular/boundary_model/support.h"

namespace remeshd {

/// What the optimisation may do with a node (Sect. 7): a frozen one is a free one that has come to
/// rest.
enum class NodeState : std::uint8_t { Fixed, Free, Frozen };

/// Which mesh nodes are copied from: that of the parent, or the patch that was cut out of it.
enum class CopiedFrom { Parent, Patch };

/// The nodes of a mesh to be: new ones, and copies of nodes of the parent's mesh or of the patch,
/// in whose numbers `original` is.
///
/// Inv: all arrays are equally long; a fixed node never moves; for new nodes `original` and
/// `transform` are both -1.
template <CopiedFrom>
struct Nodes {
  std::vector<Vec3> positions;
  std::vector<Support> supports;
  std::vector<NodeState> state;
  std::vector<std::int32_t> original;   ///< number of the node that it copies
  std::vector<std::int32_t> transform;  ///< index into CopyPlan::transforms
  /// Number of the patch's interface nodes. They come first, are fixed and have tets outside of it.
  std::int32_t interface_nodes = 0;
  std::int32_t elsewhere = 0;  ///< number of the parent's nodes that are not in the patch

  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(positions.size()); }
  [[nodiscard]] bool is_free(std::int32_t n) const { return state[n] == NodeState::Free; }
  [[nodiscard]] std::uint32_t count(NodeState which) const {
    return static_cast<std::uint32_t>(std::ranges::count(state, which));
  }
  /// `from`, `by`: the node that it is a copy of and its transformation, -1 for new ones.
  void add(const Vec3& p, const Support& support, NodeState as, std::int32_t from,
           std::int32_t by) {
    positions.push_back(p);
    supports.push_back(support);
    state.push_back(as);
    original.push_back(from);
    transform.push_back(by);
  }
  void add_new(const Vec3& p, const Support& support = {}) {
    add(p, support, NodeState::Free, -1, -1);
  }
  /// Overwrites the node `to` with the node `from`.
  void move(std::int32_t from, std::int32_t to) {
    positions[to] = positions[from];
    supports[to] = supports[from];
    state[to] = state[from];
    original[to] = original[from];
    transform[to] = transform[from];
  }
  void resize(std::int32_t count) {
    positions.resize(count);
    supports.resize(count);
    state.resize(count);
    original.resize(count);
    transform.resize(count);
  }
};

/// What the plan makes of the parent's nodes, with new ones (Sects. 6 and 7).
using CopiedNodes = Nodes<CopiedFrom::Parent>;
/// The nodes that the optimisation works on (Sect. 8).
using NodeSet = Nodes<CopiedFrom::Patch>;

}  // namespace remeshd

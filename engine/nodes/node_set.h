#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/cellular/boundary_model/support.h"

namespace remeshd {

/// What the optimisation may do with a node (Sect. 7): a frozen one is a free one that has come to
/// rest.
enum class NodeState : std::uint8_t { Fixed, Free, Frozen };

/// The nodes that the optimisation works on.
///
/// Inv: all arrays are equally long; a fixed node never moves; `original` and `transform` are -1
/// both for new nodes.
struct NodeSet {
  std::vector<Vec3> positions;
  std::vector<Support> supports;
  std::vector<NodeState> state;
  std::vector<std::int32_t> original;   ///< index in the Patch's nodes of what it copies
  std::vector<std::int32_t> transform;  ///< index into CopyPlan::transforms
  /// Interface nodes of a patch come first: fixed, some of their tets are not in it. Their number.
  std::int32_t interface_nodes = 0;
  std::int32_t elsewhere = 0;  ///< nodes of the mesh that are not in the set

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
  /// Puts a node in the place of another.
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

}  // namespace remeshd

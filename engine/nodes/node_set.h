#pragma once

#include <cstdint>
#include <vector>

#include "engine/cellular/boundary_model/support.h"

namespace remeshd {

/// The nodes that the optimisation works on.
///
/// Inv: all arrays are equally long; a fixed node never moves; `original` and `transform` are -1
/// both for new nodes.
struct NodeSet {
  std::vector<Vec3> positions;
  std::vector<Support> supports;
  std::vector<std::uint8_t> free;       ///< 1: moved by the optimisation (Sect. 7)
  std::vector<std::int32_t> original;   ///< index in the Patch's nodes of what it copies
  std::vector<std::int32_t> transform;  ///< index into CopyPlan::transforms
  /// Interface nodes of a patch come first: fixed, some of their tets are not in it. Their number.
  std::int32_t interface_nodes = 0;
  std::int32_t elsewhere = 0;  ///< nodes of the mesh that are not in the set

  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(positions.size()); }
  /// `from`, `by`: the node that it is a copy of and its transformation, -1 for new ones.
  void add(const Vec3& p, const Support& support, bool is_free, std::int32_t from,
           std::int32_t by) {
    positions.push_back(p);
    supports.push_back(support);
    free.push_back(is_free ? 1 : 0);
    original.push_back(from);
    transform.push_back(by);
  }
  void add_new(const Vec3& p, const Support& support = {}) { add(p, support, true, -1, -1); }
  /// Puts a node in the place of another.
  void move(std::int32_t from, std::int32_t to) {
    positions[to] = positions[from];
    supports[to] = supports[from];
    free[to] = free[from];
    original[to] = original[from];
    transform[to] = transform[from];
  }
  void resize(std::int32_t count) {
    positions.resize(count);
    supports.resize(count);
    free.resize(count);
    original.resize(count);
    transform.resize(count);
  }
};

}  // namespace remeshd

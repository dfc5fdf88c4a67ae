#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "engine/base/run.h"
#include "engine/base/vec.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// The edge length that a size field has at each node, evaluated again only at nodes that moved.
class NodeLengths {
 public:
  explicit NodeLengths(SizeField sizes) : sizes_(std::move(sizes)) {}

  /// Brings the lengths up to date; there may be more nodes than before.
  void follow(const std::vector<Vec3>& positions, const Run& run);

  /// Whether the length is the same at all nodes.
  [[nodiscard]] bool even() const { return sizes_.even(); }
  /// The edge length where nothing asks for a shorter one.
  [[nodiscard]] double base() const { return sizes_.base(); }
  /// Pre: the node was there when the lengths were brought up to date.
  [[nodiscard]] double operator[](std::size_t node) const {
    return even() ? base() : known_[node].length;
  }

 private:
  struct Known {
    Vec3 at;
    double length = -1;  ///< -1: not evaluated yet
  };

  SizeField sizes_;
  std::vector<Known> known_;  ///< by node; empty where the field is even
};

}  // namespace remeshd

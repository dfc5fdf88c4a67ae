#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/cellular/boundary_model/support.h"

namespace remeshd {

/// The model faces that a node with a given support lies on, looked up fast.
class FacesOf {
 public:
  explicit FacesOf(const BoundaryModel& boundary);

  /// Ascending face indices: the face itself, those of the edge, those round the vertex; none in
  /// the interior.
  [[nodiscard]] std::span<const int> operator()(const Support& support) const;

  /// The first plane that all these supports share, else the lowest face, -1 if there is none.
  [[nodiscard]] int common(std::span<const Support> supports) const;

 private:
  std::vector<int> face_;  ///< identity, so that a face gives a span too
  std::vector<std::vector<int>> edge_, vertex_;
  std::vector<std::uint8_t> plane_;  ///< by face: whether it is one
};

}  // namespace remeshd

#pragma once

#include <algorithm>
#include <vector>

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/changes.h"
#include "engine/local_fuse/prisms/parallel_prisms.h"
#include "engine/model/solid.h"

namespace remeshd {

/// What of some boundary parts meets the boxes round what changed.
struct TouchedParts {
  std::vector<char> edges, faces;

  TouchedParts(const BoundaryParts& parts, const std::vector<Box>& boxes) {
    for (const kernel::BrepEdge& edge : parts.brep.edges) edges.push_back(touches(boxes, edge));
    for (int f = 0; f < static_cast<int>(parts.pieces.size()); ++f)
      faces.push_back(face_meets(parts, f, boxes));
  }

 private:
  /// A round face or a frame may go all round a box: a part of it has to meet one.
  [[nodiscard]] bool face_meets(const BoundaryParts& parts, int f,
                                const std::vector<Box>& boxes) const {
    const BoundaryPiece& piece = parts.pieces[f];
    const kernel::BrepFace& face = parts.brep.faces[f];
    return touch(boxes, piece.box) &&
           (std::ranges::any_of(face.edges, [&](int e) { return edges[e] != 0; }) ||
            touches(boxes, parts.brep, face, piece.surface));
  }
};

inline bool is_plane(const BoundaryPiece& piece) {
  return piece.surface.kind == Surface::Kind::Plane;
}

/// The parts of a boundary with those that meet the boxes of the changes replaced by fused ones.
/// `touched`: of `base` with these boxes; `membership`: of the edited model.
///
/// Gives up where what comes out does not fit together or the material is in more than one piece.
Tried<BoundaryParts> replace_parts(const BoundaryParts& base, const Changes& changes,
                                   const FusedPrisms& fused, const TouchedParts& touched,
                                   const Membership& membership);

}  // namespace remeshd

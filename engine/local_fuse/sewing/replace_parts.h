#pragma once

#include <algorithm>
#include <vector>

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/changes.h"
#include "engine/local_fuse/prisms/parallel_prisms.h"
#include "engine/model/solid.h"

namespace remeshd {

/// Which edges and faces of some boundary parts meet the boxes round what changed, by number.
struct TouchedParts {
  std::vector<char> edges, faces;

  TouchedParts(const BoundaryParts& parts, const std::vector<Box>& boxes) {
    for (const kernel::BrepEdge& edge : parts.brep.edges) edges.push_back(touches(boxes, edge));
    for (int f = 0; f < static_cast<int>(parts.pieces.size()); ++f)
      faces.push_back(face_meets(parts, f, boxes));
  }

 private:
  /// Whether a face meets one of the boxes. That its own bounding box does is not enough: a round
  /// face, or one with a hole, may go round a box without meeting it. So one of the edges or
  /// triangles of the face must meet a box, too.
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

/// The boundary parts of an edited model: those of its base, with those that meet the boxes of the
/// changes replaced by fused ones. `touched`: which of `base` meet these boxes; `membership`: of
/// the edited model.
///
/// Gives up where what comes out does not fit together or the material is in more than one piece.
Tried<BoundaryParts> replace_parts(const BoundaryParts& base, const Changes& changes,
                                   const FusedPrisms& fused, const TouchedParts& touched,
                                   const Membership& membership);

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <span>

#include "engine/base/region.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// For each page of tets the box round their nodes: it tells which pages a search of some place may
/// skip.
CowVector<Box> boxes_round(const PagedMesh& mesh);

/// The same from the boxes of another mesh: only pages with changed tets are measured again. Pre:
/// all other tets are those of the other mesh under the same numbers, with their nodes in place.
CowVector<Box> boxes_round(const PagedMesh& mesh, CowVector<Box> other,
                           std::span<const std::int32_t> changed_tets);

/// Tells which pages of tets may use nodes that stand at given places in another mesh. A page whose
/// memory is shared with the other mesh is tested by its box there; any other page may use them.
class PagesNear {
 public:
  /// `boxes`: those of the other mesh's pages of tets. Keeps references to `other` and `boxes`.
  PagesNear(const CowVector<Tet>& other, const CowVector<Box>& boxes, std::span<const Vec3> places);

  /// Post: true where the page is not shared with the other mesh.
  [[nodiscard]] bool may_be(const CowVector<Tet>& tets, std::size_t page) const;

 private:
  const CowVector<Tet>& other_;
  const CowVector<Box>& boxes_;
  Region region_;
};

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <span>

#include "engine/base/region.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// Boxes round the nodes of tets, one for each page of them: which pages need not be looked at for
/// what is elsewhere.
CowVector<Box> boxes_round(const PagedMesh& mesh);

/// Another mesh's boxes, but for the pages that have one of the changed tets. All other tets are
/// the other mesh's of the same number in place.
CowVector<Box> boxes_round(const PagedMesh& mesh, CowVector<Box> other,
                           std::span<const std::int32_t> changed_tets);

/// Which pages of tets may have nodes that stand at some places in another mesh, whose memory they
/// may share.
class PagesNear {
 public:
  /// `boxes`: round the other's tets. Keeps references to both.
  PagesNear(const CowVector<Tet>& other, const CowVector<Box>& boxes, std::span<const Vec3> places);

  /// Post: true where the page is not the other's memory.
  [[nodiscard]] bool may_be(const CowVector<Tet>& tets, std::size_t page) const;

 private:
  const CowVector<Tet>& other_;
  const CowVector<Box>& boxes_;
  Region region_;
};

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/region.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// Boxes round the nodes of tets, one for each page of them: which pages need not be looked at for
/// what is elsewhere.
Pages<Box> boxes_round(const PagedMesh& mesh);

/// Another mesh's boxes, but for the pages that have one of the changed tets. All other tets are
/// the other mesh's of the same number in place.
Pages<Box> boxes_round(const PagedMesh& mesh, Pages<Box> other,
                       std::span<const std::int32_t> changed_tets);

/// Which pages of tets may have nodes that stand at some places in another mesh, whose memory they
/// may share.
class PagesAt {
 public:
  /// `boxes`: round the other's tets. Keeps references to both.
  PagesAt(const Pages<Tet>& other, const Pages<Box>& boxes, std::span<const Vec3> places);

  /// Post: true where the page is not the other's memory.
  [[nodiscard]] bool may_be(const Pages<Tet>& tets, std::size_t page) const;

 private:
  const Pages<Tet>& other_;
  const Pages<Box>& boxes_;
  Region region_;
};

}  // namespace remeshd

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/cow_vector.h"
#include "engine/base/vec.h"
#include "engine/delaunay/delaunay_mesh.h"

namespace remeshd {

/// A Delaunay mesh as a revision keeps it: in pages that it shares with the meshes made out of it.
/// It is changed by cutting out a patch as a DelaunayMesh, changing that and putting it back.
class PagedDelaunay {
 public:
  using Corners = DelaunayMesh::Corners;

  PagedDelaunay() = default;
  /// Takes over a mesh, its tets sorted by their lowest node: so tets that are near in space are
  /// near in memory if their nodes are. `to` is filled in: for each slot of `mesh` the slot here,
  /// -1 for free ones.
  PagedDelaunay(const DelaunayMesh& mesh, std::vector<std::int32_t>& to);

  /// How a patch is connected to the mesh that it was cut out of.
  struct Cut {
    std::vector<std::int32_t> slots;  ///< by slot of the patch: its slot in the whole
    std::vector<FacetRef> exterior;   ///< facets of other tets, across its boundary
  };
  /// The tets in some slots as a mesh of their own, to be changed and put back. `names`: by node of
  /// the whole, its node in the patch, below `count`. Fills in `cut`.
  [[nodiscard]] DelaunayMesh cut(std::span<const std::int32_t> slots,
                                 std::span<const std::int32_t> names, std::int32_t count,
                                 Cut& cut) const;
  /// Puts a changed patch back in the place of the tets that were cut out; a mesh without tets
  /// takes over all of the patch, as the constructor does. `names`: by node of the patch, its node
  /// here, below `count`, -1 where no tet of the patch has it. Returns by slot of the patch the
  /// slot here, -1 for free ones, and further -1 where more slots were cut out than the patch has.
  /// Pre: `patch.patch_too_small()` is false; tets outside of the patch use nodes that keep their
  /// numbers.
  std::vector<std::int32_t> put_back(const DelaunayMesh& patch, const Cut& cut,
                                     std::span<const std::int32_t> names, std::int32_t count);

  /// Renumbers the nodes from `count` on, which leaves `count` nodes: node n becomes
  /// `names[n - count]`, which no other node has and which is below `count`; -1 for nodes that are
  /// in no tet.
  void rename_last(std::span<const std::int32_t> names, std::int32_t count);

  /// Compacts the slots, in their order, and gives back the memory of free ones. Returns by old
  /// slot the new one, -1 for free ones.
  std::vector<std::int32_t> close_gaps();

  /// Where the nodes are.
  [[nodiscard]] const CowVector<Vec3>& positions() const { return points_; }
  /// Whether a slot holds a tet, which may be at a super vertex.
  [[nodiscard]] bool in_use(std::int32_t slot) const {
    return slots_[slot].v[0] != DelaunayMesh::kDead;
  }
  /// A tet's nodes; negative for the super vertices.
  [[nodiscard]] Corners corners(std::int32_t slot) const {
    const auto& v = slots_[slot].v;
    return {v[0] - kSuper, v[1] - kSuper, v[2] - kSuper, v[3] - kSuper};
  }
  /// The circumball of a tet, to within rounding.
  struct Ball {
    Vec3 centre;
    double radius;  ///< infinite or not a number where the tet is flat
  };
  [[nodiscard]] Ball ball(std::int32_t slot) const;

  [[nodiscard]] std::size_t slots() const { return slots_.size(); }
  /// Calls f(slot) for all tets of the pages whose box (round the nodes of their tets) `meets`
  /// accepts: so for all tets with a node at a place, and some more.
  template <class Meets, class F>
  void for_each_slot_near(Meets&& meets, F&& f) const {
    for (std::size_t k = 0; k < boxes_.size(); ++k)
      if (!boxes_[k].empty() && meets(boxes_[k])) for_each_slot_of_page(k, f);
  }
  /// Number of tets, those at the super vertices included.
  [[nodiscard]] std::size_t size() const { return slots_.size() - free_.size(); }

  /// For storing; `visit_named` has all else that makes up the mesh.
  [[nodiscard]] const std::array<Vec3, DelaunayMesh::kSuper>& super_vertices() const {
    return super_;
  }
  [[nodiscard]] std::array<Vec3, DelaunayMesh::kSuper>& super_vertices() { return super_; }
  /// Calls f(name, array) for all arrays of the mesh; their names are part of the stored format.
  template <class F>
  void visit_named(F&& f) {
    visit_named(*this, f);
  }
  template <class F>
  void visit_named(F&& f) const {
    visit_named(*this, f);
  }
  /// Whether all indices are those of existing nodes and slots, and neighbours agree: to be asked
  /// of a mesh that was read from storage.
  [[nodiscard]] bool consistent() const;
  /// Calls f with the arrays that grow with the mesh.
  template <class F>
  void visit_arrays(F&& f) const {
    f(points_, slots_, free_, boxes_);
  }

 private:
  using Slot = DelaunayMesh::Slot;
  static constexpr std::int32_t kSuper = DelaunayMesh::kSuper;

  template <class Self, class F>
  static void visit_named(Self& self, F&& f) {
    f("delaunay.points", self.points_);
    f("delaunay.slots", self.slots_);
    f("delaunay.free", self.free_);
    f("delaunay.boxes", self.boxes_);
  }

  [[nodiscard]] const Vec3& point(std::int32_t vertex) const {
    return vertex < kSuper ? super_[vertex] : points_[vertex - kSuper];
  }
  std::int32_t allocate();
  /// Takes over the slots of `from`; `to`: by its slot the slot here, below `count`, -1 for free
  /// ones.
  template <class Slots>
  void take_over(const Slots& from, std::span<const std::int32_t> to, std::size_t count);
  /// Computes the boxes of the pages of these slots again.
  void measure_pages(std::span<const std::int32_t> slots);
  void measure_page(std::size_t page);
  template <class F>
  void for_each_slot_of_page(std::size_t page, F&& f) const {
    const std::size_t begin = page * CowVector<Slot>::kPage;
    const std::size_t end = begin + slots_.page(page).size();
    for (std::size_t s = begin; s < end; ++s)
      if (slots_[s].v[0] != DelaunayMesh::kDead) f(static_cast<std::int32_t>(s));
  }

  std::array<Vec3, kSuper> super_;
  CowVector<Vec3> points_;  ///< by node
  CowVector<Slot> slots_;
  std::vector<std::int32_t> free_;
  std::vector<Box> boxes_;  ///< by page of tets: round their nodes
};

}  // namespace remeshd

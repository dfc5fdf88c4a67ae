#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "engine/base/run.h"
#include "engine/base/vec.h"
#include "engine/mesh/facet_ref.h"

namespace remeshd {

/// Delaunay tetrahedralisation in flat arrays, by incremental insertion (Bowyer 1981, Watson 1981)
/// with exact predicates, inside a tetrahedron far around the points.
///
/// Copying one copies a few arrays. So the mesh of the fixed nodes is kept, and where free nodes
/// have moved too far to be followed they are inserted into a copy of it (Sect. 8: "initialise the
/// mesh with the free and fixed nodes"). The mesh of the fixed nodes in turn is the parent's with
/// nodes removed.
///
/// Inv: the tets are those of the Delaunay mesh of the inserted nodes and four super vertices;
/// where five nodes or more share an empty sphere, one of the possible meshes. A patch has some of
/// these tets (PagedDelaunay::cut).
class DelaunayMesh {
 public:
  /// A tet's corners: node indices, negative for the super vertices.
  using Corners = std::array<std::int32_t, 4>;

  explicit DelaunayMesh(const Box& bounds);
  /// An empty mesh without super vertices. Nothing can be inserted; assign to it first, or let
  /// PagedDelaunay::cut fill it with a patch.
  DelaunayMesh() = default;

  /// Whether the box lies well within the super tetrahedron, so that nodes anywhere in it may be
  /// inserted.
  [[nodiscard]] bool encloses(const Box& box) const;

  /// A mesh without nodes inside the same super vertices. For a patch of a larger mesh it has
  /// patch_too_small() set, since a patch cannot be emptied.
  [[nodiscard]] DelaunayMesh emptied() const {
    DelaunayMesh mesh{std::span<const Vec3>(points_)};
    mesh.patch_too_small_ = !exterior_.empty();
    return mesh;
  }

  /// Inserts nodes at `positions[node]`, in the order of `insertion_order`. A node at the very
  /// place of an inserted one is left out. Stops once patch_too_small(). Pre: none of them is
  /// inserted yet.
  void insert(std::span<const Vec3> positions, std::span<const std::int32_t> nodes, const Run& run);

  /// Inserts nodes of another mesh that were moved as one rigid body, to `positions`: tets between
  /// them are taken over as they are where these are Delaunay here. `names`: by node of `from`, its
  /// node here, -1 for those that do not come. Pre: none of them is inserted yet.
  void insert_moved(const DelaunayMesh& from, std::span<const std::int32_t> names,
                    std::span<const Vec3> positions, const Run& run);

  /// Removes inserted nodes: the holes that their tets leave are filled with tets of the Delaunay
  /// mesh of the nodes round the holes. Returns false, and changes nothing, where these do not fit
  /// into the holes, as with nodes on a common empty sphere or removed nodes at a patch's boundary;
  /// the mesh has to be built anew then.
  [[nodiscard]] bool remove(std::span<const std::int32_t> nodes, const Run& run);

  enum class Moved {
    Done,
    TooFar,  ///< for flips to follow; nothing is changed: `reinsert` them, or build anew
    Failed,  ///< nodes could not be taken out; the mesh is unusable: build anew
  };
  /// Moves inserted nodes to `positions[node]` and makes the mesh Delaunay again: by flips, for
  /// nodes that can move with every tet staying positive; by removing and reinserting the few
  /// others.
  [[nodiscard]] Moved move(std::span<const Vec3> positions, std::span<const std::int32_t> nodes,
                           const Run& run);

  /// Moves inserted nodes by removing and reinserting all of them. Returns false, and changes
  /// nothing, where they cannot be removed.
  [[nodiscard]] bool reinsert(std::span<const Vec3> positions, std::span<const std::int32_t> nodes,
                              const Run& run);

  /// Where an inserted node is.
  [[nodiscard]] const Vec3& position(std::int32_t node) const { return points_[node + kSuper]; }
  /// Where all of them are.
  [[nodiscard]] std::span<const Vec3> positions() const {
    return std::span(points_).subspan(kSuper);
  }

  /// Whether a change to a patch may have had to reach beyond its boundary; such a patch must not
  /// be put back.
  [[nodiscard]] bool patch_too_small() const { return patch_too_small_; }
  /// Whether a slot holds a tet, which may be at a super vertex.
  [[nodiscard]] bool in_use(std::int32_t slot) const { return slots_[slot].v[0] != kDead; }
  /// A tet's nodes; negative for the super vertices.
  [[nodiscard]] Corners corners(std::int32_t slot) const {
    const auto& v = slots_[slot].v;
    return {v[0] - kSuper, v[1] - kSuper, v[2] - kSuper, v[3] - kSuper};
  }
  /// Slots of the tets opposite a tet's corners, which may be at super vertices; negative where
  /// there is none.
  [[nodiscard]] Corners across(std::int32_t slot) const {
    const auto& n = slots_[slot].n;
    return {n[0].tet(), n[1].tet(), n[2].tet(), n[3].tet()};
  }
  /// Which of PagedDelaunay::Cut::exterior lies across the facet opposite a corner; -1 unless the
  /// facet is on the boundary of a patch.
  [[nodiscard]] std::int32_t exterior(std::int32_t slot, int corner) const {
    const FacetRef across = slots_[slot].n[corner];
    return across.is_beyond() ? across.exterior() : -1;
  }
  /// Renumbers every node n to `names[n]`, below `count`; nodes with a negative name are dropped.
  /// Pre: names of inserted nodes are not negative; those not negative are distinct.
  void rename(std::span<const std::int32_t> names, std::int32_t count);

  /// Calls f(corners) for every tet that has no super vertex.
  template <class F>
  void for_each_tet(F&& f) const {
    for_each_tet_with_neighbours([&](auto, const Corners& tet, const Corners&) { f(tet); });
  }
  /// The same as f(slot, corners, across), by `across(slot)`. Slots are below `slots()`.
  template <class F>
  void for_each_tet_with_neighbours(F&& f) const {
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      const Slot& s = slots_[k];
      if (s.v[0] >= kSuper && s.v[1] >= kSuper && s.v[2] >= kSuper && s.v[3] >= kSuper)
        f(static_cast<std::int32_t>(k), corners(static_cast<std::int32_t>(k)),
          across(static_cast<std::int32_t>(k)));
    }
  }
  [[nodiscard]] std::size_t slots() const { return slots_.size(); }
  /// Number of tets, those at the super vertices included.
  [[nodiscard]] std::size_t size() const { return slots_.size() - free_.size(); }

 private:
  friend class PagedDelaunay;

  static constexpr std::int32_t kSuper = 4;  ///< vertices below are the super vertices
  static constexpr std::int32_t kDead = -1;

  struct Slot {
    /// Written out, because the `==` of a std::array is a library call.
    friend bool operator==(const Slot& a, const Slot& b) {
      std::int32_t differ = 0;
      for (int i = 0; i < 4; ++i) differ |= (a.v[i] ^ b.v[i]) | (a.n[i].code() ^ b.n[i].code());
      return differ == 0;
    }
    template <class A>
    void serialize(A& archive) {
      archive(v, n);
    }
    /// Which of `v` a vertex is, -1 for none.
    [[nodiscard]] int corner_of(std::int32_t vertex) const {
      for (int i = 0; i < 4; ++i)
        if (v[i] == vertex) return i;
      return -1;
    }
    /// What is across the facet opposite a vertex of the tet.
    [[nodiscard]] FacetRef across(std::int32_t vertex) const { return n[corner_of(vertex)]; }
    std::array<std::int32_t, 4> v;  ///< vertices, positively oriented; v[0] == kDead: free slot
    /// By corner i, the other side of the facet opposite v[i]: the same facet of the tet across;
    /// none on the outside of the super tetrahedron; or, beyond a patch, an index into
    /// PagedDelaunay::Cut::exterior.
    std::array<FacetRef, 4> n;
  };
  struct CavityFacet {                   ///< a facet of the cavity, seen from inside
    FacetRef outer;                      ///< its other side
    std::array<std::int32_t, 3> v;       ///< oriented so that (v, new point) is positive
    std::array<std::int32_t, 3> name{};  ///< of v, numbered within the cavity
    std::int32_t tet = -1;               ///< the new tet on it
  };
  struct EdgeEntry {
    std::uint64_t key;
    FacetRef facet;
    std::uint32_t epoch;
  };

  static constexpr std::size_t kEdgeTable = 256;
  static constexpr std::int32_t kFewVertices = 64;  ///< of a cavity; with more, by hashing

  /// Working memory of insertions, kept for the next one; copies of a mesh begin without.
  struct Scratch {
    Scratch() = default;
    Scratch(const Scratch&) {}
    Scratch(Scratch&&) = default;
    Scratch& operator=(const Scratch&) { return *this = Scratch(); }
    Scratch& operator=(Scratch&&) = default;
    ~Scratch() = default;

    /// Forgets what slots were marked as.
    void begin(std::size_t slots) {
      ++epoch;
      if (seen.size() < slots) seen.resize(slots, 0);
    }

    std::vector<std::uint32_t> seen;  ///< by slot: a mark, which counts in its epoch only
    std::uint32_t epoch = 0;
    std::vector<std::int32_t> cavity;
    std::vector<CavityFacet> cavity_facets;
    struct Name {
      std::uint32_t epoch;
      std::int32_t name;
    };
    std::vector<Name> names;  ///< by vertex
    /// By pairs of names, the directed edges of the cavity's boundary: the facet between this edge
    /// and the new vertex, of the new tet that has the edge in this direction.
    std::vector<FacetRef> at_edge =
        std::vector<FacetRef>(static_cast<std::size_t>(kFewVertices) * kFewVertices);
    std::vector<EdgeEntry> edges = std::vector<EdgeEntry>(kEdgeTable);
  };

  struct HoleFacet {                  ///< a facet round a hole, seen from inside
    std::array<std::int32_t, 3> key;  ///< its vertices, ascending
    FacetRef outer;                   ///< its other side
    std::array<std::int32_t, 3> v;

    static std::array<std::int32_t, 3> key_of(std::int32_t a, std::int32_t b, std::int32_t c) {
      const std::int32_t low = std::min({a, b, c}), high = std::max({a, b, c});
      return {low, a ^ b ^ c ^ low ^ high, high};
    }
    /// By outer too: the same three nodes may bound holes on both sides.
    friend bool operator<(const HoleFacet& a, const HoleFacet& b) {
      // Written out, because the `<` of a std::array is a library call.
      return std::tie(a.key[0], a.key[1], a.key[2], a.outer) <
             std::tie(b.key[0], b.key[1], b.key[2], b.outer);
    }
    [[nodiscard]] bool has_key(const std::array<std::int32_t, 3>& k) const {
      return key[0] == k[0] && key[1] == k[1] && key[2] == k[2];
    }
  };
  struct Fill {  ///< a tet of the filling that lies in a hole
    std::int32_t tet;
    std::array<std::int32_t, 4> facet;  ///< by corner: the hole's facet opposite, or -1
  };

  /// Tets of another mesh that are to be taken over into this one.
  struct RigidBlock {
    std::vector<std::int32_t> nodes;  ///< nodes whose tets are all in the block
    std::vector<std::int32_t> tets;
    std::vector<std::int32_t> number;  ///< by slot of the other mesh: index in `tets`, or -1
    std::vector<HoleFacet> facets;  ///< round the tets, with vertices here; `outer`: tet by index
  };

  explicit DelaunayMesh(std::span<const Vec3> super_vertices);
  static RigidBlock rigid_block_of(const DelaunayMesh& from, std::span<const std::int32_t> names);
  /// Replaces the tets within the facets of the block by its own. Returns false, and changes
  /// nothing, where the result would not be Delaunay.
  bool transplant(const DelaunayMesh& from, const RigidBlock& block,
                  std::span<const std::int32_t> names, const Run& run);
  /// The tets of `filling` within the facets; nothing where these do not bound a part of it.
  static std::optional<std::vector<Fill>> match_hole(const DelaunayMesh& filling,
                                                     const std::vector<HoleFacet>& facets,
                                                     const Run& run);
  /// The tets with a moved vertex.
  [[nodiscard]] std::vector<std::int32_t> tets_at_moved(const std::vector<std::uint8_t>& roles,
                                                        const Run& run) const;
  /// Moves vertices of inverted or flat tets back to `old` until there are no such tets; their
  /// roles become kHeld. Returns their nodes.
  std::vector<std::int32_t> revert_inverted(std::span<const std::int32_t> touched,
                                            std::vector<std::uint8_t>& roles,
                                            const std::vector<Vec3>& old, const Run& run);
  /// Moves held nodes one by one after all, where that leaves their tets positive; the others stay
  /// in `held`.
  void retry(std::span<const std::int32_t> touched, std::span<const Vec3> positions,
             std::vector<std::uint8_t>& roles, std::vector<std::int32_t>& held, const Run& run);
  /// Flips facets that are not locally Delaunay, beginning with those of the touched tets. Adds to
  /// `unflipped` those that could not be flipped when they were tried; later flips may have helped.
  void flip_all(std::span<const std::int32_t> touched, std::vector<FacetRef>& unflipped,
                const Run& run);
  /// The vertex opposite a facet of a tet.
  [[nodiscard]] std::int32_t apex(FacetRef f) const { return slots_[f.tet()].v[f.corner()]; }
  /// Its position; also for a facet beyond the boundary of a patch.
  [[nodiscard]] const Vec3& apex_position(FacetRef f) const {
    return f.is_beyond() ? exterior_[f.exterior()] : points_[apex(f)];
  }
  /// The other side of a facet of a tet.
  [[nodiscard]] FacetRef across(FacetRef f) const { return slots_[f.tet()].n[f.corner()]; }
  /// Makes `other`, which may be no tet's, the other side of a facet of a tet.
  void join(FacetRef facet, FacetRef other) {
    slots_[facet.tet()].n[facet.corner()] = other;
    if (other.is_tet()) slots_[other.tet()].n[other.corner()] = facet;
  }
  /// Whether a facet is locally Delaunay; also at the boundary of a patch.
  [[nodiscard]] bool is_delaunay(FacetRef facet) const;
  /// Flips the facet unless it is locally Delaunay or gone; at the boundary of a patch, where it
  /// cannot, it sets patch_too_small(). Returns false where no flip was possible.
  bool flip(FacetRef facet, std::vector<FacetRef>& stack);
  /// Whether the tet is positive with `vertex` at the corner.
  [[nodiscard]] bool positive_with(std::int32_t tet, int corner, std::int32_t vertex) const;
  void flip_2_3(FacetRef facet, std::vector<FacetRef>& stack);
  bool flip_3_2(std::int32_t tet, std::int32_t a, std::int32_t b, std::vector<FacetRef>& stack);
  bool flip_4_4(FacetRef facet, std::int32_t s, std::vector<FacetRef>& stack);

  /// False where the vertex is left out: at the place of another, or outside of the patch.
  bool insert_one(std::int32_t vertex);
  /// The tet that holds p; -1 where it is not in the patch.
  [[nodiscard]] std::int32_t locate(const Vec3& p) const;
  [[nodiscard]] std::int32_t walk(std::int32_t from, const Vec3& p) const;
  /// Whether p lies inside the circumsphere of the tet.
  [[nodiscard]] bool conflicts(std::int32_t tet, const Vec3& p) const;
  std::int32_t allocate();
  void release(std::int32_t slot) {
    slots_[slot].v[0] = kDead;
    free_.push_back(slot);
  }
  /// Numbers the vertices of the cavity's boundary and returns their number.
  std::int32_t number_cavity_vertices();
  /// Connects the new tets on the cavity's boundary across its edges, by a table of pairs of names.
  void connect_small_cavity();
  /// The same for cavities of any size, by a hash table of edges.
  void connect_large_cavity();
  void connect(FacetRef facet, std::int32_t a, std::int32_t b);

  std::vector<Vec3> points_;  ///< by vertex
  std::vector<Slot> slots_;
  std::vector<std::int32_t> free_;
  std::int32_t hint_ = 0;
  std::vector<Vec3> exterior_;  ///< of a patch: apexes of the tets across its boundary
  bool patch_too_small_ = false;

  Scratch scratch_;
};

}  // namespace remeshd

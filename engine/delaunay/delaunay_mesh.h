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
/// Copying one is a copy of three arrays: the mesh of the fixed nodes is kept, and where the free
/// ones have moved too far they are inserted into a copy of it (Sect. 8: "initialise the mesh with
/// the free and fixed nodes"). That mesh in turn comes from the original's by taking nodes out.
///
/// Inv: the tets are those of the Delaunay mesh of the inserted nodes and four super vertices;
/// where five nodes or more share an empty sphere, one of the possible meshes.
class DelaunayMesh {
 public:
  /// A tet's corners: node indices, negative for the super vertices.
  using Corners = std::array<std::int32_t, 4>;

  explicit DelaunayMesh(const Box& bounds);
  /// Only to be filled by `visit_state`.
  DelaunayMesh() = default;

  /// Whether nodes anywhere in the box are well within the super vertices.
  [[nodiscard]] bool encloses(const Box& box) const;

  /// A mesh without nodes inside the same super vertices. A patch is too small for that.
  [[nodiscard]] DelaunayMesh emptied() const {
    DelaunayMesh mesh{std::span<const Vec3>(points_)};
    mesh.patch_too_small_ = !exterior_.empty();
    return mesh;
  }

  /// Inserts nodes at `positions[node]`, in an order along a space-filling curve of its own choice.
  /// A node at the very place of an inserted one stays out.
  /// Pre: none of them is inserted yet.
  void insert(std::span<const Vec3> positions, std::span<const std::int32_t> nodes, const Run& run);

  /// Inserts nodes of another mesh at other places, to where they were moved as one rigid body:
  /// what is the same mesh among them comes along as it is. `names`: by node of `from`, its node
  /// here, -1 for those that do not come.
  /// Pre: none of them is inserted yet.
  void insert_moved(const DelaunayMesh& from, std::span<const std::int32_t> names,
                    std::span<const Vec3> positions, const Run& run);

  /// Takes inserted nodes out again: the tets at them leave holes, which are filled with tets of
  /// the Delaunay mesh of the nodes round the holes. Returns false, and leaves everything as it
  /// was, where these do not fit, which takes nodes on a common empty sphere; build anew then.
  [[nodiscard]] bool remove(std::span<const std::int32_t> nodes, const Run& run);

  enum class Moved {
    Done,
    TooFar,  ///< for flips to follow; nothing is changed: `reinsert` them, or build anew
    Failed,  ///< nodes could not be taken out; the mesh is unusable: build anew
  };
  /// Moves inserted nodes to `positions[node]` and makes the mesh Delaunay again: by flips where
  /// the moves leave every tet positive, by taking the few others out and putting them in again.
  [[nodiscard]] Moved move(std::span<const Vec3> positions, std::span<const std::int32_t> nodes,
                           const Run& run);

  /// The same by taking all of them out and putting them in again. Returns false, and leaves
  /// everything as it was, where they cannot be taken out.
  [[nodiscard]] bool reinsert(std::span<const Vec3> positions, std::span<const std::int32_t> nodes,
                              const Run& run);

  /// Where an inserted node is.
  [[nodiscard]] const Vec3& position(std::int32_t node) const { return points_[node + kSuper]; }
  /// Where all of them are.
  [[nodiscard]] std::span<const Vec3> positions() const {
    return std::span(points_).subspan(kSuper);
  }

  /// Whether a change to a patch may have had to go on beyond its boundary: the patch is not to be
  /// put back then.
  [[nodiscard]] bool patch_too_small() const { return patch_too_small_; }
  /// Whether a slot holds a tet, which may be at a super vertex.
  [[nodiscard]] bool in_use(std::int32_t slot) const { return slots_[slot].v[0] != kDead; }
  /// A tet's nodes; negative for the super vertices.
  [[nodiscard]] Corners corners(std::int32_t slot) const {
    const auto& v = slots_[slot].v;
    return {v[0] - kSuper, v[1] - kSuper, v[2] - kSuper, v[3] - kSuper};
  }
  /// Across the facet opposite a corner, which of PagedDelaunay::Cut::exterior there is; -1 where
  /// none of them.
  [[nodiscard]] std::int32_t exterior(std::int32_t slot, int corner) const {
    const FacetRef across = slots_[slot].n[corner];
    return across.is_beyond() ? across.exterior() : -1;
  }
  /// Renames every node n to `names[n]`.
  /// Pre: names of inserted nodes are not negative, those that are not are distinct; `count` is
  /// above all of them.
  void rename(std::span<const std::int32_t> names, std::int32_t count);

  /// Calls f(corners) for every tet that has no super vertex.
  template <class F>
  void for_each_tet(F&& f) const {
    for_each_tet_with_neighbours([&](auto, const Corners& tet, const Corners&) { f(tet); });
  }
  /// The same as f(slot, corners, across): `across[i]` is the slot of the tet opposite corner i,
  /// that of a super vertex's perhaps, below 0 where there is none. Slots are below `slots()`.
  template <class F>
  void for_each_tet_with_neighbours(F&& f) const {
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      const Slot& s = slots_[k];
      if (s.v[0] >= kSuper && s.v[1] >= kSuper && s.v[2] >= kSuper && s.v[3] >= kSuper)
        f(static_cast<std::int32_t>(k), corners(static_cast<std::int32_t>(k)),
          Corners{s.n[0].tet(), s.n[1].tet(), s.n[2].tet(), s.n[3].tet()});
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
    /// Not as arrays, whose comparison is a call.
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
    std::array<FacetRef, 4> n;      ///< across the facet opposite v[i]: that of the tet there; or
                                    ///< beyond a patch: of PagedDelaunay::Cut::exterior
  };
  struct CavityFacet {                   ///< a facet of the cavity, seen from inside
    FacetRef outer;                      ///< its other side
    std::array<std::int32_t, 3> v;       ///< oriented so that (v, new point) is positive
    std::array<std::int32_t, 3> name{};  ///< of the vertices, among those of the cavity
    std::int32_t tet = -1;               ///< that comes to stand on it
  };
  struct EdgeEntry {
    std::uint64_t key;
    FacetRef facet;
    std::uint32_t epoch;
  };

  static constexpr std::size_t kEdgeTable = 256;
  static constexpr std::int32_t kFewVertices = 64;  ///< that have a place each by pairs

  /// Of one insertion, kept for its memory; copies of a mesh begin without.
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
    /// By pairs of names: the facet opposite the third vertex of the tet that stands on this edge.
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
    /// The same three nodes may bound holes on both sides.
    friend bool operator<(const HoleFacet& a, const HoleFacet& b) {
      // Not as arrays, whose comparison is a call.
      return std::tie(a.key[0], a.key[1], a.key[2], a.outer) <
             std::tie(b.key[0], b.key[1], b.key[2], b.outer);
    }
    [[nodiscard]] bool has_key(const std::array<std::int32_t, 3>& k) const {
      return key[0] == k[0] && key[1] == k[1] && key[2] == k[2];
    }
  };
  struct Fill {  ///< a tet of the filling that lies in a hole, and the facets it touches
    std::int32_t tet;
    std::array<std::int32_t, 4> facet;
  };

  /// Tets of another mesh that are to stand here.
  struct RigidBlock {
    std::vector<std::int32_t> nodes;  ///< that have no other tets
    std::vector<std::int32_t> tets;
    std::vector<std::int32_t> number;  ///< by slot there: which of `tets`, or -1
    std::vector<HoleFacet> facets;     ///< round them, over vertices here
  };

  explicit DelaunayMesh(std::span<const Vec3> super_vertices);
  static RigidBlock rigid_block_of(const DelaunayMesh& from, std::span<const std::int32_t> names);
  /// Puts the tets in the place of those within the facets. Returns false, and leaves everything as
  /// it was, where that would not be Delaunay.
  bool transplant(const DelaunayMesh& from, const RigidBlock& block,
                  std::span<const std::int32_t> names, const Run& run);
  static std::optional<std::vector<Fill>> match_hole(const DelaunayMesh& filling,
                                                     const std::vector<HoleFacet>& facets,
                                                     const Run& run);
  /// The tets with a moved vertex.
  [[nodiscard]] std::vector<std::int32_t> tets_at_moved(const std::vector<std::uint8_t>& roles,
                                                        const Run& run) const;
  /// Puts moved vertices back, from `old`, until no tet is inverted; their roles become kHeld.
  /// Returns their nodes.
  std::vector<std::int32_t> revert_inverted(std::span<const std::int32_t> touched,
                                            std::vector<std::uint8_t>& roles,
                                            const std::vector<Vec3>& old, const Run& run);
  /// Moves those of the held nodes that can go one by one after all; the others stay in `held`.
  void retry(std::span<const std::int32_t> touched, std::span<const Vec3> positions,
             std::vector<std::uint8_t>& roles, std::vector<std::int32_t>& held, const Run& run);
  /// Flips facets that are not locally Delaunay, from those of the touched tets. Adds the facets
  /// that resisted when they were looked at.
  void flip_all(std::span<const std::int32_t> touched, std::vector<FacetRef>& unflipped,
                const Run& run);
  /// The vertex opposite a facet of a tet.
  [[nodiscard]] std::int32_t apex(FacetRef f) const { return slots_[f.tet()].v[f.corner()]; }
  /// Where it is; also of a facet beyond the boundary of a patch.
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
  /// Returns whether the facet is locally Delaunay now or gone, or at the patch's boundary, where
  /// it is noted that the patch has been left.
  bool flip(FacetRef facet, std::vector<FacetRef>& stack);
  [[nodiscard]] bool positive_with(std::int32_t tet, int corner, std::int32_t vertex) const;
  void flip_2_3(FacetRef facet, std::vector<FacetRef>& stack);
  bool flip_3_2(std::int32_t tet, std::int32_t a, std::int32_t b, std::vector<FacetRef>& stack);
  bool flip_4_4(FacetRef facet, std::int32_t s, std::vector<FacetRef>& stack);

  bool insert_one(std::int32_t vertex);
  [[nodiscard]] std::int32_t locate(const Vec3& p) const;
  [[nodiscard]] std::int32_t walk(std::int32_t from, const Vec3& p) const;
  [[nodiscard]] bool conflicts(std::int32_t tet, const Vec3& p) const;
  std::int32_t allocate();
  void release(std::int32_t slot) {
    slots_[slot].v[0] = kDead;
    free_.push_back(slot);
  }
  /// Numbers the vertices of the cavity's boundary and returns their number.
  std::int32_t number_cavity_vertices();
  /// Connects the tets on the cavity's boundary, which share its edges, by pairs of names.
  void connect_small_cavity();
  /// The same for any number, by a hash of edges.
  void connect_large_cavity();
  void connect(FacetRef facet, std::int32_t a, std::int32_t b);

  std::vector<Vec3> points_;  ///< by vertex
  std::vector<Slot> slots_;
  std::vector<std::int32_t> free_;
  std::int32_t hint_ = 0;
  std::vector<Vec3> exterior_;  ///< of a patch: corners of the tets across its boundary
  bool patch_too_small_ = false;

  Scratch scratch_;
};

}  // namespace remeshd

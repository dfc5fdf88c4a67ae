#include "engine/local_fuse/prisms/parallel_prisms.h"

#include <algorithm>

#include "engine/local_fuse/arrangement/slabs.h"
#include "engine/local_fuse/prisms/parallel_prism_edges.h"

namespace remeshd {
namespace {

using kernel::BrepFace;

class SweptParts {
 public:
  SweptParts(const Sweeps& sweeps, const PlanarArrangement& arrangement, const Slabs& slabs,
             const FuseFrame& frame)
      : sweeps_(sweeps),
        arrangement_(arrangement),
        slabs_(slabs),
        frame_(frame),
        edges_(sweeps, arrangement, slabs) {}

  /// Gives up where an upright border of a round wall is not a single edge.
  Tried<FusedPrisms> build() {
    for (int p = 0; p < static_cast<int>(arrangement_.pieces.size()); ++p) {
      for (int slab = 1; slab < slabs_.heights(); ++slab) {
        if (!slabs_.boundary(p, slab)) continue;
        int last = slab;
        while (last + 1 < slabs_.heights() && slabs_.passes(p, last)) ++last;
        add_wall(p, slab, last);
        slab = last;
      }
      for (int height = 0; height < slabs_.heights(); ++height) add_level_faces(p, height);
    }
    if (!simple_)
      return GaveUp{"parallel_prisms", "a vertex lies on the upright side of a round wall"};
    kernel::Brep brep = edges_.finish(std::move(faces_));
    brep.scale = frame_.scale;
    brep.reference = *frame_.reference;
    put_edges_in_canonical_order(brep);
    for (std::size_t f = 0; f < pieces_.size(); ++f)
      pieces_[f].box = box_of(brep, brep.faces[f], pieces_[f].surface);
    return FusedPrisms{{std::move(brep), std::move(pieces_)}, std::move(along_)};
  }

 private:
  /// The names and surface of a face; `covers`: the feature faces on it, `behind`: the sweeps that
  /// own the material behind it.
  BoundaryPiece named(std::vector<ArrangementCover> covers, const std::vector<int>& behind) const {
    BoundaryPiece piece;
    piece.boundary = true;
    std::ranges::sort(covers, std::ranges::greater{}, &ArrangementCover::sweep);
    for (const ArrangementCover& cover : covers) {
      const bool owns = std::ranges::binary_search(behind, cover.sweep);
      auto& names = owns ? piece.material_names : piece.other_names;
      if (names.empty() && (owns || piece.material_names.empty()))
        piece.surface = cover.face->surface;  // of the first material name, else of the first other
      names.push_back({sweeps_.sweeps[cover.sweep].feature, cover.face->name});
    }
    return piece;
  }

  void add_wall(int p, int first, int last) {
    const ArrangementEdge& outline = arrangement_.pieces[p];
    const Slabs::Column &left = slabs_.left(p, first), &right = slabs_.right(p, first);
    std::vector<ArrangementCover> covers;
    for (const ArrangementCover& cover : outline.covers)
      if (slabs_.active(cover.sweep, first)) covers.push_back(cover);
    BoundaryPiece piece = named(covers, left.material ? left.owners : right.owners);
    std::vector<int> edges{edges_.level(p, first - 1), edges_.level(p, last)};
    edges_.add_upright(outline.a, first, last, edges);
    edges_.add_upright(outline.b, first, last, edges);
    if (outline.round)
      return add_round(p, first - 1, last, std::move(piece), std::move(edges), left.material);
    const Vec3 d = arrangement_.nodes[outline.b] - arrangement_.nodes[outline.a];
    const Vec3 to_right = sweeps_.frame.rotate({d.y, -d.x, 0});
    add_to_plane(piece, left.material ? to_right : -to_right, edges);
  }

  /// A round wall between two heights, a strip of triangles.
  void add_round(int p, int low, int high, BoundaryPiece piece, std::vector<int> edges,
                 bool material_left) {
    const ArrangementEdge& outline = arrangement_.pieces[p];
    const std::vector<int>& below = edges_[edges[0]].chain;
    const std::vector<int>& above = edges_[edges[1]].chain;
    // A vertex within an upright border would be missing from the strip.
    if (edges.size() != 4) simple_ = false;
    BrepFace face;
    face.cells = {0, -1};
    for (std::size_t i = 0; i + 1 < below.size(); ++i) {
      face.triangles.push_back({below[i], below[i + 1], above[i + 1]});
      face.triangles.push_back({below[i], above[i + 1], above[i]});
    }
    if (!material_left)
      for (auto& t : face.triangles) std::swap(t[1], t[2]);
    const double height = slabs_.z(high) - slabs_.z(low), r = outline.radius;
    // The integral over the angle of the unit vectors away from the axis; nought of a whole circle.
    const Vec3 a = arrangement_.nodes[outline.a], b = arrangement_.nodes[outline.b];
    const Vec3 outward = sweeps_.frame.rotate(Vec3{b.y - a.y, a.x - b.x, 0} / r);
    const Vec3 centre = edges_.place(outline.centre, low) + (0.5 * height) * edges_.axis();
    face.area = outline.angle * r * height;
    face.centroid = centre + (r / outline.angle) * outward;
    face.swept_volume = (material_left ? 1 : -1) * height * r / 3 *
                        (r * outline.angle + dot(centre - *frame_.reference, outward));
    face.edges = std::move(edges);
    faces_.push_back(std::move(face));
    pieces_.push_back(std::move(piece));
    along_.push_back(material_left ? 1 : 0);  // a cylinder's normal points away from its axis
  }

  /// Adds the edge on a piece at a height to the level faces on its left and right.
  void add_level_faces(int p, int height) {
    const auto &lb = slabs_.left(p, height), &rb = slabs_.right(p, height);
    const auto &la = slabs_.left(p, height + 1), &ra = slabs_.right(p, height + 1);
    if (lb.owners == rb.owners && la.owners == ra.owners) return;
    for (const auto& [below, above] : {std::pair(&lb, &la), std::pair(&rb, &ra)}) {
      if (below->material == above->material) continue;
      std::vector<ArrangementCover> covers;
      for (const auto* column : {below, above})
        for (const int s : column->owners) {
          const bool other =
              std::ranges::binary_search(column == below ? above->owners : below->owners, s);
          const Sweep& sweep = sweeps_.sweeps[s];
          if (!other) covers.push_back({s, column == below ? sweep.top : sweep.bottom, true});
        }
      add_to_plane(named(covers, below->material ? below->owners : above->owners),
                   below->material ? edges_.axis() : -edges_.axis(), {edges_.level(p, height)});
    }
  }

  /// Adds edges to the face that stands for all with this plane, outward direction and names; makes
  /// the face if need be.
  void add_to_plane(const BoundaryPiece& piece, const Vec3& outward,
                    const std::vector<int>& edges) {
    const bool along = dot(outward, piece.surface.frame.rotate({0, 0, 1})) > 0;
    std::size_t f = 0;
    while (f < pieces_.size() && !((along_[f] != 0) == along && pieces_[f].continues(piece))) ++f;
    if (f == pieces_.size()) {
      faces_.emplace_back().cells = {0, -1};
      pieces_.push_back(piece);
      along_.push_back(along ? 1 : 0);
    }
    std::vector<int>& all = faces_[f].edges;
    all.insert(all.end(), edges.begin(), edges.end());
  }

  const Sweeps& sweeps_;
  const PlanarArrangement& arrangement_;
  const Slabs& slabs_;
  const FuseFrame& frame_;
  ParallelPrismEdges edges_;
  std::vector<BrepFace> faces_;
  std::vector<BoundaryPiece> pieces_;
  std::vector<char> along_;
  bool simple_ = true;
};

}  // namespace

Tried<FusedPrisms> fuse_parallel_prisms(const FeatureModel& model, const Membership& membership,
                                        std::span<const int> features, const FuseFrame& frame) {
  const auto sweeps = find_sweeps(model, membership, features);
  if (!sweeps) return sweeps.why();
  Box box;
  for (const int f : features) box.add(membership.solids()[f].bounds());
  const auto arrangement = arrange(*sweeps, membership, box.diagonal());
  if (!arrangement) return arrangement.why();
  const auto slabs = Slabs::find(*sweeps, *arrangement, membership, box.diagonal());
  if (!slabs) return slabs.why();
  return SweptParts(*sweeps, *arrangement, *slabs, frame).build();
}

}  // namespace remeshd

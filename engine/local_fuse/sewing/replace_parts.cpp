#include "engine/local_fuse/sewing/replace_parts.h"

#include <map>

#include "engine/base/tolerance.h"
#include "engine/base/union_find.h"
#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/local_fuse/sewing/plane_face.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::BrepEdge;
using kernel::BrepFace;

constexpr double kSamePoint = 20;  // x the CAD kernel's own tolerance, 0.1 kernel_tolerance

class Sewing {
 public:
  Sewing(const BoundaryParts& base, const Changes& changes, const FusedPrisms& fused,
         const TouchedParts& touched)
      : base_(base),
        changes_(changes),
        fused_(fused.parts),
        fused_along_(fused.along),
        touched_(touched) {
    out_.brep.scale = fused_.brep.scale;
    out_.brep.reference = base.brep.reference;
    same_point_ = kSamePoint * 0.1 * kernel_tolerance(fused_.brep);
  }

  /// Gives up where it does not fit together.
  Tried<BoundaryParts> sew(const Membership& membership) {
    keep_edges();
    const TouchedParts fused_meeting(fused_, changes_.boxes);
    if (const auto kept = keep_faces(); !kept) return kept.why();
    if (const auto taken = take_edges(fused_meeting); !taken) return taken.why();
    if (const auto taken = take_faces(fused_meeting, membership); !taken) return taken.why();
    if (const auto rebuilt = rebuild_planes(membership); !rebuilt) return rebuilt.why();
    if (const auto closed = check_closed(); !closed) return closed.why();
    if (!one_piece()) return GaveUp{"replace_parts", "the material is not in one piece"};
    put_in_canonical_order(out_);
    return std::move(out_);
  }

 private:
  /// Numbers in the result of what was taken over from the base or from the fuse; -1: was not.
  struct Taken {
    std::vector<int> vertices, edges, points;
    explicit Taken(const Brep& brep)
        : vertices(brep.vertices.size(), -1),
          edges(brep.edges.size(), -1),
          points(brep.points.size(), -1) {}
  };

  int add_vertex(const Vec3& p) {
    out_.brep.vertices.push_back({p});
    return static_cast<int>(out_.brep.vertices.size()) - 1;
  }
  int take_point(const Brep& from, Taken& taken, int p) {
    int& number = taken.points[p];
    if (number < 0) {
      number = static_cast<int>(out_.brep.points.size());
      out_.brep.points.push_back(from.points[p]);
    }
    return number;
  }

  /// Takes over the edges of the base that meet no box, with their vertices.
  void keep_edges() {
    const Brep& from = base_.brep;
    for (std::size_t e = 0; e < from.edges.size(); ++e) {
      if (touched_.edges[e]) continue;
      kept_.edges[e] = static_cast<int>(out_.brep.edges.size());
      BrepEdge edge = from.edges[e];
      for (int& v : edge.vertices) {
        int& number = kept_.vertices[v];
        if (number < 0) number = add_vertex(from.vertices[v].position);
        v = number;
      }
      out_.brep.edges.push_back(std::move(edge));
    }
    kept_vertices_ = static_cast<int>(out_.brep.vertices.size());
    kept_edges_ = static_cast<int>(out_.brep.edges.size());
  }

  /// Puts the edited model's feature numbers into the names; false where one was not kept.
  [[nodiscard]] bool rename(BoundaryPiece& piece) const {
    for (auto* names : {&piece.material_names, &piece.other_names})
      for (FaceName& name : *names) {
        name.feature = changes_.kept[name.feature];
        if (name.feature < 0) return false;
      }
    return true;
  }

  Tried<void> keep_faces() {
    for (std::size_t f = 0; f < base_.pieces.size(); ++f) {
      if (touched_.faces[f]) continue;
      BrepFace face = base_.brep.faces[f];
      for (int& e : face.edges) {
        e = kept_.edges[e];
        if (e < 0) return GaveUp{"replace_parts", "a kept face has an edge that the change meets"};
      }
      BoundaryPiece piece = base_.pieces[f];
      if (!rename(piece)) return GaveUp{"replace_parts", "a kept face is one of a changed feature"};
      out_.brep.faces.push_back(std::move(face));
      out_.pieces.push_back(std::move(piece));
    }
    kept_faces_ = static_cast<int>(out_.pieces.size());
    return {};
  }

  /// The number of a vertex of the fuse in the result: of the kept one at the same place, or of a
  /// new one; -1 where two kept ones are near.
  int take_vertex(int v) {
    int& number = taken_.vertices[v];
    if (number >= 0) return number;
    const Vec3& p = fused_.brep.vertices[v].position;
    for (int k = 0; k < kept_vertices_; ++k) {
      if (distance(out_.brep.vertices[k].position, p) > same_point_) continue;
      if (number >= 0) return number = -1;
      number = k;
    }
    if (number < 0) number = add_vertex(p);
    return number;
  }

  /// Adds the edges of the fuse that meet a box; other edges of its round faces have to be among
  /// the kept ones. All points are numbered here, vertices first. `touched`: of the fuse.
  Tried<void> take_edges(const TouchedParts& touched) {
    const Brep& from = fused_.brep;
    std::vector<char> needed(from.edges.size(), 0);
    for (std::size_t e = 0; e < from.edges.size(); ++e) needed[e] = touched.edges[e];
    for (std::size_t f = 0; f < fused_.pieces.size(); ++f)
      if (touched.faces[f] && !is_plane(fused_.pieces[f]))
        for (const int e : from.faces[f].edges) needed[e] = 1;
    for (std::size_t e = 0; e < from.edges.size(); ++e)
      if (needed[e])
        for (const int v : from.edges[e].vertices)
          if (take_vertex(v) < 0)
            return GaveUp{"replace_parts", "a vertex of the fuse is near two of the base"};

    for (const kernel::BrepVertex& v : out_.brep.vertices) out_.brep.points.push_back(v.position);
    for (std::size_t v = 0; v < kept_.vertices.size(); ++v) kept_.points[v] = kept_.vertices[v];
    for (std::size_t v = 0; v < taken_.vertices.size(); ++v) taken_.points[v] = taken_.vertices[v];
    for (int e = 0; e < kept_edges_; ++e)
      for (int& p : out_.brep.edges[e].chain) p = take_point(base_.brep, kept_, p);
    for (int f = 0; f < kept_faces_; ++f)
      for (auto& triangle : out_.brep.faces[f].triangles)
        for (int& p : triangle) p = take_point(base_.brep, kept_, p);

    for (std::size_t e = 0; e < from.edges.size(); ++e) {
      if (!needed[e]) continue;
      if (!touched.edges[e]) {
        if (!find_kept(static_cast<int>(e)))
          return GaveUp{"replace_parts",
                        "an edge of a round face is in the fuse but not in the base"};
        continue;
      }
      taken_.edges[e] = static_cast<int>(out_.brep.edges.size());
      BrepEdge edge = from.edges[e];
      for (int& v : edge.vertices) v = taken_.vertices[v];
      for (int& p : edge.chain) p = take_point(from, taken_, p);
      out_.brep.edges.push_back(std::move(edge));
    }
    return {};
  }

  /// Finds the kept edge with the same vertices, kind and polyline as edge e of the fuse and takes
  /// it for that; false where there is none.
  bool find_kept(int e) {
    const BrepEdge& edge = fused_.brep.edges[e];
    const std::array<int, 2> ends{taken_.vertices[edge.vertices[0]],
                                  taken_.vertices[edge.vertices[1]]};
    for (int k = 0; k < kept_edges_; ++k) {
      const BrepEdge& kept = out_.brep.edges[k];
      if (kept.vertices != ends || kept.kind != edge.kind || kept.chain.size() != edge.chain.size())
        continue;
      bool same = true;
      for (std::size_t i = 0; same && i < edge.chain.size(); ++i)
        same = distance(out_.brep.points[kept.chain[i]], fused_.brep.points[edge.chain[i]]) <=
               same_point_;
      if (!same) continue;
      taken_.edges[e] = k;
      for (std::size_t i = 0; i < edge.chain.size(); ++i)
        taken_.points[edge.chain[i]] = kept.chain[i];
      return true;
    }
    return false;
  }

  Tried<void> take_faces(const TouchedParts& touched, const Membership& membership) {
    for (std::size_t f = 0; f < fused_.pieces.size(); ++f) {
      if (!touched.faces[f] || is_plane(fused_.pieces[f])) continue;
      BrepFace face = fused_.brep.faces[f];
      for (int& e : face.edges) e = taken_.edges[e];
      std::ranges::sort(face.edges);
      for (auto& triangle : face.triangles)
        for (int& p : triangle) p = take_point(fused_.brep, taken_, p);
      if (!parts_material(face, fused_.pieces[f].surface, membership))
        return GaveUp{"replace_parts",
                      "a round face does not have material on its inner side only"};
      out_.brep.faces.push_back(std::move(face));
      out_.pieces.push_back(fused_.pieces[f]);
    }
    return {};
  }

  /// Faces of one plane that the same features cover on the same sides.
  struct Family {
    const BoundaryPiece* piece;
    bool along;
    std::map<int, int> uses;  ///< by edge
    Triangles known;          ///< of the base, that stay; looking outward
  };

  Family& family_of(const BoundaryPiece& piece, bool along) {
    const auto it = std::ranges::find_if(families_, [&](const Family& family) {
      return family.along == along && family.piece->continues(piece);
    });
    if (it != families_.end()) return *it;
    return families_.emplace_back(Family{&piece, along, {}, {}});
  }

  Tried<void> rebuild_planes(const Membership& membership) {
    std::vector<BoundaryPiece> renamed;  // families point into it
    renamed.reserve(base_.pieces.size());
    // Adds a face's edges with numbers from `first` on to its family; null where there are none.
    const auto gather = [&](const BoundaryParts& parts, std::size_t f, const BoundaryPiece& piece,
                            bool along, const std::vector<int>& number, int first) {
      Family* family = nullptr;
      for (const int e : parts.brep.faces[f].edges) {
        if (number[e] < first) continue;
        if (family == nullptr) family = &family_of(piece, along);
        ++family->uses[number[e]];
      }
      return family;
    };
    for (std::size_t f = 0; f < base_.pieces.size(); ++f) {
      if (!touched_.faces[f] || !is_plane(base_.pieces[f])) continue;
      BoundaryPiece& piece = renamed.emplace_back(base_.pieces[f]);
      const bool whole = rename(piece);
      const bool along = looks_along(base_.brep, base_.brep.faces[f], piece.surface);
      Family* family = gather(base_, f, piece, along, kept_.edges, 0);
      if (family == nullptr) continue;
      // A face of a changed feature lies in the feature's box, so that none of its edges is kept.
      if (!whole)
        return GaveUp{"replace_parts", "a plane face of a changed feature has a kept edge"};
      add_known(base_.brep.faces[f], family->known);
    }
    for (std::size_t f = 0; f < fused_.pieces.size(); ++f)
      if (is_plane(fused_.pieces[f]))
        gather(fused_, f, fused_.pieces[f], fused_along_[f] != 0, taken_.edges, kept_edges_);
    for (Family& family : families_)
      if (const auto rebuilt = rebuild(family, membership); !rebuilt) return rebuilt.why();
    return {};
  }

  /// Adds the triangles of a face of the base that stay: all their nodes do, and they meet no box.
  void add_known(const BrepFace& face, Triangles& known) const {
    for (std::array<int, 3> triangle : face.triangles) {
      Box box;
      bool kept = true;
      for (int& p : triangle) {
        box.add(base_.brep.points[p]);
        p = kept_.points[p];
        kept = kept && p >= 0;
      }
      if (kept && !touch(changes_.boxes, box)) known.push_back(triangle);
    }
  }

  Tried<void> rebuild(Family& family, const Membership& membership) {
    std::vector<PlaneEdge> edges;
    for (const auto& [e, uses] : family.uses) edges.push_back({e, uses});
    if (!family.along)
      for (auto& triangle : family.known) std::swap(triangle[1], triangle[2]);
    auto faces = plane_faces(out_.brep, edges, family.piece->surface, family.known);
    if (!faces) faces = plane_faces(out_.brep, edges, family.piece->surface, {});
    if (!faces) return faces.why();
    for (BrepFace& face : *faces) {
      if (!family.along) face.turn_over();
      if (!parts_material(face, family.piece->surface, membership))
        return GaveUp{"replace_parts",
                      "a plane face does not have material on its inner side only"};
      BoundaryPiece piece = *family.piece;
      piece.box = box_of(out_.brep, face, piece.surface);
      out_.brep.faces.push_back(std::move(face));
      out_.pieces.push_back(std::move(piece));
    }
    return {};
  }

  /// Whether there is material behind the face and none in front of it, at its largest triangle.
  [[nodiscard]] bool parts_material(const BrepFace& face, const Surface& surface,
                                    const Membership& membership) const {
    const auto& points = out_.brep.points;
    Vec3 largest, at;
    for (const auto& [a, b, c] : face.triangles) {
      const Vec3 n = cross(points[b] - points[a], points[c] - points[a]);
      if (norm2(n) <= norm2(largest)) continue;
      largest = n;
      at = project(surface, (points[a] + points[b] + points[c]) / 3);
    }
    const Vec3 step = tolerance::kWideProbe * membership.bounds().diagonal() * normalised(largest);
    return membership.inside(at - step) && !membership.inside(at + step);
  }

  /// Checks that two faces meet at every edge in use, and at those of new faces that the two go
  /// along it in opposite directions.
  [[nodiscard]] Tried<void> check_closed() const {
    const Brep& brep = out_.brep;
    std::vector<std::array<int, 2>> directions(brep.edges.size(), {0, 0});
    std::vector<int> uses(brep.edges.size(), 0);
    std::vector<char> watched(brep.edges.size(), 0);  // edges of new faces
    for (std::size_t f = 0; f < brep.faces.size(); ++f)
      for (const int e : brep.faces[f].edges) {
        ++uses[e];
        if (static_cast<int>(f) >= kept_faces_) watched[e] = 1;
      }
    std::vector<std::array<int, 3>> starts;  // first two nodes of watched edges, and the edge
    for (int e = 0; e < static_cast<int>(brep.edges.size()); ++e) {
      if (uses[e] != 0 && uses[e] != 2)
        return GaveUp{"replace_parts", "an edge bounds one face or more than two"};
      if (watched[e]) starts.push_back({brep.edges[e].chain[0], brep.edges[e].chain[1], e});
    }
    std::ranges::sort(starts);
    const auto edge_from = [&](int a, int b) {
      const auto it = std::ranges::lower_bound(starts, std::array{a, b, -1});
      return it != starts.end() && (*it)[0] == a && (*it)[1] == b ? (*it)[2] : -1;
    };
    for (const BrepFace& face : brep.faces) {
      if (std::ranges::none_of(face.edges, [&](int e) { return watched[e] != 0; })) continue;
      for (const auto& t : face.triangles)
        for (int i = 0; i < 3; ++i) {
          const int a = t[i], b = t[(i + 1) % 3];
          if (const int e = edge_from(a, b); e >= 0) ++directions[e][0];
          if (const int e = edge_from(b, a); e >= 0) ++directions[e][1];
        }
    }
    for (std::size_t e = 0; e < brep.edges.size(); ++e)
      if (watched[e] && directions[e] != std::array{1, 1})
        return GaveUp{"replace_parts",
                      "two faces do not go along their edge in opposite directions"};
    return {};
  }

  /// Whether the boundary is that of one body: of its shells one has material inside, the others
  /// bound cavities.
  [[nodiscard]] bool one_piece() const {
    const Brep& brep = out_.brep;
    UnionFind shell(brep.faces.size());
    std::vector<int> face_at(brep.edges.size(), -1);
    for (int f = 0; f < static_cast<int>(brep.faces.size()); ++f)
      for (const int e : brep.faces[f].edges) {
        if (face_at[e] >= 0) shell.join(f, face_at[e]);
        face_at[e] = f;
      }
    std::vector<double> volume(brep.faces.size(), 0);
    for (int f = 0; f < static_cast<int>(brep.faces.size()); ++f)
      volume[shell.find(f)] += brep.faces[f].swept_volume;
    return std::ranges::count_if(volume, [](double v) { return v > 0; }) == 1;
  }

  const BoundaryParts& base_;
  const Changes& changes_;
  const BoundaryParts& fused_;
  const std::vector<char>& fused_along_;
  const TouchedParts& touched_;
  BoundaryParts out_;
  Taken kept_{base_.brep}, taken_{fused_.brep};
  int kept_vertices_ = 0, kept_edges_ = 0, kept_faces_ = 0;
  double same_point_ = 0;
  std::vector<Family> families_;
};

}  // namespace

Tried<BoundaryParts> replace_parts(const BoundaryParts& base, const Changes& changes,
                                   const FusedPrisms& fused, const TouchedParts& touched,
                                   const Membership& membership) {
  return Sewing(base, changes, fused, touched).sew(membership);
}

}  // namespace remeshd

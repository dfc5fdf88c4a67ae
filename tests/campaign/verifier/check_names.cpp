#include <algorithm>
#include <cmath>

#include "tests/campaign/rays.h"
#include "tests/campaign/verifier/mesh_surface.h"
#include "tests/campaign/verifier/verifier.h"
#include "tests/support/flat.h"

namespace remeshd::campaign {
namespace {

constexpr double kOnNamedFace = 1e-6;  // of the diagonal

class NameChecker {
 public:
  NameChecker(const Revision& revision, const std::vector<Triangle>& facets, Findings& findings)
      : revision_(revision),
        mesh_(test::flat(revision.output.mesh)),
        membership_(revision.model),
        tiny_(kOnNamedFace * membership_.bounds().diagonal()),
        rays_(membership_),
        surface_(mesh_, facets, membership_, tiny_),
        findings_(findings) {}

  void check(std::size_t index, const MeshFacet& facet) {
    const auto& groups = revision_.output.groups.facet_groups;
    const Vec3 c =
        (mesh_.nodes[facet.nodes[0]] + mesh_.nodes[facet.nodes[1]] + mesh_.nodes[facet.nodes[2]]) /
        3.0;
    if (facet.group < 0 || facet.group >= static_cast<std::int32_t>(groups.size()) ||
        groups[facet.group].empty()) {
      findings_.add("names", "a facet without a name", c);
      return;
    }
    const Surface* first = nullptr;
    for (const std::string& name : groups[facet.group]) {
      const Surface* surface = surface_of(name, facet);
      if (surface == nullptr) {
        findings_.add("names", "a facet off the face " + name + " that it is named after", c);
        return;
      }
      if (first == nullptr) first = surface;
    }
    check_place(index, facet, *first, c);
  }

 private:
  /// The surface of that name that all nodes of the facet lie on.
  [[nodiscard]] const Surface* surface_of(const std::string& name, const MeshFacet& facet) const {
    const std::size_t dot_at = name.find('.');
    if (dot_at == std::string::npos) return nullptr;
    const int feature = revision_.model.index_of(name.substr(0, dot_at));
    if (feature < 0) return nullptr;
    const std::string face_name = name.substr(dot_at + 1);
    for (const SolidFace& face : membership_.solids()[feature].faces()) {
      if (face.name != face_name) continue;
      const bool on = std::all_of(facet.nodes.begin(), facet.nodes.end(), [&](std::int32_t n) {
        return std::fabs(signed_distance(face.surface, mesh_.nodes[n])) <= tiny_;
      });
      if (on) return &face.surface;
    }
    return nullptr;
  }

  /// Over the middle of the facet, or over one of three points nearer to its corners, the surface
  /// has material behind it and none before it.
  void check_place(std::size_t index, const MeshFacet& facet, const Surface& surface,
                   const Vec3& c) {
    const Vec3& a = mesh_.nodes[facet.nodes[0]];
    const Vec3 n = cross(mesh_.nodes[facet.nodes[1]] - a, mesh_.nodes[facet.nodes[2]] - a);
    const double off = std::fabs(signed_distance(surface, c));
    if (off > surface_.allowed(static_cast<std::int32_t>(index)) + tiny_)
      findings_.add("facet place", "a facet too far from its face", c);
    bool any = false;
    for (int k = -1; k < 3 && !any; ++k) {
      const Vec3 p = project(surface, k < 0 ? c : 0.5 * (c + mesh_.nodes[facet.nodes[k]]));
      Vec3 out = normal(surface, p);
      if (dot(out, n) < 0) out = -out;
      for (const double probe : {tiny_, 0.01 * tiny_})
        any = any || (membership_.inside(p - probe * out) && !membership_.inside(p + probe * out));
    }
    // A chord of a curved rim may cut that far into the face.
    const auto facet_index = static_cast<std::int32_t>(index);
    const double reach =
        2 * std::max(surface_.allowed(facet_index), surface_.rim_rise(facet_index)) + tiny_;
    if (!any && !rays_.boundary_within(project(surface, c), reach))
      findings_.add("facet place", "a facet where the model has no boundary", c);
  }

  const Revision& revision_;
  const TetMesh mesh_;
  const Membership membership_;
  const double tiny_;
  const Rays rays_;
  const MeshSurface surface_;
  Findings& findings_;
};

}  // namespace

/// The delivered facets are the boundary of the mesh, each with its tet; all nodes of a facet lie
/// on each face that it is named after, and the model has its boundary there, chords of rims apart.
void check_names(const Revision& revision, const std::vector<Triangle>& facets,
                 Findings& findings) {
  const MeshGroups& groups = revision.output.groups;
  const PagedMesh& mesh = revision.output.mesh;
  // As smallest node first, turning as before.
  const auto canonical = [](Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  std::vector<Triangle> have, want, named;
  for (const MeshFacet& f : groups.facets) {
    have.push_back(canonical(f.nodes));
    named.push_back(f.nodes);
    const bool known = f.tet >= 0 && f.tet < static_cast<std::int32_t>(mesh.tets.size());
    if (!known || !std::all_of(f.nodes.begin(), f.nodes.end(), [&](std::int32_t n) {
          return std::find(mesh.tets[f.tet].begin(), mesh.tets[f.tet].end(), n) !=
                 mesh.tets[f.tet].end();
        }))
      findings.add("facets", "a facet that is not one of its tet");
  }
  for (const Triangle& t : facets) want.push_back(canonical(t));
  std::sort(have.begin(), have.end());
  std::sort(want.begin(), want.end());
  if (have != want) {
    findings.add("facets", "the facets delivered are not the boundary of the tets");
    return;
  }
  NameChecker checker(revision, named, findings);
  for (std::size_t f = 0; f < groups.facets.size(); ++f) checker.check(f, groups.facets[f]);
}

}  // namespace remeshd::campaign

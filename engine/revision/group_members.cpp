#include "engine/revision/group_members.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <string>

#include "engine/mesh/tet_mesh.h"

namespace remeshd {
namespace {

/// What a group asks of facets on the same faces, or of tets with the same owners, to have them:
/// `always`, that their names are enough, else that one of the conditions holds; nothing() where
/// the group does not name them.
struct Asked {
  bool always = false;
  std::vector<ConditionTest*> conditions;
  [[nodiscard]] bool nothing() const { return !always && conditions.empty(); }
  [[nodiscard]] bool holds(const Vec3& p, const Vec3& normal) const {
    return always ||
           std::ranges::any_of(conditions, [&](auto* test) { return (*test)(p, normal); });
  }
};

/// The terms of one group, with their conditions ready.
class Terms {
 public:
  Terms(const FaceGroup& group, const FeatureModel& model) {
    for (const SelectedFaces& on : group.on) {
      Term& term = terms_.emplace_back();
      term.feature = model.features[on.feature].id;
      for (const std::string& face : on.faces) term.faces.push_back(term.feature + "." + face);
      term.has_material = on.whole && model.features[on.feature].nature == Nature::Additive;
      if (!on.condition.text.empty()) term.test.emplace(on.condition);
    }
  }

  /// Of facets that lie on these model faces.
  [[nodiscard]] Asked of_faces(const std::vector<std::string>& faces) {
    return asked([&](const Term& term) {
      return std::ranges::any_of(faces, [&](const std::string& face) {
        return std::ranges::find(term.faces, face) != term.faces.end();
      });
    });
  }
  /// Of the tets of a cell with these owners.
  [[nodiscard]] Asked of_owners(const std::vector<std::string>& owners) {
    return asked([&](const Term& term) {
      return term.has_material && std::ranges::find(owners, term.feature) != owners.end();
    });
  }

 private:
  struct Term {
    std::string feature;
    std::vector<std::string> faces;  ///< `hole1.wall`
    bool has_material = false;       ///< it names a whole feature, and that adds material
    std::optional<ConditionTest> test;
  };

  template <class Selects>
  [[nodiscard]] Asked asked(const Selects& selects) {
    Asked asked;
    for (Term& term : terms_) {
      if (!selects(term)) continue;
      if (term.test)
        asked.conditions.push_back(&*term.test);
      else
        asked.always = true;
    }
    return asked;
  }

  std::deque<Term> terms_;  ///< a deque, since Asked keeps pointers to tests
};

}  // namespace

std::vector<GroupMembers> group_members(const OutputMesh& output, const FeatureModel& model) {
  const MeshGroups& groups = output.groups;
  const CowVector<Vec3>& nodes = output.mesh.nodes;
  std::vector<GroupMembers> all;
  for (const FaceGroup& group : model.groups) {
    GroupMembers& members = all.emplace_back();
    members.name = group.name;
    Terms terms(group, model);
    std::vector<Asked> of_facets, of_cells;
    for (const auto& faces : groups.facet_groups) of_facets.push_back(terms.of_faces(faces));
    for (const auto& owners : groups.cell_owners) of_cells.push_back(terms.of_owners(owners));
    for (std::size_t f = 0; f < groups.facets.size(); ++f) {
      const Asked& asked = of_facets[groups.facets[f].group];
      if (asked.nothing()) continue;
      const Triangle& t = groups.facets[f].nodes;
      const Vec3 &a = nodes[t[0]], &b = nodes[t[1]], &c = nodes[t[2]];
      if (asked.holds((a + b + c) / 3.0, normalised(cross(b - a, c - a))))
        members.facets.push_back(static_cast<std::int32_t>(f));
    }
    if (std::ranges::all_of(of_cells, &Asked::nothing)) continue;
    groups.tet_cell.for_each([&](std::size_t k, std::int32_t cell) {
      if (!of_cells[cell].nothing() &&
          of_cells[cell].holds(centroid(nodes, output.mesh.tets[k]), {}))
        members.tets.push_back(static_cast<std::int32_t>(k));
    });
  }
  return all;
}

}  // namespace remeshd

#include <algorithm>
#include <array>
#include <map>

#include "tests/campaign/verifier/verifier.h"

namespace remeshd::campaign {
namespace {

template <class Values>
bool in_range(std::int32_t index, const Values& values) {
  return index >= 0 && index < static_cast<std::int32_t>(values.size());
}

void check_nodes(const OutputMesh& mesh, const Revision* base, Findings& findings) {
  const NodeMap& map = mesh.map;
  std::vector<char> taken(base ? base->output.mesh.nodes.size() : 0, 0);
  for (std::size_t n = 0; n < mesh.mesh.nodes.size(); ++n) {
    const std::int32_t from = map.original_node[n];
    if (map.node_origin[n] == NodeOrigin::New) {
      if (from != -1) findings.add("node map", "a new node with an original");
      continue;
    }
    if (base == nullptr || !in_range(from, base->output.mesh.nodes)) {
      findings.add("node map", "a kept node without an original", mesh.mesh.nodes[n]);
      continue;
    }
    if (taken[from]++) findings.add("node map", "two nodes of one original", mesh.mesh.nodes[n]);
    if (mesh.node_ids[n] != base->output.node_ids[from])
      findings.add("node ids", "a kept node with another id", mesh.mesh.nodes[n]);
    if (!in_range(map.node_transform[n], map.transforms)) {
      findings.add("node map", "a kept node without a transformation", mesh.mesh.nodes[n]);
      continue;
    }
    const Vec3 place = map.transforms[map.node_transform[n]].apply(base->output.mesh.nodes[from]);
    if (map.node_origin[n] == NodeOrigin::Kept && place != mesh.mesh.nodes[n])
      findings.add("kept node", "a kept node that is not its original to the bit", place);
  }
}

void check_kept_tets(const OutputMesh& mesh, const Revision* base, Findings& findings) {
  std::vector<char> taken(base ? base->output.mesh.tets.size() : 0, 0);
  for (std::size_t t = 0; t < mesh.mesh.tets.size(); ++t) {
    const std::int32_t from = mesh.map.original_tet[t];
    if (from == -1) continue;
    if (base == nullptr || !in_range(from, base->output.mesh.tets)) {
      findings.add("tet map", "a kept tet without an original");
      continue;
    }
    if (taken[from]++) findings.add("tet map", "two tets of one original");
    Tet now = mesh.mesh.tets[t], then = base->output.mesh.tets[from];
    for (std::int32_t& n : now) n = mesh.map.original_node[n];
    std::sort(now.begin(), now.end());
    std::sort(then.begin(), then.end());
    if (now != then) findings.add("tet map", "a kept tet of other nodes than its original's");
    if (mesh.tet_ids[t] != base->output.tet_ids[from])
      findings.add("tet ids", "a kept tet with another id");
  }
}

/// The tets of a mesh that has the base's connectivity: the same ids, each of the same four nodes
/// by their ids. Those at nodes that moved have their base's id without being told as kept.
class DeformedTets {
 public:
  DeformedTets(const OutputMesh& mesh, const Revision* base) : mesh_(mesh) {
    if (base != nullptr) connectivity_kept_ = tets(mesh) == tets(base->output);
  }
  bool operator()(std::size_t t) const {
    return connectivity_kept_ && std::ranges::any_of(mesh_.mesh.tets[t], [&](std::int32_t n) {
             return mesh_.map.node_origin[n] == NodeOrigin::Moved;
           });
  }

 private:
  using Nodes = std::array<std::uint64_t, 4>;
  static std::map<std::uint64_t, Nodes> tets(const OutputMesh& mesh) {
    std::map<std::uint64_t, Nodes> nodes;
    for (std::size_t t = 0; t < mesh.tet_ids.size(); ++t) {
      Nodes& of = nodes[mesh.tet_ids[t]];
      std::ranges::transform(mesh.mesh.tets[t], of.begin(),
                             [&](std::int32_t n) { return mesh.node_ids[n]; });
      std::ranges::sort(of);
    }
    return nodes;
  }

  const OutputMesh& mesh_;
  bool connectivity_kept_ = false;
};

/// All ids are there once, and a new node or tet has none that any mesh of the chain had, the base
/// included. What has an original has the original's id, as check_nodes() and check_kept_tets()
/// see; all else is new. But for deformed tets: the engine keeps all nodes and tets under their ids
/// where it keeps the connectivity (deliver_kept() in engine/delivery), and a tet there has no
/// original when one of its nodes moved. Of a mesh with other connectivity such a tet has a new id
/// too.
template <class IsDeformed>
void check_ids(const CowVector<std::uint64_t>& ids, const CowVector<std::int32_t>& original,
               const CowVector<std::uint64_t>* base, const IsDeformed& is_deformed,
               std::set<std::uint64_t>& ever, const std::string& check, Findings& findings) {
  const std::set<std::uint64_t> now(ids.begin(), ids.end());
  if (now.size() != ids.size()) findings.add(check, "an id twice");
  if (base != nullptr) ever.insert(base->begin(), base->end());
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (original[k] < 0 && ever.contains(ids[k]) && !is_deformed(k))
      findings.add(check, "a new one with an id that an earlier mesh of the chain had");
  ever.insert(now.begin(), now.end());
}

}  // namespace

/// The maps have an entry for each node and tet; kept nodes are their originals, transformed, to
/// the bit; kept tets have their originals' nodes; permanent ids stay and are never used again.
void check_maps(const Revision& revision, const Revision* base, std::set<std::uint64_t>& node_ids,
                std::set<std::uint64_t>& tet_ids, Findings& findings) {
  const OutputMesh& d = revision.output;
  const std::size_t nodes = d.mesh.nodes.size(), tets = d.mesh.tets.size();
  if (d.map.node_origin.size() != nodes || d.map.original_node.size() != nodes ||
      d.map.node_transform.size() != nodes || d.node_ids.size() != nodes ||
      d.map.original_tet.size() != tets || d.tet_ids.size() != tets) {
    findings.add("maps", "not one entry for each node and tet");
    return;
  }
  check_nodes(d, base, findings);
  check_kept_tets(d, base, findings);
  check_ids(
      d.node_ids, d.map.original_node, base ? &base->output.node_ids : nullptr,
      [](std::size_t) { return false; }, node_ids, "node ids", findings);
  check_ids(d.tet_ids, d.map.original_tet, base ? &base->output.tet_ids : nullptr,
            DeformedTets(d, base), tet_ids, "tet ids", findings);
}

}  // namespace remeshd::campaign

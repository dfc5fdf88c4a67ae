#include <algorithm>

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

void check_tets(const OutputMesh& mesh, const Revision* base, Findings& findings) {
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

/// New ids are new in the whole chain; all are there once.
void check_ids(const CowVector<std::uint64_t>& ids, const CowVector<std::uint64_t>* base,
               std::set<std::uint64_t>& ever, const std::string& check, Findings& findings) {
  const std::set<std::uint64_t> now(ids.begin(), ids.end());
  if (now.size() != ids.size()) findings.add(check, "an id twice");
  std::set<std::uint64_t> before;
  if (base != nullptr) before.insert(base->begin(), base->end());
  for (const std::uint64_t id : now)
    if (!before.contains(id) && ever.contains(id))
      findings.add(check, "an id that an earlier mesh of the chain had, and the base has not");
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
  check_tets(d, base, findings);
  check_ids(d.node_ids, base ? &base->output.node_ids : nullptr, node_ids, "node ids", findings);
  check_ids(d.tet_ids, base ? &base->output.tet_ids : nullptr, tet_ids, "tet ids", findings);
}

}  // namespace remeshd::campaign

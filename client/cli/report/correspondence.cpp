#include "client/cli/report/correspondence.h"

#include <algorithm>
#include <unordered_map>

namespace remeshd::cli {
namespace {

using client::Mesh;
using client::NodeOrigin;

/// For each node or tet of the new mesh its index in the base, or -1.
using Originals = std::vector<std::int32_t>;

struct NodesFound {
  Originals originals;
  std::vector<NodeOrigin> origins;
};

Originals by_ids(const std::vector<std::uint64_t>& base, const std::vector<std::uint64_t>& ids) {
  std::unordered_map<std::uint64_t, std::int32_t> rows;
  rows.reserve(base.size());
  for (std::size_t k = 0; k < base.size(); ++k) rows.emplace(base[k], static_cast<std::int32_t>(k));
  Originals originals;
  originals.reserve(ids.size());
  for (const std::uint64_t id : ids) {
    const auto row = rows.find(id);
    originals.push_back(row == rows.end() ? -1 : row->second);
  }
  return originals;
}

/// A node keeps its id when it moves: one at another place than in the base counts as moved.
NodesFound find_nodes(const Mesh& base, const Mesh& mesh) {
  NodesFound found{.originals = by_ids(base.node_ids, mesh.node_ids), .origins = {}};
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const std::int32_t original = found.originals[n];
    if (original < 0)
      found.origins.push_back(NodeOrigin::New);
    else if (base.nodes[static_cast<std::size_t>(original)] == mesh.nodes[n])
      found.origins.push_back(NodeOrigin::Kept);
    else
      found.origins.push_back(NodeOrigin::Moved);
  }
  return found;
}

TetState state_by_nodes(const std::vector<NodeOrigin>& origins,
                        const std::array<std::int32_t, 4>& tet) {
  bool has_moved = false;
  for (const std::int32_t node : tet) {
    const NodeOrigin origin = origins[static_cast<std::size_t>(node)];
    if (origin == NodeOrigin::New) return TetState::New;
    has_moved = has_moved || origin == NodeOrigin::Moved;
  }
  return has_moved ? TetState::Moved : TetState::New;
}

std::size_t rows_met(const Originals& originals, std::size_t rows) {
  std::vector<std::uint8_t> met(rows, 0);
  for (const std::int32_t row : originals)
    if (row >= 0 && static_cast<std::size_t>(row) < rows) met[static_cast<std::size_t>(row)] = 1;
  return static_cast<std::size_t>(std::ranges::count(met, 1));
}

void compare_tets(const Mesh& mesh, const Originals& originals,
                  const std::vector<NodeOrigin>& origins, Correspondence& out) {
  for (std::size_t t = 0; t < out.modified.size(); ++t) {
    if (originals[t] < 0) {
      out.modified[t] = state_by_nodes(origins, mesh.tets[t]);
      continue;
    }
    out.modified[t] = TetState::Kept;
    if (static_cast<std::size_t>(originals[t]) < out.base.size())
      out.base[static_cast<std::size_t>(originals[t])] = TetState::Kept;
  }
}

StateCounts count_nodes(const NodesFound& found, std::size_t in_base) {
  const auto count = [&](NodeOrigin origin) {
    return static_cast<std::size_t>(std::ranges::count(found.origins, origin));
  };
  return {.kept = count(NodeOrigin::Kept),
          .moved = count(NodeOrigin::Moved),
          .added = count(NodeOrigin::New),
          .gone = in_base - rows_met(found.originals, in_base)};
}

}  // namespace

Correspondence correspond(const ReportContent& content) {
  const Mesh& mesh = content.modified.mesh;
  Correspondence out;
  out.modified.assign(mesh.tets.size(), TetState::New);
  out.nodes.added = mesh.nodes.size();
  if (content.base) {
    const Mesh& base = content.base->mesh;
    out.base.assign(base.tets.size(), TetState::Gone);
    out.nodes.gone = base.nodes.size();
    if (content.descent != Descent::None) {
      const bool by_maps = content.descent == Descent::Parent;
      const NodesFound nodes =
          by_maps ? NodesFound{mesh.original_node, mesh.node_origin} : find_nodes(base, mesh);
      compare_tets(mesh, by_maps ? mesh.original_tet : by_ids(base.tet_ids, mesh.tet_ids),
                   nodes.origins, out);
      out.nodes = count_nodes(nodes, base.nodes.size());
    }
  }
  const auto count = [](const std::vector<TetState>& states, TetState state) {
    return static_cast<std::size_t>(std::ranges::count(states, state));
  };
  out.tets = {.kept = count(out.modified, TetState::Kept),
              .moved = count(out.modified, TetState::Moved),
              .added = count(out.modified, TetState::New),
              .gone = count(out.base, TetState::Gone)};
  return out;
}

bool has_surfaces_only(const ReportContent& content) {
  return content.surfaces_only || content.modified.mesh.tets.size() > kMostTetsInside ||
         (content.base && content.base->mesh.tets.size() > kMostTetsInside);
}

}  // namespace remeshd::cli

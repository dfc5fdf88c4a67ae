#include "client/cli/report/correspondence.h"

#include <algorithm>
#include <unordered_map>

namespace remeshd::cli {
namespace {

using client::Mesh;
using client::NodeOrigin;

/// For each row of the new mesh that of the base that it is, or -1.
using Originals = std::vector<std::int32_t>;

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

TetState state_by_nodes(const Mesh& mesh, const std::array<std::int32_t, 4>& tet) {
  bool has_moved = false;
  for (const std::int32_t node : tet) {
    const auto at = static_cast<std::size_t>(node);
    const NodeOrigin origin = at < mesh.node_origin.size() ? mesh.node_origin[at] : NodeOrigin::New;
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

void compare_tets(const ReportContent& content, const Originals& originals, Correspondence& out) {
  const Mesh& mesh = content.modified.mesh;
  for (std::size_t t = 0; t < out.modified.size(); ++t) {
    if (originals[t] >= 0) {
      out.modified[t] = TetState::Kept;
      if (static_cast<std::size_t>(originals[t]) < out.base.size())
        out.base[static_cast<std::size_t>(originals[t])] = TetState::Kept;
    } else if (content.descent == Descent::Parent) {
      out.modified[t] = state_by_nodes(mesh, mesh.tets[t]);
    }
  }
}

void compare_nodes(const ReportContent& content, const Originals& originals, StateCounts& nodes) {
  const Mesh& mesh = content.modified.mesh;
  nodes = {};
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (originals[n] < 0)
      ++nodes.added;
    else if (content.descent == Descent::Parent && mesh.node_origin[n] == NodeOrigin::Moved)
      ++nodes.moved;
    else
      ++nodes.kept;
  }
  const std::size_t before = content.base->mesh.nodes.size();
  nodes.gone = before - rows_met(originals, before);
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
    if (content.descent == Descent::Parent) {
      compare_tets(content, mesh.original_tet, out);
      compare_nodes(content, mesh.original_node, out.nodes);
    } else if (content.descent == Descent::Ancestor) {
      compare_tets(content, by_ids(base.tet_ids, mesh.tet_ids), out);
      compare_nodes(content, by_ids(base.node_ids, mesh.node_ids), out.nodes);
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

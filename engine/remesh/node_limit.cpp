#include "engine/remesh/node_limit.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "engine/base/error.h"
#include "engine/nodes/least_nodes.h"

namespace remeshd {
namespace {

constexpr const char* kHint = "give a larger size or fewer nodes";
constexpr const char* kHintForEdit = "mesh the edited model anew with a larger size or fewer nodes";
constexpr const char* kHintForSizes = "ask for longer edges or for a larger least one";
constexpr double kOverstart = 1.05;  // x nodes asked for: a mesh may begin with so many

/// Whether a number of nodes is above the limit by more than rounding.
bool exceeds(double nodes, const Run& run) { return !(nodes < run.max_nodes + 0.5); }

std::string digits(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6)
          .ptr;
  return {text.data(), end};
}

void check_count(const MeshOptions& options, const Run& run) {
  if (options.nodes && *options.nodes > run.max_nodes)
    throw error::mesh_too_large("the request asks for", *options.nodes, run.max_nodes, "nodes", {},
                                kHint);
}

/// The error that tells the edge length and the nodes needed. `qualifier`: precedes their number.
Error too_large(const Revision& original, const MeshOptions& options, double edge_length,
                const LeastNodes& needed, const char* qualifier, const Run& run) {
  const bool base = edge_length == original.edge_length;
  std::string what = base ? "the base's edge length of " : "an edge length of ";
  what += digits(edge_length);
  if (!base && options.nodes)
    what += ", which " + std::to_string(*options.nodes) + " nodes come to,";
  what += " needs ";
  if (!needed.feature.empty()) what += "for the feature '" + needed.feature + "' alone ";
  const char* option = base ? "" : options.nodes ? "nodes" : "size";
  return error::mesh_too_large(what + qualifier, needed.nodes, run.max_nodes, option,
                               needed.feature, base ? kHintForEdit : kHint);
}

}  // namespace

Extent extent_of(const CellularModel& cells) {
  double along_edges = 0, across_faces = 0;
  for (const BoundaryEdge& edge : cells.boundary.edges) along_edges += edge.length;
  for (const BoundaryFace& face : cells.boundary.faces)
    across_faces += box_of(face.points).diagonal();
  return {cells.volume, cells.area, std::fmax(along_edges, across_faces)};
}

double check_node_limit(const Revision& original, const FeatureModel& model,
                        const MeshOptions& options, const Run& run) {
  check_count(options, run);
  const double edge_length = std::fmin(original.edge_length, options.size.value_or(HUGE_VAL));
  // What a number of nodes comes to is known only with the volume.
  if (std::isinf(edge_length)) return options.nodes.value_or(0);
  const LeastNodes least = least_nodes(model, edge_length, run.max_nodes);
  if (exceeds(least.nodes, run))
    throw too_large(original, options, edge_length, least, "at least", run);
  return std::fmax(least.nodes, options.nodes.value_or(0));
}

void check_new_nodes(std::size_t nodes, const MeshOptions& options, const Run& run) {
  const auto count = static_cast<double>(nodes);
  if (!exceeds(count / kOverstart, run)) return;
  const char* option = options.nodes ? "nodes" : options.size ? "size" : "";
  // Only an edit may have neither.
  const bool is_edit = !options.nodes && !options.size;
  throw error::mesh_too_large("the edge lengths asked for need about", count, run.max_nodes, option,
                              {}, is_edit ? kHintForEdit : kHintForSizes);
}

void check_node_limit(const Revision& original, const Extent& extent, double edge_length,
                      const MeshOptions& options, const Run& run) {
  check_count(options, run);
  const double nodes = nodes_needed(extent, edge_length);
  if (exceeds(nodes, run))
    throw too_large(original, options, edge_length, {nodes, {}}, "about", run);
}

}  // namespace remeshd

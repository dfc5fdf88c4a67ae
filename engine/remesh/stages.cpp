#include "engine/remesh/stages.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/error.h"
#include "engine/boundary/control_mesh.h"
#include "engine/extract/peel.h"
#include "engine/nodes/active_faces.h"
#include "engine/nodes/copy_nodes.h"
#include "engine/nodes/density.h"
#include "engine/nodes/dump.h"
#include "engine/nodes/fill.h"
#include "engine/remesh/master.h"
#include "engine/remesh/node_map.h"
#include "engine/remesh/stopwatch.h"

namespace remeshd {

namespace {

constexpr std::uint32_t kDefaultNodes = 15000;
constexpr std::uint32_t kMinNodes = 20, kMaxNodes = 5'000'000;

/// Leaves out the nodes that no tet uses and renumbers the tets and the Delaunay mesh.
void drop_unused(NodeSet& nodes, std::vector<Tet>& tets, kernel::Delaunay& mesh, const Run& run) {
  std::vector<std::int32_t> number(nodes.positions.size(), -1);
  for (const Tet& t : tets)
    for (const std::int32_t n : t) number[n] = 0;
  std::vector<std::int32_t> unused;
  std::int32_t next = 0;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (number[n] < 0) {
      unused.push_back(n);
      continue;
    }
    nodes.positions[next] = nodes.positions[n];
    nodes.supports[next] = nodes.supports[n];
    nodes.free[next] = nodes.free[n];
    nodes.original[next] = nodes.original[n];
    nodes.transform[next] = nodes.transform[n];
    number[n] = next++;
  }
  if (unused.empty()) return;
  nodes.positions.resize(next);
  nodes.supports.resize(next);
  nodes.free.resize(next);
  nodes.original.resize(next);
  nodes.transform.resize(next);
  for (Tet& t : tets)
    for (std::int32_t& n : t) n = number[n];
  if (mesh.remove(unused, run)) {
    mesh.rename(number, next);
  } else {
    mesh = mesh.emptied();
    std::vector<std::int32_t> all(next);
    std::iota(all.begin(), all.end(), 0);
    mesh.insert(nodes.positions, all, run);
  }
}

}  // namespace

Density resolve_density(const Revision* original, const MeshOptions& options, double volume,
                        double area) {
  if (options.nodes && options.size)
    throw error::options_invalid("nodes", "give a number of nodes or an edge length, not both");
  if (options.nodes && (*options.nodes < kMinNodes || *options.nodes > kMaxNodes))
    throw error::options_invalid("nodes", "between 20 and 5000000 nodes can be asked for");
  if (options.size && !(std::isfinite(*options.size) && *options.size > 0))
    throw error::options_invalid("size", "the edge length has to be a positive number");
  Density density;
  if (options.size) {
    density.edge_length = *options.size;
    const double nodes = expected_nodes(volume, area, density.edge_length);
    if (nodes > kMaxNodes)
      throw error::options_invalid("size", "this edge length would need more than 5000000 nodes");
    density.nodes_per_volume = nodes / volume;
  } else if (options.nodes || !original) {
    const std::uint32_t nodes = options.nodes.value_or(kDefaultNodes);
    density.edge_length = edge_length_for(volume, area, nodes);
    density.nodes_per_volume = nodes / volume;
    if (!original) density.count = nodes;
  } else {
    density.edge_length = original->edge_length;
    // What the edge length says, not what the original has: small errors of many edits would add
    // up.
    density.nodes_per_volume = expected_nodes(volume, area, density.edge_length) / volume;
  }
  if (original) density.edge_length = std::fmin(density.edge_length, original->edge_length);
  return density;
}

NodeSet initial_nodes(const Revision* original, const PointSource& source, const Density& density,
                      MeshOptions::Start start, std::uint64_t seed, const Run& run) {
  NodeSet nodes;
  if (original)
    nodes = copy_nodes(
        source, {original->master->positions, original->master->supports, original->master->tets},
        original->edge_length, run);
  const auto fill = start == MeshOptions::Start::Lattice ? fill_lattice : fill_random;
  const std::vector<Vec3> added = fill(
      source.changed(), [&](const Vec3& p) { return source(p) == PointSource::kNew; },
      {.edge_length = density.edge_length,
       .density = density.nodes_per_volume,
       .count = density.count,
       .seed = seed},
      run);
  for (const Vec3& p : added) nodes.add_new(p);
  if (original) free_at_active_faces(nodes, source, density.edge_length, run);
  dump_nodes(run, "05-nodes", nodes);
  return nodes;
}

StartMesh start_mesh(const Revision* original, const NodeSet& nodes, const PointSource& source,
                     const Box& bounds, const Run& run) {
  StartMesh start{kernel::Delaunay(bounds), std::vector<std::uint8_t>(nodes.positions.size(), 0)};
  if (!original || !original->master->mesh.encloses(bounds)) return start;
  std::vector<std::int32_t> name(original->master->positions.size(), -1);
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.original[n] >= 0 && !nodes.free[n] &&
        source.transforms()[nodes.transform[n]].is_identity())
      name[nodes.original[n]] = n;
  std::vector<std::int32_t> others;
  for (std::size_t o = 0; o < name.size(); ++o)
    if (name[o] < 0) others.push_back(static_cast<std::int32_t>(o));
  kernel::Delaunay mesh = original->master->mesh;
  if (!mesh.remove(others, run)) return start;
  mesh.rename(name, nodes.size());
  for (const std::int32_t n : name)
    if (n >= 0) start.holds[n] = 1;
  start.mesh = std::move(mesh);
  return start;
}

InsideTest inside_test(MeshOptions::Inside kind, const Membership& membership,
                       const BoundaryModel& boundary, const Run& run) {
  if (kind == MeshOptions::Inside::Membership)
    return [&membership](const Vec3& p) { return membership.inside(p); };
  const auto mesh = std::make_shared<const ControlMesh>(ControlMesh::build(boundary, run));
  return [mesh](const Vec3& p) { return mesh->inside(p); };
}

Candidate extract(NodeSet nodes, OptimiseResult loop, const CellularModel& cells,
                  const InsideTest& inside, const Run& run) {
  Candidate c;
  c.loop = std::move(loop);
  c.nodes = std::move(nodes);
  run.report("extract", 0.8);
  c.delaunay = peel(c.nodes, c.loop.mesh, cells.boundary, inside, {}, run);
  drop_unused(c.nodes, c.delaunay, c.loop.mesh, run);
  dump_nodes(run, "08-peel", c.nodes, c.delaunay);
  return c;
}

void finish(Candidate& c, const Target& target, const Run& run) {
  const Revision* original = target.original;
  const MeshOptions& options = target.options;
  const CellularModel& cells = target.cells;
  CarriedMesh carried;
  if (original && options.clean_up) {
    carried = carry_over(c.nodes, c.delaunay, *original->master,
                         {original->master_nodes(), original->delivery.mesh.tets},
                         target.source.transforms(), run);
  } else {
    carried.mesh = {c.nodes.positions, c.delaunay};
    carried.dirty.assign(c.delaunay.size(), 1);
  }
  run.report("improve", 0.85);
  if (options.clean_up)
    c.mesh = improve(carried.mesh, c.nodes.supports, cells.boundary, carried.dirty,
                     {.threshold = options.threshold}, run)
                 .mesh;
  else
    c.mesh = std::move(carried.mesh);
  run.report("verify", 0.95);
  VerifyOptions proof{
      .material = [&](const Vec3& p) { return target.source.modified().inside(p); }};
  VerifiedParent parent;
  if (original) {
    c.map = map_to(*original, c.nodes, c.mesh, target.source, run);
    parent = verified_parent(*original, c.map.original_node, c.map.original_tet);
    proof.parent = &parent;
  } else {
    c.map = map_to_nothing(c.mesh);
  }
  const Stopwatch watch;
  c.verification = verify(c.mesh, c.nodes.supports, cells.boundary, cells.volume, run, proof);
  c.verify_seconds = watch.total();
}

}  // namespace remeshd

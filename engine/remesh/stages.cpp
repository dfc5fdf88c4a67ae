#include "engine/remesh/stages.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/error.h"
#include "engine/base/hilbert.h"
#include "engine/boundary/control_mesh.h"
#include "engine/extract/peel.h"
#include "engine/nodes/active_faces.h"
#include "engine/nodes/copy_nodes.h"
#include "engine/nodes/density.h"
#include "engine/nodes/dump.h"
#include "engine/nodes/fill.h"
#include "engine/nodes/place_supports.h"
#include "engine/nodes/thin_out.h"
#include "engine/optimise/live_mesh.h"
#include "engine/remesh/carry_over.h"
#include "engine/remesh/master.h"
#include "engine/remesh/node_limit.h"
#include "engine/remesh/node_map.h"
#include "engine/remesh/stopwatch.h"

namespace remeshd {

namespace {

constexpr std::uint32_t kDefaultNodes = 15000;
constexpr double kRounding = 1 + 1e-9;  // a factor that leaves nothing out for rounding
constexpr double kNearChange = 2;       // x edge length: further from the changed boxes nodes stay
constexpr double kSampledBeyond = 0.5;  // x edge length: from a node to what it is nearest to
constexpr int kSampledSteps = 4;        // cubes to the reach
constexpr std::uint32_t kMinNodes = 20;

/// Leaves out the nodes that no tet uses, but for those at the rim, and renumbers the tets and the
/// Delaunay mesh.
void drop_unused(NodeSet& nodes, std::vector<Tet>& tets, kernel::Delaunay& mesh, const Run& run) {
  std::vector<std::int32_t> number(nodes.positions.size(), -1);
  std::fill_n(number.begin(), nodes.rim, 0);
  for (const Tet& t : tets)
    for (const std::int32_t n : t) number[n] = 0;
  std::vector<std::int32_t> unused;
  std::int32_t next = 0;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (number[n] < 0) {
      unused.push_back(n);
      continue;
    }
    nodes.move(n, next);
    number[n] = next++;
  }
  if (unused.empty()) return;
  nodes.resize(next);
  for (Tet& t : tets)
    for (std::int32_t& n : t) n = number[n];
  if (mesh.remove(unused, run)) {
    mesh.rename(number, next);
  } else if (nodes.of_part()) {
    throw LeftPart{"leaving out nodes"};
  } else {
    mesh = mesh.emptied();
    std::vector<std::int32_t> all(next);
    std::iota(all.begin(), all.end(), 0);
    mesh.insert(nodes.positions, all, run);
  }
  if (mesh.left_part()) throw LeftPart{"leaving out nodes"};
}

/// What is known of the part's tets and their neighbours beyond it, from before: of those that are
/// as they were and meet no changed box.
PeelRim known_before(const NodeSet& nodes, const kernel::Delaunay& mesh, const OriginalPart& part,
                     const PointSource& source) {
  PeelRim rim;
  if (!nodes.of_part()) return rim;
  rim.beyond = part.beyond;
  rim.tets.assign(mesh.slots(), PeelRim::Known::No);
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(part.mesh.slots()); ++s) {
    if (!mesh.in_use(s)) continue;
    const Tet then = part.mesh.corners(s), now = mesh.corners(s);
    const bool same = std::ranges::equal(then, now, [&](std::int32_t a, std::int32_t b) {
      if (a < 0 || b < 0) return a == b;  // far corners
      return a == nodes.original[b] && nodes.positions[b] == part.positions[a];
    });
    if (same && !source.meets_changed(now, nodes.positions))
      rim.tets[s] = part.inside[s] ? PeelRim::Known::Inside : PeelRim::Known::Outside;
  }
  return rim;
}

/// Nodes of the original that may not stay as they are: those in the changed boxes or within
/// `margin` of them. `everything`: all nodes.
std::vector<std::int32_t> nodes_to_look_at(const Revision& original, const PointSource& source,
                                           double margin, bool everything) {
  std::vector<std::int32_t> nodes;
  const Pages<Vec3>& positions = original.master->positions();
  for (std::size_t n = 0; n < positions.size(); ++n)
    if (everything || source.in_changed(positions[n], margin))
      nodes.push_back(static_cast<std::int32_t>(n));
  return nodes;
}

/// The tets of the model at some of the nodes. `meets`: takes the boxes that one of these may be
/// in.
template <class Meets>
std::vector<Tet> tets_at(const Master& master, std::span<const std::int32_t> nodes,
                         const Meets& meets) {
  std::vector<std::uint8_t> wanted(master.positions().size(), 0);
  for (const std::int32_t n : nodes) wanted[n] = 1;
  std::vector<Tet> tets;
  master.mesh.for_each_slot_near(meets, [&](std::int32_t s) {
    if (!master.inside(s)) return;
    const Tet t = master.mesh.corners(s);
    if (wanted[t[0]] || wanted[t[1]] || wanted[t[2]] || wanted[t[3]]) tets.push_back(t);
  });
  return tets;
}

/// Supports of the nodes that are not in the part; of the others any.
Pages<Support> supports_left(const Revision& original, const Site& site) {
  const Pages<Support>& then = original.supports();
  const Pages<Vec3>& positions = original.master->positions();
  if (!site.map) return Pages<Support>(then.size(), {});
  Pages<Support> supports = then;
  const std::vector<std::int32_t>& part = site.part.nodes;  // ascending
  auto next = part.begin();
  then.for_each([&](std::size_t n, const Support& was) {
    if (was.kind == Support::Kind::Interior) return;
    next = std::find_if(next, part.end(),
                        [&](std::int32_t p) { return p >= static_cast<std::int32_t>(n); });
    if (next != part.end() && *next == static_cast<std::int32_t>(n)) return;
    const std::optional<Support> support = (*site.map)(was, positions[n]);
    if (!support) throw LeftPart{"naming where nodes stand"};
    supports.set(n, *support);
  });
  return supports;
}

}  // namespace

Density resolve_density(const Revision* original, const MeshOptions& options,
                        const CellularModel& cells, const Run& run) {
  if (options.nodes && options.size)
    throw error::options_invalid("nodes", "give a number of nodes or an edge length, not both");
  if (options.nodes && *options.nodes < kMinNodes)
    throw error::options_invalid("nodes", "at least 20 nodes have to be asked for");
  if (options.size && !(std::isfinite(*options.size) && *options.size > 0))
    throw error::options_invalid("size", "the edge length has to be a positive number");
  const double volume = cells.volume, area = cells.area;
  Density density;
  if (options.size) {
    density.edge_length = *options.size;
    density.nodes_per_volume = expected_nodes(volume, area, density.edge_length) / volume;
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
    density.inherited = true;
  }
  if (original) density.edge_length = std::fmin(density.edge_length, original->edge_length);
  check_node_limit(original, extent_of(cells), density.edge_length, options, run);
  return density;
}

std::optional<LocalNodes> initial_nodes(const Revision* original, const PointSource& source,
                                        const Density& density, MeshOptions::Start start,
                                        std::uint64_t seed, const Reach& reach, const Run& run) {
  NodeSet nodes;
  std::vector<std::int32_t> looked_at;
  if (original) {
    const Master& master = *original->master;
    const double margin = kNearChange * density.edge_length;
    const bool everything = std::isinf(reach.length);
    looked_at = nodes_to_look_at(*original, source, margin, everything);
    const std::vector<Tet> tets = tets_at(master, looked_at, [&](const Box& box) {
      return everything || source.meets_changed(grown(box, kRounding * margin));
    });
    nodes = copy_nodes(source, {master.positions(), original->supports(), looked_at, tets},
                       original->edge_length, run);
  }
  // What is near in space is to be near in memory: revisions share pages.
  const std::vector<Vec3> added =
      along_hilbert_curve((start == MeshOptions::Start::Lattice ? fill_lattice : fill_random)(
          source.changed(), [&](const Vec3& p) { return source(p) == PointSource::kNew; },
          {.edge_length = density.edge_length,
           .density = density.nodes_per_volume,
           .count = density.count,
           .seed = seed},
          run));
  for (const Vec3& p : added) nodes.add_new(p);
  if (!original) {
    LocalNodes local;
    local.nodes = std::move(nodes);
    dump_nodes(run, "05-nodes", local.nodes);
    return local;
  }
  free_at_active_faces(nodes, source, density.edge_length, run);
  thin_out(nodes, density.edge_length);
  std::optional<LocalNodes> local = localise(
      nodes, looked_at, *original->master, original->supports(),
      {original->master_nodes(), original->delivery.mesh.tets}, reach.map, source, reach.length);
  if (local) dump_nodes(run, "05-nodes", local->nodes);
  return local;
}

std::vector<Region> sampled_places(const LocalNodes& local, double edge_length,
                                   const Reach& reach) {
  const NodeSet& nodes = local.nodes;
  std::vector<Vec3> free, to_place;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (nodes.free[n])
      free.push_back(nodes.positions[n]);
    else if (n >= local.placed && nodes.supports[n].kind != Support::Kind::Interior)
      to_place.push_back(nodes.positions[n]);
  }
  return {Region(free, reach.length + kSampledBeyond * edge_length, kSampledSteps),
          Region(to_place, kSupportReach * edge_length, 1)};
}

StartMesh start_mesh(const LocalNodes& local, const PointSource& source, const Box& bounds,
                     const Run& run) {
  const NodeSet& nodes = local.nodes;
  const OriginalPart& part = local.part;
  StartMesh start{kernel::Delaunay(bounds), std::vector<std::uint8_t>(nodes.positions.size(), 0)};
  const auto without = [&] {
    if (nodes.of_part()) throw LeftPart{"taking out the free nodes"};
    return start;
  };
  if (part.nodes.empty() && nodes.of_part()) {  // nothing changes
    start.mesh = part.mesh;
    return start;
  }
  if (part.nodes.empty() || !part.mesh.encloses(bounds)) return without();
  std::vector<std::int32_t> name(part.nodes.size(), -1);
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.original[n] >= 0 && !nodes.free[n] &&
        source.transforms()[nodes.transform[n]].is_identity())
      name[nodes.original[n]] = n;
  std::vector<std::int32_t> others;
  for (std::size_t o = 0; o < name.size(); ++o)
    if (name[o] < 0) others.push_back(static_cast<std::int32_t>(o));
  kernel::Delaunay mesh = part.mesh;
  if (!mesh.remove(others, run)) return without();
  mesh.rename(name, nodes.size());
  // What moves as one body brings its tets along.
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(source.transforms().size()); ++t) {
    if (source.transforms()[t].is_identity()) continue;
    std::vector<std::int32_t> moved(part.nodes.size(), -1);
    for (std::int32_t n = 0; n < nodes.size(); ++n)
      if (nodes.transform[n] == t && !nodes.free[n]) moved[nodes.original[n]] = n;
    mesh.insert_moved(part.mesh, moved, nodes.positions, run);
    for (const std::int32_t n : moved)
      if (n >= 0) start.holds[n] = 1;
  }
  if (mesh.left_part()) throw LeftPart{"moving nodes"};
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

Candidate extract(NodeSet nodes, OptimiseResult loop, const OriginalPart& part,
                  const PointSource& source, const CellularModel& cells, const InsideTest& inside,
                  const Run& run) {
  Candidate c;
  c.loop = std::move(loop);
  c.nodes = std::move(nodes);
  run.report("extract", 0.8);
  c.delaunay = peel(c.nodes, c.loop.mesh, cells.boundary, inside,
                    known_before(c.nodes, c.loop.mesh, part, source), {}, run);
  drop_unused(c.nodes, c.delaunay.tets, c.loop.mesh, run);
  dump_nodes(run, "08-peel", c.nodes, c.delaunay.tets);
  return c;
}

namespace {

/// The part's mesh as it comes from the loop, all of it to be cleaned up.
CarriedMesh all_new(const Candidate& c) {
  const std::vector<Tet>& tets = c.delaunay.tets;
  return {{c.nodes.positions, tets}, std::vector<std::uint8_t>(tets.size(), 1), {}};
}

std::vector<std::int32_t> looked_up(std::span<const std::int32_t> values,
                                    std::span<const std::int32_t> at) {
  std::vector<std::int32_t> result(at.size(), -1);
  for (std::size_t k = 0; k < at.size(); ++k)
    if (at[k] >= 0) result[k] = values[at[k]];
  return result;
}

/// The part's mesh, carried over and cleaned up.
CarriedMesh cleaned_up(Candidate& c, const Target& target, const Site& site, bool clean_up,
                       const Run& run) {
  const MeshOptions& options = target.options;
  const bool copied = target.original && options.clean_up;
  CarriedMesh carried =
      copied ? carry_over(c.nodes, c.delaunay, site.part, target.source.transforms(), run)
             : all_new(c);
  run.report("improve", 0.85);
  c.bad_at_rim = 0;
  if (!clean_up) return carried;
  ImproveResult improved =
      improve(carried.mesh, c.nodes.supports, target.cells.boundary, carried.dirty,
              {.threshold = options.threshold, .locked = c.nodes.rim}, run);
  c.bad_at_rim = improved.bad_at_rim;
  SameTets same;
  if (copied)
    same = {looked_up(carried.same.peeled, improved.was),
            looked_up(carried.same.delivered, improved.was)};
  else
    same.peeled = std::move(improved.was);  // which was cleaned up as it is
  return {std::move(improved.mesh), {}, std::move(same)};
}

WholeMesh put_together(Candidate& c, const Target& target, const Site& site, bool clean_up,
                       const Run& run) {
  const CarriedMesh mesh = cleaned_up(c, target, site, clean_up, run);
  const PartMesh made{c.nodes, c.loop.mesh, c.delaunay, mesh.mesh, mesh.same};
  if (const Revision* original = target.original)
    return splice(*original, supports_left(*original, site), site.part, made, target.source, run);
  return whole_mesh(made, run);
}

}  // namespace

void finish(Candidate& c, const Target& target, const Site& site, bool clean_up, const Run& run) {
  const Revision* original = target.original;
  const CellularModel& cells = target.cells;
  c.whole = {};  // its memory, where it is made again
  c.whole = put_together(c, target, site, clean_up, run);
  run.report("verify", 0.95);
  VerifyOptions proof{
      .material = [&](const Vec3& p) { return target.source.modified().inside(p); }};
  VerifiedParent parent;
  if (original) {
    parent = verified_parent(*original, c.whole.map.original_node, c.whole.map.original_tet);
    proof.parent = &parent;
  }
  const Stopwatch watch;
  c.verification =
      verify(c.whole.mesh, c.whole.master.supports, cells.boundary, cells.volume, run, proof);
  c.verify_seconds += watch.total();
}

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/pages.h"
#include "engine/base/run.h"
#include "engine/cellular/cellular_model.h"
#include "engine/cellular/support.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/model/feature_model.h"
#include "engine/remesh/report.h"

namespace remeshd {

/// What decides a mesh beside the model. Part of a revision's name.
struct MeshOptions {
  /// Exactly one of the two targets is set in a resolved option; both empty in an edit means: the
  /// base's density.
  std::optional<std::uint32_t> nodes;  ///< target count of nodes, from 20 to `Run::max_nodes`
  std::optional<double> size;          ///< target edge length, model's unit, > 0
  std::uint32_t iterations =
      0;  ///< of the optimisation loop, at most 1000; 0: until quality stops improving
  std::uint64_t seed = 1;
  /// What tells inside from outside in the loop and in extraction.
  enum class Inside : std::uint8_t {
    Membership,   ///< closed formulas of the features: exact
    ControlMesh,  ///< the control mesh of Sect. 3.1, as in the paper; exact to its chords
  };
  Inside inside = Inside::Membership;
  /// Where new nodes start.
  enum class Start : std::uint8_t {
    Lattice,  ///< on a shaken body-centred cubic lattice
    Random,   ///< at random, evenly spread, as in the paper (Sect. 3.2)
  };
  Start start = Start::Lattice;
  /// Every iteration builds its Delaunay mesh anew from that of the fixed nodes, as in the paper
  /// (Sect. 8), where otherwise it follows the nodes. For comparison.
  bool rebuild = false;
  bool clean_up = true;  ///< false leaves the peeled Delaunay mesh as it is
  /// Tets of a volume-length measure below this are cleaned up, 0 .. 0.8. More costs time: at
  /// 15,000 nodes .45 leaves dihedral angles from 20 degrees in 10 ms, .52 from 25 in 20, .6 from
  /// 27 in 45.
  double threshold = 0.52;
  friend bool operator==(const MeshOptions&, const MeshOptions&) = default;
};

enum class NodeOrigin : std::uint8_t { New = 0, Kept = 1, Moved = 2 };

/// Where each node and tet of a mesh comes from.
struct NodeMap {
  Pages<NodeOrigin> node_origin;
  Pages<std::int32_t> original_node;   ///< in the original mesh; -1 where New
  Pages<std::int32_t> node_transform;  ///< index into `transforms`; -1 where New
  Pages<std::int32_t> original_tet;    ///< in the original mesh; -1 where not kept
  std::vector<Transform>
      transforms;  ///< of the source features; a kept node is transform(original) to the bit
  std::vector<std::string>
      transform_features;  ///< for each transform: the first source feature that has it
};

/// A boundary facet: a triangle of the mesh, outward, with its tet and its set of model faces.
struct MeshFacet {
  Triangle nodes;
  std::int32_t tet;
  std::int32_t group;  ///< index into `MeshGroups::facet_groups`
};

/// Names on a mesh: what its facets lie on and who owns its tets.
struct MeshGroups {
  std::vector<MeshFacet> facets;
  std::vector<std::vector<std::string>>
      facet_groups;              ///< `hole1.wall`, latest owner on the material side first
  Pages<std::int32_t> tet_cell;  ///< for each tet: index into `cell_owners`
  std::vector<std::vector<std::string>> cell_owners;  ///< feature ids in history order
};

/// Everything the delivered mesh is made of, in the order of the files and the stream.
struct Delivery {
  PagedMesh mesh;
  Pages<std::uint64_t>
      node_ids;  ///< permanent: unique along a chain of ancestors, kept nodes keep theirs
  Pages<std::uint64_t> tet_ids;
  MeshGroups groups;
  NodeMap map;
};

/// State of the Delaunay master that only the engine reads; kept and stored as it is.
struct Master;

/// What the connectivity of a mesh was made for, where its nodes have followed the surfaces since.
struct Anchor {
  ModelSource source;
  FeatureModel model;
  Pages<Vec3> nodes;        ///< as delivered then
  Pages<Support> supports;  ///< of the nodes, in the boundary of the revision's own cells
};

/// What wear along a chain of edits is told by: the chain's last regular mesh.
struct WearReference {
  double volume_length_mean = 0;
  double nodes_over_expected = 1;  ///< its nodes over those that its edge length lets one expect
};

/// One design revision as the engine sees it: immutable once made.
struct Revision {
  ModelSource source;  ///< as asked for
  FeatureModel model;  ///< evaluated
  /// What the mesh was made for: `source` and `model` but for rounding and spelling, so that steps
  /// too small to count cannot add up unseen.
  ModelSource meshed_source;
  FeatureModel meshed_model;
  MeshOptions options;     ///< as resolved; an edit inherits these
  double edge_length = 0;  ///< target edge length l; an edit inherits it as its density
  CellularModel cells;
  std::shared_ptr<const Master> master;  ///< made for `master_model()`
  std::shared_ptr<const Anchor> anchor;  ///< null where the mesh is as its master gave it
  Delivery delivery;
  Pages<TetMeasure> measures;  ///< of the delivered tets
  Pages<Box> boxes;            ///< round the delivered tets, one for each page of them
  Report report;
  WearReference reference;

  [[nodiscard]] const FeatureModel& master_model() const;
  /// The delivered nodes as the master gave them.
  [[nodiscard]] const Pages<Vec3>& master_nodes() const;
  /// Of the delivered nodes, in the boundary of `cells`.
  [[nodiscard]] const Pages<Support>& supports() const;
};

/// The whole road of the paper: from a model document (and, for an edit, the original revision) to
/// a checked mesh with its maps. A first mesh is a remesh whose cells are all new
/// (`original == nullptr`).
///
/// A remesh that has worn is made anew, as a regular mesh, and the Report says so: where its mean
/// volume-length lies more than 0.005 below that of the chain's last regular mesh, or its nodes are
/// more than a tenth off in number, and the regular mesh is better. The first edit of a regular
/// mesh is never made anew for that.
///
/// The result depends on the arguments alone, not on `run.threads` or the clock. `run.on_warnings`
/// hears before there is a mesh of names that will be lost, and of each strategy that is given up
/// with a warning before the next begins.
/// Throws Error: what `evaluate` and `build_cells` throw; `OPTIONS_INVALID`; `MESH_TOO_LARGE` where
/// more nodes than `run.max_nodes` would be needed, before any is made; `BOUNDARY_NOT_RECOVERED`
/// where no valid mesh could be made, naming the place and the features there; Cancelled within 100
/// ms of a stop request.
Revision make_revision(const Revision* original, const ModelSource& source,
                       const MeshOptions& options, const Run& run);

}  // namespace remeshd

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/cow_vector.h"
#include "engine/base/vec.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

enum class NodeOrigin : std::uint8_t { New = 0, Kept = 1, Moved = 2 };

/// Where each node and tet of a mesh comes from.
struct NodeMap {
  CowVector<NodeOrigin> node_origin;
  CowVector<std::int32_t> original_node;   ///< in the original mesh; -1 where New
  CowVector<std::int32_t> node_transform;  ///< index into `transforms`; -1 where New
  CowVector<std::int32_t> original_tet;    ///< in the original mesh; -1 where not kept
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

/// A group of the model as sets of facets and tets of the mesh.
struct GroupMembers {
  std::string name;
  std::vector<std::int32_t> facets;  ///< indices into `MeshGroups::facets`, ascending
  std::vector<std::int32_t> tets;    ///< of the features that it names as a whole, ascending
};

/// Names on a mesh: what its facets lie on and who owns its tets.
struct MeshGroups {
  std::vector<MeshFacet> facets;
  std::vector<std::vector<std::string>>
      facet_groups;                  ///< `hole1.wall`, latest owner on the material side first
  CowVector<std::int32_t> tet_cell;  ///< for each tet: index into `cell_owners`
  std::vector<std::vector<std::string>> cell_owners;  ///< feature ids in history order
  std::vector<GroupMembers> of_model;                 ///< in the order of the model's groups
};

/// Mid-nodes of a mesh of second order, one to each edge; none in a mesh of first order.
struct MidNodes {
  CowVector<Vec3> positions;
  CowVector<std::array<std::int32_t, 2>> edges;    ///< by mid-node: corner nodes, the lower first
  CowVector<std::array<std::int32_t, 6>> of_tets;  ///< by tet: of its edges 01 12 20 03 13 23
  CowVector<std::uint64_t> ids;                    ///< permanent, as those of nodes
  CowVector<NodeOrigin> origin;
  CowVector<std::int32_t> original;   ///< in the original mesh; -1 where New
  CowVector<std::int32_t> transform;  ///< index into `NodeMap::transforms`; -1 where New
  /// Mid-nodes that were left in the middle of a straight edge where the model's boundary is
  /// curved, ascending.
  std::vector<std::int32_t> straightened;
  std::uint64_t next_id = 1;  ///< permanent ids below are taken along the chain of ancestors
};

/// Everything the output mesh is made of, in the order of the files and the stream.
struct OutputMesh {
  PagedMesh mesh;
  CowVector<std::uint64_t>
      node_ids;  ///< permanent: unique along a chain of ancestors, kept nodes keep theirs
  CowVector<std::uint64_t> tet_ids;
  /// By node the edge length that it was made for; empty in an even mesh. Nodes that an edit keeps
  /// keep theirs, so that the effect of many small steps does not go unseen.
  CowVector<double> node_sizes;
  MeshGroups groups;
  NodeMap map;
  MidNodes mids;
};

}  // namespace remeshd

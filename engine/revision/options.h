#pragma once

#include <cstdint>
#include <optional>

#include "engine/mesh/quality_goals.h"
#include "engine/sizing/sizing.h"

namespace remeshd {

inline constexpr std::uint32_t kDefaultNodes = 15000;  ///< of a first mesh
inline constexpr std::uint32_t kMinNodes = 20;         ///< the least that may be asked for

/// What decides a mesh beside the model. Part of what a revision's id is made of.
struct MeshOptions {
  /// At most one of the two targets is given. Resolved options of a first mesh have one; those of
  /// an edit may have none: it has its base's density.
  std::optional<std::uint32_t>
      nodes;                   ///< target count of nodes, from kMinNodes to `Run::max_nodes`
  std::optional<double> size;  ///< target edge length, model's unit, > 0
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
  /// Tets of a volume-length measure below this are cleaned up, 0 .. 0.8. More costs time.
  double threshold = goals::kThreshold;
  std::uint32_t order = 1;  ///< of the tets: 1, or 2, with mid-nodes on the model's boundary
  /// x edge length: edits keep the connectivity as long as no surface is further than this from
  /// where it was when the connectivity was made (`hold_mesh`). 0: only the morph keeps it, up to
  /// 0.01 of the least edge length (`morph_mesh`).
  double hold = 0;
  Sizing sizing;  ///< where the mesh is finer than its edge length
  friend bool operator==(const MeshOptions&, const MeshOptions&) = default;
};

}  // namespace remeshd

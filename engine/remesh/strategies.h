#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/remesh/attempt.h"

namespace remeshd {

/// What of the parent a strategy goes on with.
enum class Reuse : std::uint8_t {
  Mesh,        ///< its tets
  Nodes,       ///< what the plan copies of its nodes, fixed where nothing changed
  FreedNodes,  ///< the same, all of them free
  Nothing,
};

/// A way to a mesh.
struct Strategy {
  MeshStrategy kind;
  const char* name;  ///< among the attempts
  /// Whether it is to be tried. `failed`: the last attempt that made nodes, null if none did.
  bool (*applies)(const Problem& problem, const Attempt* failed);
  Attempt (*make)(const Strategy& how, const Problem& problem, const Attempt* failed);
  Reuse reuse = Reuse::Nothing;
  /// x edge length: how far from what changes the parent's mesh is cut open; infinite: all of it.
  double reach = 0;
  bool last_reach = false;        ///< no patch that is larger will be tried
  std::uint64_t other_seed = 0;   ///< added to the seed of the options
  const char* instead = nullptr;  ///< told with the fault of the mesh that it takes the place of
  /// x edge length where the last attempts' meshes were wrong, which are made anew there; 0: none.
  double refined = 0;
};

/// The road of the paper, Sects. 5 to 8 (remesh.cpp): nodes copied and new, free and fixed,
/// optimised, extracted, verified.
Attempt remesh_nodes(const Strategy& how, const Problem& problem, const Attempt* failed);

/// All strategies but the renewing of a drifted mesh, in the order in which they are tried.
std::span<const Strategy> strategies();
/// The first ones of them, which keep all tets of the parent.
std::span<const Strategy> tet_keeping_strategies();

/// Tries one strategy after the other until an attempt is taken; the report gets what was tried
/// before, with the reasons, and everyone's seconds and lasting warnings. `run.on_warnings` hears
/// of names that will be lost before there are nodes, and of each fault that another strategy is to
/// make good.
///
/// Returns nothing where none is taken, which is never so of all strategies. Throws
/// Error(BOUNDARY_NOT_RECOVERED) where an attempt shows that others are in vain, or where the last
/// one, TetGen, fails too; an Error tells all that was tried.
std::optional<Attempt> first_taken(const Problem& problem, Report& report,
                                   std::span<const Strategy> of = strategies());

/// A regular mesh in the place of the one taken (`MeshStrategy::Renewed`); maybe not a valid one.
Attempt regular_mesh(const Problem& problem);

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/remesh/attempt.h"

namespace remeshd {

/// What a strategy reuses of the parent.
enum class Reuse : std::uint8_t {
  Mesh,        ///< all tets
  Nodes,       ///< the nodes that the plan copies, fixed where nothing changed
  FreedNodes,  ///< the nodes that the plan copies, all of them free
  Nothing,
};

/// A way to a mesh.
struct Strategy {
  MeshStrategy kind;
  const char* name;  ///< as the report lists attempts
  /// Whether it is to be tried. `failed`: the last attempt that made nodes, null if none did.
  bool (*applies)(const Problem& problem, const Attempt* failed);
  Attempt (*make)(const Strategy& how, const Problem& problem, const Attempt* failed);
  Reuse reuse = Reuse::Nothing;
  /// x edge length: how far from what changes the parent's mesh is cut open; infinite: all of it.
  double reach = 0;
  bool last_reach = false;       ///< no patch that is larger will be tried
  std::uint64_t other_seed = 0;  ///< added to the seed of the options
  /// What the warning about the last attempt says is done instead; null: there is no warning.
  const char* instead = nullptr;
  /// x edge length: the target length round the places where meshes of earlier attempts were wrong;
  /// all that is there is made anew. 0: nothing is refined.
  double refined = 0;
};

/// The road of the paper, Sects. 5 to 8 (remesh.cpp): nodes copied and new, free and fixed,
/// optimised, extracted, verified.
Attempt remesh_nodes(const Strategy& how, const Problem& problem, const Attempt* failed);

/// All strategies but the renewing of a drifted mesh, in the order in which they are tried.
std::span<const Strategy> strategies();
/// The first ones of them, which keep all tets of the parent.
std::span<const Strategy> tet_keeping_strategies();

/// Tries one strategy after the other until an attempt is taken. The report gets the attempts that
/// were given up, with their reasons and warnings, and the seconds of all. `run.on_warnings` is
/// called before any node is made, with the warnings so far and the names that will be lost, and
/// with each fault for which another strategy is tried.
///
/// Returns nothing where no attempt is taken, which cannot happen with all strategies. Throws
/// Error(BOUNDARY_NOT_RECOVERED) where two attempts in a row are hopeless, or where the last one,
/// TetGen, fails too; any Error lists all that was tried.
std::optional<Attempt> first_taken(const Problem& problem, Report& report,
                                   std::span<const Strategy> of = strategies());

/// An attempt at a regular mesh of new nodes alone, to renew a remesh (`MeshStrategy::Renewed`); it
/// may not be taken, and is not where it would have more nodes than `run.max_nodes`.
Attempt regular_mesh(const Problem& problem);

}  // namespace remeshd

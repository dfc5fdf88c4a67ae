#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "engine/remesh/remesh.h"
#include "tests/bench/sample.h"

namespace remeshd::bench {

/// What the engine does otherwise than by default.
struct Switches {
  /// A regular run as the paper has it: random start, Delaunay mesh built anew in every iteration.
  bool paper = false;
};

enum class RunKind {
  Regular,  ///< the modified model from scratch
  Remesh,   ///< the modified model from a mesh of the original
  Chain,    ///< to and fro between the two, each revision from the one before
};

/// A run of the engine in a process of its own.
struct EngineRun {
  RunKind kind = RunKind::Regular;
  std::string original, modified;  ///< files of model documents
  std::uint32_t nodes = 15000;     ///< of the original, or of the regular run
  std::uint32_t iterations = 10;   ///< 0: until quality stops improving
  std::uint64_t seed = 1;
  Switches switches;   ///< of a regular run
  int length = 20;     ///< of a chain
  bool sized = false;  ///< by the rules, not even
};

/// The samples by name: `regular`, `first` (of the original) and `remesh`, or `single` and `chain`.
/// A failure to mesh is a sample with that failure.
using Samples = std::map<std::string, Sample>;

/// Starts this program again to do the run, for at most `seconds` of wall clock.
Samples measure(const EngineRun& run, double seconds);

/// The name of the subcommand that `measure` starts, and what that does with its argument: it
/// returns the line to print.
inline constexpr const char* kWorkCommand = "work";
std::string work(const std::string& request);

/// The one place where switches become options.
MeshOptions mesh_options(const EngineRun& run);

}  // namespace remeshd::bench

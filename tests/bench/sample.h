#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "engine/mesh/quality.h"

namespace remeshd::bench {

/// Phases of a run by their names in Table 3 of the paper, s of wall clock; a regular run has t1 to
/// t3, a remesh t4 to t8.
struct Phases {
  double setup = 0;       ///< t1, t6
  double optimise = 0;    ///< t2, t7
  double extract = 0;     ///< t3, t8
  double difference = 0;  ///< t4
  double copy = 0;        ///< t5
};

/// One measured run, ours or a peer's.
struct Sample {
  std::string failure;  ///< why there is nothing else; empty where it went well
  double cpu = 0;       ///< s of processor time, helper processes included, of the meshing alone
  double wall = 0;      ///< s
  double surface = 0;   ///< of `cpu`, what a peer took for edges and faces
  double import = 0;    ///< s of processor time that a peer took to read the geometry
  double geometry = 0;  ///< s that making it took, once for all runs; of ours `cpu` has it
  Phases phases;        ///< ours
  std::uint32_t nodes = 0, tets = 0;
  std::uint32_t iterations = 0;  ///< ours, as many as it took
  double free_share = 0;         ///< ours: phi, mean over the iterations; frozen nodes are free
  std::string strategy;          ///< ours: how the mesh came about
  double peak_bytes = 0;      ///< most resident memory, above the process before it read anything
  double retained_bytes = 0;  ///< of a chain: memory that stays with each revision
  double kept = 0;            ///< ours: share of the nodes that are the base's
  /// Of a sized edit: shares of the base's nodes, those kept and those further than four local
  /// lengths from what the edit changed.
  double base_kept = 0, base_far = 0;
  double circle_edges = 0;  ///< ours: the fewest on a whole circle; 0: there are no circles
  /// Ours, away from sharp places of the model: mean volume-length and least dihedral angle.
  double away_mean = 0, away_angle = 0;
  Quality quality;  ///< but for the histogram
};

nlohmann::json write_sample(const Sample& sample);
Sample read_sample(const nlohmann::json& document);

/// Fills in what a peer's mesh tells: numbers and quality. Tets may be turned either way, all of
/// them the same.
void describe_mesh(std::span<const Vec3> nodes, std::span<const Tet> tets, Sample& sample);

/// The processor time and memory that a piece of work takes. Memory counts from `idle` on.
class Meter {
 public:
  /// Takes what is resident now as the idle process.
  Meter();
  /// Forgets time and peak so far.
  void start();
  /// Puts `cpu`, `wall` and `peak_bytes` since `start` into the sample.
  void stop(Sample& sample) const;

 private:
  double idle_bytes_;
  double cpu_ = 0, wall_ = 0;
};

/// s of processor time of this process and the children it has waited for.
double processor_seconds();
/// Resident now.
double resident_bytes();

}  // namespace remeshd::bench

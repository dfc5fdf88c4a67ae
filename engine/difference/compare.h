#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/cellular_model.h"

namespace remeshd {

/// One feature's difference as a report prints it; classes that do not occur are left out.
struct FeatureComparison {
  std::string id;
  std::map<std::string, double> cells;     ///< class (`++`, `.+`, ...) to volume
  std::map<std::string, double> faces;     ///< class (`bb`, `.b`, ...) to area
  std::map<std::string, double> edges;     ///< class to length; empty by membership
  std::map<std::string, double> vertices;  ///< class to count; empty by membership
  friend bool operator==(const FeatureComparison&, const FeatureComparison&) = default;
};

/// The difference between two models for people: `remesh diff`.
struct ModelComparison {
  /// Of the modified model in history order, then those of the original only.
  std::vector<FeatureComparison> features;
  double copycells = 0;  ///< volume of the modified model that the original can supply
  double newcells = 0;   ///< and the rest
  std::string method;    ///< `brep` or `membership`
  /// Absolute bound of the error of every volume above. Of the B-rep: rounding and the CAD kernel's
  /// tolerance. By membership: five standard errors, of newcells or added up over the classes of a
  /// feature, whichever is largest.
  double error_bound = 0;
  /// Why not the B-rep; empty where it was used.
  std::string remark;
};

/// Compares by B-rep overlay where features moved by at least 1e-2 kernel units (about 1e-4 of the
/// diagonal) or not at all, which is where the overlay is right, checks its volumes against
/// membership, and falls back to membership where the motion is smaller, the kernel fails or the
/// two disagree.
///
/// A null cellular model is built here. Throws what build_cells throws.
ModelComparison compare(const FeatureModel& original, const FeatureModel& modified,
                        const CellularModel* original_cells, const CellularModel* modified_cells,
                        const Run& run);

/// The smallest motion (a length) of features' surfaces between two models, seen from any feature
/// that both have: by changes of placement, of shape, or of features relative to each other.
/// Motions up to 1e-12 of the diagonal do not count; infinite where nothing else moves.
double smallest_motion(const FeatureModel& original, const FeatureModel& modified);

}  // namespace remeshd

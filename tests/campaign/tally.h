#pragma once

#include <iosfwd>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tests/campaign/parts/part_goals.h"
#include "tests/campaign/work.h"

namespace remeshd::campaign {

/// Counts of what was tried in one class of edits, and what came of it.
struct Results {
  int runs = 0, valid = 0, invalid = 0, crashes = 0, hangs = 0, refused = 0;
  int unplaced = 0;  ///< refusals that name no feature or no place
  int inserted = 0;  ///< meshes with nodes inserted to make the boundary complete
  double seconds = 0, verifier_seconds = 0, kept = 0;
  std::vector<double> times;  ///< of what ended, s of processors
  double least_angle = 180, least_quality = 1;
  int angle_below_5 = 0;                  ///< meshes whose least dihedral angle is, in degrees
  double away_angle = 180;                ///< the least away from the model's sharp places
  int away_below_5 = 0;                   ///< meshes where that is below 5 degrees
  int far_lost = 0;                       ///< meshes that lost nodes far from the change
  int with_last_resort = 0;               ///< in which a local last resort made tets
  int over_a_fifth = 0;                   ///< of the tets, of these
  std::map<std::string, int> reasons;     ///< of refusals
  std::map<std::string, int> checks;      ///< that invalid meshes failed
  std::map<std::string, int> strategies;  ///< as in Report

  void add(const Outcome& outcome);
};

/// What a campaign made and what came of it.
struct Tally {
  int cases = 0, gentle_cases = 0, edits = 0;
  int good_natured = 0, unmeasured = 0, topology_changed = 0;
  int tangent = 0, coincident = 0, wedge = 0;
  std::map<std::string, int> types, kinds, sizes, feature_counts, discarded;
  Results first_good, first_rest;  ///< first meshes
  Results good, rest;              ///< edits: both models good-natured; all others
  Results first_parts, parts;      ///< of detailed parts, which are neither
  PartFigures part_figures;

  void add(const WorkedCase& worked);
};

void print(const Tally& tally, std::ostream& out);
nlohmann::json write_tally(const Tally& tally);

}  // namespace remeshd::campaign

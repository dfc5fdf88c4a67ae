#pragma once

#include <iosfwd>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tests/campaign/work.h"

namespace remeshd::campaign {

/// What is asked of edits of detailed parts.
namespace part_goals {
inline constexpr double kFarLost = 0.01;  ///< share of edits that may lose nodes far from a change
inline constexpr double kLastResort = 0.2;  ///< share of the tets of any edit's mesh, at most
inline constexpr double kMostTime = 3;      ///< of any edit, by that of the part's first mesh
inline constexpr double kMedianTime = 0.3;  ///< of half of them
}  // namespace part_goals

/// How the edits of detailed parts came out, goal by goal.
struct PartFigures {
  int edits = 0, meshes = 0, invalid = 0, crashes = 0, hangs = 0, refused = 0;
  int tetgen = 0;               ///< meshes that TetGen made of the whole part
  int with_last_resort = 0;     ///< other edits in which a last resort made tets
  double most_last_resort = 0;  ///< the greatest of their shares
  double last_resort = 0;   ///< sum of the shares of tets that are a last resort's, kept ones too
  int far_lost = 0;         ///< edits that lost nodes further than kFar local lengths from a change
  double furthest = 0;      ///< of these nodes, in local lengths
  double away_angle = 180;  ///< least dihedral angle away from sharp places, degrees
  double kept = 0;          ///< sum of the shares of nodes kept
  std::vector<double> times;         ///< of edits, by that of the part's first mesh; of processors
  std::map<std::string, int> parts;  ///< edits
  std::map<std::string, int> far_lost_by_way;
  /// What missed a goal, by the goal: part, seed, case and step, and more.
  std::map<std::string, std::vector<std::string>> misses;

  /// A case of no part changes nothing.
  void add(const WorkedCase& worked);
  [[nodiscard]] double median_time() const;  ///< 0 where there are none
  [[nodiscard]] double most_time() const;

 private:
  void add(const CampaignCase& c, const Outcome& outcome, double first_seconds);
};

void print(const PartFigures& figures, std::ostream& out);
nlohmann::json write_figures(const PartFigures& figures);

}  // namespace remeshd::campaign

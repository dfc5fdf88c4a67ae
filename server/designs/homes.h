#pragma once

#include <string>
#include <vector>

namespace remeshd {

/// Where the names of designs are in a farm whose replicas have no database in common: each design
/// at one of them, its home, that all work out alike from its name. Elsewhere revisions are named
/// by their ids.
struct Homes {
  std::vector<std::string> replicas;  ///< addresses, as clients have them; empty: all are here
  std::string own;                    ///< that of this daemon, one of them

  /// The address of another replica that is the home of a design; empty where its home is here.
  [[nodiscard]] std::string elsewhere(const std::string& design) const;
  /// Throws Error(DESIGN_ELSEWHERE) for a design whose home is another replica; `design` may be
  /// empty, for none.
  void check(const std::string& design) const;
};

}  // namespace remeshd

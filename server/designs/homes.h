#pragma once

#include <string>
#include <vector>

namespace remeshd {

/// Which replica keeps the numbers and head of a design in a farm whose replicas share no database:
/// its home, which all replicas compute alike from the design's name. At the others its revisions
/// can be named by their ids only.
struct Homes {
  std::vector<std::string> replicas;  ///< addresses, as clients use them; empty: all homes are here
  std::string own;                    ///< address of this daemon, one of `replicas`

  /// The address of the design's home if that is another replica; empty if it is this one.
  [[nodiscard]] std::string elsewhere(const std::string& design) const;
  /// Throws Error(DESIGN_ELSEWHERE) for a design whose home is another replica; `design` may be
  /// empty, for none.
  void check(const std::string& design) const;
};

}  // namespace remeshd

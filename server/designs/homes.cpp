#include "server/designs/homes.h"

#include "proto/rendezvous.h"
#include "server/designs/design_error.h"

namespace remeshd {

std::string Homes::elsewhere(const std::string& design) const {
  if (replicas.empty() || design.empty()) return {};
  const std::string& home = replicas[first_by_rendezvous(replicas, design)];
  return home == own ? "" : home;
}

void Homes::check(const std::string& design) const {
  if (const std::string home = elsewhere(design); !home.empty())
    throw error::design_elsewhere(design, home);
}

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <vector>

#include "engine/extract/peel.h"
#include "engine/nodes/node_set.h"
#include "engine/optimise/optimise.h"
#include "engine/patch/stitch.h"
#include "engine/revision/report.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// A mesh on its way from the optimisation loop to delivery.
struct Candidate {
  NodeSet nodes;        ///< those of the patch's mesh only
  PeeledMesh delaunay;  ///< of the patch
  OptimiseResult loop;
  StitchedMesh whole;
  Verification verification;  ///< of the whole
  bool too_fine = false;      ///< the boundary would need many more nodes than the edge length says
  std::uint32_t bad_at_interface =
      0;  ///< ImproveResult::bad_at_interface: bad tets beside what is not in the patch
  double verify_seconds = 0;
  std::vector<TriedStrategy> given_up;  ///< earlier tries, by a strategy that makes several
};

}  // namespace remeshd

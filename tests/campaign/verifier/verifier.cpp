#include "tests/campaign/verifier/verifier.h"

#include "tests/support/flat.h"

namespace remeshd::campaign {

Findings verify_independently(const Revision& revision, const Revision* base,
                              std::set<std::uint64_t>& node_ids, std::set<std::uint64_t>& tet_ids) {
  Findings findings;
  const std::vector<Triangle> facets =
      check_connectivity(test::flat(revision.output.mesh), findings);
  check_maps(revision, base, node_ids, tet_ids, findings);
  if (findings.has("index")) return findings;
  check_shape(revision, facets, findings);
  check_names(revision, facets, findings);
  return findings;
}

}  // namespace remeshd::campaign

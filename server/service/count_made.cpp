#include "server/service/count_made.h"

namespace remeshd {

void count_made(const FrontDesk& desk, const Made& made) {
  if (!desk.metrics || made.cached) return;
  const Report& report = made.revision->revision.report;
  const PhaseSeconds& seconds = report.seconds;
  RevisionFigures figures{.phases = {{"setup", seconds.setup},
                                     {"difference", seconds.difference},
                                     {"copy", seconds.copy},
                                     {"optimise", seconds.optimise},
                                     {"extract", seconds.extract},
                                     {"verify", seconds.verify},
                                     {"total", seconds.total}},
                          .least_dihedral = report.quality.dihedral_min};
  if (!made.filed.record.parent.empty() && report.counts.tets > 0)
    figures.reuse = static_cast<double>(report.counts.tets_kept) / report.counts.tets;
  desk.metrics->computed(figures);
  desk.metrics->cache_request(Metrics::CacheResult::Computed);
}

}  // namespace remeshd

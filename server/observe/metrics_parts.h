#pragma once

#include <prometheus/collectable.h>
#include <prometheus/counter.h>
#include <prometheus/family.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "server/observe/metrics.h"

namespace remeshd {

/// The figures as prometheus-cpp keeps them; for metrics.cpp and metrics_server.cpp alone.
struct Metrics::Parts final : prometheus::Collectable {
  Parts(const std::string& version, std::uint32_t algorithm_version);

  /// What was counted and what the sources tell now.
  [[nodiscard]] std::vector<prometheus::MetricFamily> Collect() const override;

  template <typename Metric>
  using Family = prometheus::Family<Metric>;

  prometheus::Registry registry;
  Family<prometheus::Counter>& calls;
  Family<prometheus::Counter>& refusals;
  Family<prometheus::Counter>& cache_requests;
  Family<prometheus::Counter>& evictions;
  Family<prometheus::Histogram>& call_seconds;
  Family<prometheus::Histogram>& queue_wait;
  Family<prometheus::Histogram>& phases;
  Family<prometheus::Histogram>& reuse;
  Family<prometheus::Histogram>& least_dihedral;
  mutable std::mutex mutex;
  std::map<std::string, Metrics::Source> sources;
};

}  // namespace remeshd

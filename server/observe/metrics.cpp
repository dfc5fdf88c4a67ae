#include "server/observe/metrics.h"

#include <prometheus/text_serializer.h>

#include "server/observe/metrics_parts.h"

namespace remeshd {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;
using Buckets = prometheus::Histogram::BucketBoundaries;

const Buckets kSeconds{.001, .0025, .005, .01, .025, .05, .1, .25, .5, 1, 2.5, 5, 10, 30, 60, 300};
const Buckets kShares{.1, .2, .3, .4, .5, .6, .7, .8, .9, .95, .99, 1};
const Buckets kDegrees{1, 2, 5, 10, 15, 20, 25, 30, 35, 40, 50};

template <typename Metric>
prometheus::Family<Metric>& family(prometheus::Registry& registry, const char* name,
                                   const char* help) {
  return prometheus::detail::Builder<Metric>().Name(name).Help(help).Register(registry);
}

/// Adds a figure with its present value; nothing where it has none.
void add(std::vector<MetricFamily>& out, const char* name, const char* help,
         const std::optional<double>& value, MetricType type = MetricType::Gauge) {
  if (!value) return;
  MetricFamily each{.name = name, .help = help, .type = type, .metric = {ClientMetric()}};
  each.metric.front().gauge.value = each.metric.front().counter.value = *value;
  out.push_back(std::move(each));
}

/// Drops exceptions: counting must neither fail the work that is counted nor end a scraper's
/// thread.
template <typename Count>
void count(Count&& work) noexcept {
  try {
    work();
  } catch (...) {
  }
}

}  // namespace

Metrics::Parts::Parts(const std::string& version, std::uint32_t algorithm_version)
    : calls(family<prometheus::Counter>(registry, "remeshd_calls_total",
                                        "Calls that have ended, and requests of streams")),
      refusals(family<prometheus::Counter>(registry, "remeshd_refusals_total",
                                           "Calls that were refused, by the reason of the error")),
      cache_requests(family<prometheus::Counter>(registry, "remeshd_cache_requests_total",
                                                 "Requested revisions by where they came from")),
      evictions(family<prometheus::Counter>(registry, "remeshd_evictions_total",
                                            "Revisions that went for want of room")),
      call_seconds(
          family<prometheus::Histogram>(registry, "remeshd_call_seconds",
                                        "Duration of calls and of streams' requests, in seconds")),
      queue_wait(
          family<prometheus::Histogram>(registry, "remeshd_queue_wait_seconds",
                                        "Time that work waited before it began, in seconds")),
      phases(family<prometheus::Histogram>(registry, "remeshd_phase_seconds",
                                           "Duration of the phases of a computation, in seconds")),
      reuse(family<prometheus::Histogram>(registry, "remeshd_reuse_ratio",
                                          "Share of an edit's tets that its base has too, 0 to 1")),
      least_dihedral(family<prometheus::Histogram>(registry, "remeshd_least_dihedral_degrees",
                                                   "Least dihedral angle of a mesh, in degrees")) {
  family<prometheus::Gauge>(registry, "remeshd_build_info", "Version of the program; always 1")
      .Add({{"version", version}, {"algorithm", std::to_string(algorithm_version)}})
      .Set(1);
}

std::vector<MetricFamily> Metrics::Parts::Collect() const {
  MetricsReadings now;
  {
    const std::scoped_lock lock(mutex);
    for (const auto& [name, source] : sources) count([&] { source(now); });
  }
  std::vector<MetricFamily> out = registry.Collect();
  if (now.ready) add(out, "remeshd_ready", "1 while the daemon is ready", *now.ready ? 1 : 0);
  if (!now.queue_depth.empty()) {
    MetricFamily depth{
        .name = "remeshd_queue_depth", .help = "Work that waits", .type = MetricType::Gauge};
    for (const auto& [lane, waiting] : now.queue_depth) {
      ClientMetric each;
      each.label = {{"lane", lane}};
      each.gauge.value = waiting;
      depth.metric.push_back(std::move(each));
    }
    out.push_back(std::move(depth));
  }
  add(out, "remeshd_computations_running", "Computations at work", now.computations_running);
  add(out, "remeshd_memory_bytes",
      "Bytes of memory that revisions held, computations, loads and streams take",
      now.memory_bytes);
  add(out, "remeshd_memory_budget_bytes", "Bytes of memory that they may take",
      now.memory_budget_bytes);
  add(out, "remeshd_disk_bytes", "Bytes that the revisions stored take on the disk",
      now.disk_bytes);
  add(out, "remeshd_disk_budget_bytes", "Bytes that they may take", now.disk_budget_bytes);
  add(out, "remeshd_tier_waiting", "Objects that the shared tier is still to get",
      now.tier_waiting);
  add(out, "remeshd_revisions", "Revisions in the catalogue", now.revisions);
  add(out, "remeshd_connections", "Connections that are open", now.connections);
  add(out, "remeshd_streams", "Streams that are open", now.streams);
  add(out, "remeshd_helper_crashes_total", "Crashes of the TetGen helper", now.helper_crashes,
      MetricType::Counter);
  add(out, "remeshd_log_dropped_total", "Lines of the log that were never written", now.log_dropped,
      MetricType::Counter);
  return out;
}

Metrics::Metrics(const std::string& version, std::uint32_t algorithm_version)
    : parts_(std::make_shared<Parts>(version, algorithm_version)) {}
Metrics::~Metrics() = default;

void Metrics::call_ended(const std::string& method, const std::string& code,
                         double seconds) noexcept {
  count([&] {
    parts_->calls.Add({{"method", method}, {"code", code}}).Increment();
    parts_->call_seconds.Add({{"method", method}}, kSeconds).Observe(seconds);
  });
}
void Metrics::refused(const std::string& reason) noexcept {
  count([&] { parts_->refusals.Add({{"reason", reason}}).Increment(); });
}
void Metrics::queue_waited(const std::string& lane, double seconds) noexcept {
  count([&] { parts_->queue_wait.Add({{"lane", lane}}, kSeconds).Observe(seconds); });
}

void Metrics::computed(const RevisionFigures& figures) noexcept {
  count([&] {
    for (const auto& [phase, seconds] : figures.phases)
      parts_->phases.Add({{"phase", phase}}, kSeconds).Observe(seconds);
    if (figures.reuse) parts_->reuse.Add({}, kShares).Observe(*figures.reuse);
    parts_->least_dihedral.Add({}, kDegrees).Observe(figures.least_dihedral);
  });
}

void Metrics::cache_request(CacheResult result) noexcept {
  static constexpr const char* kNames[] = {"memory", "disk", "tier", "computed", "remade"};
  count([&] {
    parts_->cache_requests.Add({{"result", kNames[static_cast<std::size_t>(result)]}}).Increment();
  });
}
void Metrics::evicted(Tier from) noexcept {
  count([&] {
    parts_->evictions.Add({{"from", from == Tier::Memory ? "memory" : "disk"}}).Increment();
  });
}
void Metrics::set_source(const std::string& name, Source source) {
  const std::scoped_lock lock(parts_->mutex);
  if (source)
    parts_->sources[name] = std::move(source);
  else
    parts_->sources.erase(name);
}

std::string Metrics::text() const {
  return prometheus::TextSerializer().Serialize(parts_->Collect());
}

}  // namespace remeshd

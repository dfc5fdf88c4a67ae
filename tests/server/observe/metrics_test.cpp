#include "server/observe/metrics.h"

#include <gmock/gmock.h>

#include "server/observe/metrics_server.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(MetricsTexts, HaveWhatWasCounted) {
  Metrics metrics("1.2.3", 13);
  metrics.call_ended("GetMesh", "OK", 0.02);
  metrics.call_ended("GetMesh", "OK", 0.03);
  metrics.refused("BUSY");
  metrics.queue_waited("computation", 1);
  metrics.computed({.phases = {{"optimise", 0.5}}, .reuse = 0.75, .least_dihedral = 25});
  metrics.cache_request(Metrics::CacheResult::Disk);
  metrics.evicted(Metrics::Tier::Memory);
  const std::string text = metrics.text();
  for (const char* line :
       {"remeshd_build_info{algorithm=\"13\",version=\"1.2.3\"} 1",
        "remeshd_calls_total{code=\"OK\",method=\"GetMesh\"} 2",
        "remeshd_call_seconds_count{method=\"GetMesh\"} 2",
        "remeshd_call_seconds_bucket{method=\"GetMesh\",le=\"0.025\"} 1",
        "remeshd_refusals_total{reason=\"BUSY\"} 1",
        "remeshd_queue_wait_seconds_count{lane=\"computation\"} 1",
        "remeshd_phase_seconds_sum{phase=\"optimise\"} 0.5", "remeshd_reuse_ratio_sum 0.75",
        "remeshd_least_dihedral_degrees_count 1", "remeshd_cache_requests_total{result=\"disk\"} 1",
        "remeshd_evictions_total{from=\"memory\"} 1"})
    EXPECT_THAT(text, HasSubstr(std::string(line) + '\n'));
}

TEST(MetricsTexts, HaveWhatSourcesTellNowAndLeaveOutWhatNoneKnows) {
  Metrics metrics("1.2.3", 13);
  EXPECT_THAT(metrics.text(), Not(HasSubstr("remeshd_memory_bytes")));
  double bytes = 100;
  metrics.set_source("daemon", [&](MetricsReadings& out) {
    out.ready = true;
    out.memory_bytes = bytes;
    out.queue_depth = {{"computation", 3}, {"metadata", 0}};
  });
  metrics.set_source("log", [](MetricsReadings& out) { out.log_dropped = 7; });
  metrics.set_source("helper", [](MetricsReadings& out) { out.helper_crashes = 2; });
  bytes = 200;
  const std::string text = metrics.text();
  for (const char* line :
       {"remeshd_ready 1", "remeshd_memory_bytes 200",
        "remeshd_queue_depth{lane=\"computation\"} 3", "remeshd_queue_depth{lane=\"metadata\"} 0",
        "# TYPE remeshd_helper_crashes_total counter\nremeshd_helper_crashes_total 2",
        "# TYPE remeshd_log_dropped_total counter\nremeshd_log_dropped_total 7"})
    EXPECT_THAT(text, HasSubstr(std::string(line) + '\n'));
  EXPECT_THAT(text, Not(HasSubstr("disk")));
  metrics.set_source("daemon", {});
  EXPECT_THAT(metrics.text(), Not(HasSubstr("remeshd_ready")));
}

TEST(MetricsTexts, SurviveASourceThatThrows) {
  Metrics metrics("1.2.3", 13);
  metrics.set_source("broken", [](MetricsReadings&) { throw std::runtime_error("no"); });
  metrics.set_source("log", [](MetricsReadings& out) { out.log_dropped = 7; });
  metrics.set_source("helper", [](MetricsReadings& out) { out.helper_crashes = 2; });
  EXPECT_THAT(metrics.text(), HasSubstr("remeshd_log_dropped_total 7"));
}

/// The answer to a GET of HTTP/1.0.
std::string get(int port, const std::string& path) {
  const Descriptor connection = connect_to("127.0.0.1:" + std::to_string(port));
  const std::string request = "GET " + path + " HTTP/1.0\r\n\r\n";
  ::send(connection.get(), request.data(), request.size(), MSG_NOSIGNAL);
  std::string answer;
  char bytes[4096];
  while (readable(connection)) {
    const ssize_t got = ::recv(connection.get(), bytes, sizeof(bytes), 0);
    if (got <= 0) break;
    answer.append(bytes, static_cast<std::size_t>(got));
  }
  return answer;
}

TEST(MetricsServers, ServeTheTextUnderMetrics) {
  const Metrics metrics("1.2.3", 13);
  const MetricsServer server(metrics, "127.0.0.1:0");
  EXPECT_GT(server.port(), 0);
  const std::string answer = get(server.port(), "/metrics");
  EXPECT_THAT(answer, HasSubstr("200 OK"));
  EXPECT_THAT(answer, HasSubstr("remeshd_build_info{"));
  EXPECT_THAT(get(server.port(), "/etc/passwd"), HasSubstr("404"));
}

TEST(MetricsServers, ThatCannotListenSaySo) {
  const Metrics metrics("1.2.3", 13);
  const MetricsServer first(metrics, "127.0.0.1:0");
  EXPECT_THROW(MetricsServer(metrics, "127.0.0.1:" + std::to_string(first.port())),
               std::runtime_error);
}

}  // namespace
}  // namespace remeshd::test

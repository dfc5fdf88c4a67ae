#include "server/observe/metrics_server.h"

#include <prometheus/exposer.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "server/limits.h"
#include "server/observe/metrics_parts.h"

namespace remeshd {
namespace {

std::vector<std::string> options_for(const std::string& address) {
  return {"listening_ports",    address,
          "num_threads",        std::to_string(limits::kScrapes),
          "request_timeout_ms", std::to_string(limits::kScrapeTimeoutMs)};
}

}  // namespace

struct MetricsServer::Parts {
  explicit Parts(const std::string& address) : exposer(options_for(address)) {}
  prometheus::Exposer exposer;
};

MetricsServer::MetricsServer(const Metrics& metrics, const std::string& address) try
    : parts_(std::make_unique<Parts>(address)) {
  parts_->exposer.RegisterCollectable(std::weak_ptr<prometheus::Collectable>(metrics.parts()));
} catch (const std::exception&) {  // its text tells nothing
  throw std::runtime_error("cannot serve metrics on " + address +
                           ": is the port taken, or the address not this machine's?");
}

MetricsServer::~MetricsServer() = default;

int MetricsServer::port() const {
  const std::vector<int> ports = parts_->exposer.GetListeningPorts();
  return ports.empty() ? 0 : ports.front();
}

}  // namespace remeshd

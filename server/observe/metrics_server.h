#pragma once

#include <memory>
#include <string>

#include "server/observe/metrics.h"

namespace remeshd {

/// Serves metrics over HTTP, under `/metrics`, as long as it lives.
class MetricsServer {
 public:
  /// `address`: an IPv4 address or an IPv6 address in brackets, and a port; 0 takes a free one.
  /// Throws std::runtime_error where it cannot be listened on.
  MetricsServer(const Metrics& metrics, const std::string& address);
  ~MetricsServer();
  MetricsServer(const MetricsServer&) = delete;
  MetricsServer& operator=(const MetricsServer&) = delete;

  [[nodiscard]] int port() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remeshd

#include "server/process/serve.h"

#include <sys/stat.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "server/designs/postgres_designs.h"
#include "server/guard/doorman.h"
#include "server/guard/tier_secrets.h"
#include "server/limits.h"
#include "server/observe/log.h"
#include "server/observe/metrics.h"
#include "server/observe/metrics_server.h"
#include "server/process/grpc_log.h"
#include "server/process/port_file.h"
#include "server/process/service_manager.h"
#include "server/process/signal_watch.h"
#include "server/session/background.h"
#include "server/transport/descriptor_limit.h"
#include "server/transport/listen_address.h"

#ifndef REMESHD_VERSION
#error "the build gives the version"
#endif

namespace remeshd {
namespace {

std::string name_of(int signal) { return signal == SIGTERM ? "SIGTERM" : "SIGINT"; }

/// Ends the process by force after so many seconds, unless it has ended by itself: the store is
/// consistent at any moment.
void end_within(double seconds, Log& log) {
  std::thread([seconds, &log] {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    log.logger()->error("does not come to rest; ended by force");
    log.flush(std::chrono::milliseconds(200));
    std::_Exit(EXIT_FAILURE);
  }).detach();
}

void warn_of_risks(const Configuration& configuration, spdlog::logger& log) {
  const Settings& settings = configuration.settings;
  for (const std::string& address : settings.daemon.listen)
    if (!settings.daemon.tls.mutual() && !parse_listen_address(address).is_loopback())
      log.warn("{} can be reached from elsewhere, without mutual TLS", address);
}

/// civetweb takes numeric addresses, no names.
std::string metrics_address(const std::string& text) {
  const ListenAddress address = parse_listen_address(text);
  return numeric(address.sockets.front());
}

/// Reopens the log and reads the tokens anew. Where they cannot be read, or the store of a tenant
/// cannot be opened, the old tokens stay in force: a mistake locks nobody out.
void reload(Log& log, Doorman* doorman) {
  log.reopen();
  try {
    if (doorman != nullptr) doorman->reload();
    log.logger()->info("reloaded on SIGHUP");
  } catch (const std::exception& why) {
    log.logger()->error("SIGHUP: the tokens stay as they are: {}", why.what());
  }
}

Sharing sharing_of(const TierSettings& tier, const DesignSettings& designs,
                   const std::shared_ptr<spdlog::logger>& logger) {
  if (tier.place.empty()) return {};
  const TierSecrets secrets = read_tier_secrets(tier.key_file, tier.s3_credentials_file);
  const auto tell = [logger](const std::string& line) { logger->warn("tier: {}", line); };
  return {.objects = open_objects(tier.place, tier.s3_region, secrets, tell),
          .farm_key = secrets.farm_key,
          .acknowledge_in_tier = tier.acknowledge == "tier",
          .tell = tell,
          .designs = designs.catalogue.empty()
                         ? nullptr
                         : std::make_shared<PostgresDesigns>(designs.catalogue),
          .homes = {.replicas = designs.replicas, .own = designs.replica}};
}

}  // namespace

void serve(const Configuration& configuration, Engine engine) {
  const Settings& settings = configuration.settings;
  ::umask(0077);  // files that it makes are its user's alone: revisions, log, dumps
  raise_descriptor_limit();
  Log log(settings.log);
  const auto logger = log.logger();
  redirect_grpc_log(logger);
  const std::shared_ptr<Doorman> doorman =
      settings.token_file.empty() ? nullptr : std::make_shared<Doorman>(settings.token_file);
  // On a thread of its own: opening the stores of new tenants must not keep signals waiting.
  Background reloader([&] {
    reload(log, doorman.get());
    return false;
  });
  SignalWatch signals([&] { reloader.ask(); },
                      [&](int signal) {
                        logger->warn("ended at once by {}", name_of(signal));
                        log.flush(std::chrono::milliseconds(200));
                      });
  warn_of_risks(configuration, *logger);
  const PortFile port_file(settings.port_file);
  DaemonOptions options = settings.daemon;
  options.log = logger;
  options.doorman = doorman;
  options.sharing = sharing_of(settings.tier, settings.designs, logger);
  if (!settings.metrics.empty()) {
    options.metrics = std::make_shared<Metrics>(REMESHD_VERSION, engine.algorithm_version);
    options.metrics->set_source("log", [&log](MetricsReadings& out) {
      out.log_dropped = static_cast<double>(log.dropped());
    });
  }
  if (!settings.health_socket.empty())
    options.listen.push_back("unix:" + settings.health_socket.string());
  if (!options.store.empty()) logger->info("opening the store {}", options.store.string());
  Daemon daemon(options, std::move(engine));
  signals.serving();
  for (const std::string& address : daemon.addresses())
    logger->info("serving remesh.v1 on {}, {}", address,
                 options.store.empty() ? "in memory" : "store " + options.store.string());
  std::optional<MetricsServer> metrics;
  if (options.metrics) {
    metrics.emplace(*options.metrics, metrics_address(settings.metrics));
    logger->info("serving metrics on port {}", metrics->port());
  }
  port_file.write(daemon.addresses());
  if (!notify_service_manager("READY=1")) logger->warn("NOTIFY_SOCKET cannot be written to");

  logger->info("ending on {}", name_of(signals.wait_for_end()));
  notify_service_manager("STOPPING=1");
  end_within(settings.grace + limits::kUntilRest, log);
  daemon.shutdown(settings.grace);
  logger->info("ended");
  redirect_grpc_log(nullptr);
}

}  // namespace remeshd

#include "server/process/serve.h"

#include <sys/stat.h>

#include <cstdlib>
#include <string>
#include <thread>
#include <utility>

#include "server/observe/log.h"
#include "server/process/port_file.h"
#include "server/process/service_manager.h"
#include "server/process/signal_watch.h"
#include "server/transport/descriptor_limit.h"
#include "server/transport/listen_address.h"

namespace remeshd {
namespace {

/// Beyond the grace time: computations hear of their end within a fraction of a second.
constexpr double kUntilRest = 8;

std::string name_of(int signal) { return signal == SIGTERM ? "SIGTERM" : "SIGINT"; }

/// What does not come to rest must not keep the process: what is stored is whole at any moment.
void end_within(double seconds, Log& log) {
  std::thread([seconds, &log] {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    log.logger()->error("does not come to rest; ended by force");
    log.flush(std::chrono::milliseconds(200));
    std::_Exit(EXIT_FAILURE);
  }).detach();
}

void warn_of_risks(const Configuration& configuration, spdlog::logger& log) {
  for (const std::string& warning : configuration.warnings) log.warn(warning);
  for (const std::string& address : configuration.settings.daemon.listen)
    if (!parse_listen_address(address).is_loopback())
      log.warn("{} can be reached from elsewhere, and neither encrypts nor authenticates", address);
}

}  // namespace

void serve(const Configuration& configuration, Engine engine) {
  const Settings& settings = configuration.settings;
  ::umask(0077);  // what it writes is its own: revisions, log, dumps
  raise_descriptor_limit();
  Log log(settings.log);
  const auto logger = log.logger();
  SignalWatch signals(
      [&] {
        log.reopen();
        logger->info("reloaded on SIGHUP");
      },
      [&](int signal) {
        logger->warn("ended at once by {}", name_of(signal));
        log.flush(std::chrono::milliseconds(200));
      });
  warn_of_risks(configuration, *logger);
  const PortFile port_file(settings.port_file);
  DaemonOptions options = settings.daemon;
  options.log = logger;
  if (!settings.health_socket.empty())
    options.listen.push_back("unix:" + settings.health_socket.string());
  if (!options.store.empty()) logger->info("opening the store {}", options.store.string());
  Daemon daemon(options, std::move(engine));
  signals.serving();
  for (const std::string& address : daemon.addresses())
    logger->info("serving remesh.v1 on {}, {}", address,
                 options.store.empty() ? "in memory" : "store " + options.store.string());
  port_file.write(daemon.addresses());
  if (!notify_service_manager("READY=1")) logger->warn("NOTIFY_SOCKET cannot be written to");

  logger->info("ending on {}", name_of(signals.wait_for_end()));
  notify_service_manager("STOPPING=1");
  end_within(settings.grace + kUntilRest, log);
  daemon.shutdown(settings.grace);
  logger->info("ended");
}

}  // namespace remeshd

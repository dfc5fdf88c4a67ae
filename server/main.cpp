#include <pthread.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdlib>
#include <thread>

#include "engine/base/error.h"
#include "server/daemon.h"
#include "server/transport/descriptor_limit.h"
#include "server/transport/listen_address.h"

namespace {

using remeshd::DaemonOptions;

/// What ends the daemon; blocked in every thread, so that only `sigwait` sees it.
sigset_t end_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  return signals;
}

std::shared_ptr<spdlog::logger> make_log(const std::string& level, const std::string& file) {
  spdlog::sink_ptr sink;
  if (file.empty()) {
    sink = std::make_shared<spdlog::sinks::stderr_sink_mt>();
  } else {
    sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(file);
  }
  auto log = std::make_shared<spdlog::logger>("remeshd", sink);
  log->set_level(spdlog::level::from_str(level));
  log->set_pattern("%Y-%m-%dT%H:%M:%S.%e%z %^%l%$ %v");
  log->flush_on(spdlog::level::info);
  return log;
}

/// A computation that does not hear of its end must not keep the process: what is stored is whole
/// at any moment.
void leave_within(std::chrono::seconds limit) {
  std::thread([limit] {
    std::this_thread::sleep_for(limit);
    std::_Exit(EXIT_SUCCESS);
  }).detach();
}

}  // namespace

int main(int argc, char** argv) {
  const sigset_t signals = end_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  remeshd::raise_descriptor_limit();

  DaemonOptions options;
  std::string level = "info";
  std::string log_file;
  std::uint64_t cache_mib = options.memory >> 20U;
  CLI::App app("Serves remesh.v1: tetrahedral meshes of feature models and of their edits.");
  app.set_version_flag("--version", std::string("remeshd " REMESHD_VERSION));
  app.add_option("--listen", options.listen,
                 "HOST:PORT to serve on; port 0 takes a free one; or unix:/PATH, a Unix socket")
      ->capture_default_str();
  app.add_option("--max-connections", options.max_connections, "connections at a time")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  app.add_option("--store", options.store,
                 "folder that keeps the revisions; without it they live in memory only");
  app.add_option("--workers", options.workers, "computations at a time; 0: one per processor")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  app.add_option("--threads", options.threads,
                 "most threads of one computation; 0: one per processor")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  app.add_option("--queue", options.queue, "computations that may wait for a worker")
      ->capture_default_str();
  app.add_option("--queue-wait", options.queue_wait, "seconds that one may wait")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--cache", cache_mib, "MiB of revisions held in memory")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--max-nodes", options.max_nodes, "most nodes that a request may ask for")
      ->capture_default_str()
      ->check(CLI::Range(20, 5000000));
  app.add_option("--dumps", options.dumps,
                 "folder in which every computation leaves its stages, for debugging");
  app.add_option("--log-level", level, "trace, debug, info, warning, error, off")
      ->capture_default_str()
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "off"}));
  app.add_option("--log-file", log_file, "file to append the log to, instead of stderr");
  CLI11_PARSE(app, argc, argv);
  options.memory = cache_mib << 20U;

  try {
    options.log = make_log(level, log_file);
    const auto log = options.log;
    // An empty address is none: a daemon that nothing can reach is no daemon.
    if (!remeshd::parse_listen_address(options.listen).is_loopback())
      log->warn("{} can be reached from elsewhere, and neither encrypts nor authenticates",
                options.listen);
    remeshd::Daemon daemon(options, remeshd::production_engine());
    log->info("serving remesh.v1 on {}, {}", daemon.address(),
              options.store.empty() ? "in memory" : "store " + options.store.string());
    int signal = 0;
    sigwait(&signals, &signal);
    log->info("ending on {}", signal == SIGTERM ? "SIGTERM" : "SIGINT");
    leave_within(std::chrono::seconds(8));
    daemon.shutdown();
    log->info("ended");
    return EXIT_SUCCESS;
  } catch (const remeshd::Error& failure) {
    std::fprintf(stderr, "remeshd: %s\n", failure.what());
    if (!failure.info().hint.empty())
      std::fprintf(stderr, "hint: %s\n", failure.info().hint.c_str());
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "remeshd: %s\n", failure.what());
  }
  return EXIT_FAILURE;
}

#include <pthread.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <cstdlib>
#include <thread>

#include "engine/base/error.h"
#include "server/config/configuration.h"
#include "server/config/environment.h"
#include "server/daemon.h"
#include "server/transport/descriptor_limit.h"
#include "server/transport/listen_address.h"

namespace {

using remeshd::Configuration;
using remeshd::Settings;

/// What ends the daemon; blocked in every thread, so that only `sigwait` sees it.
sigset_t end_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  return signals;
}

std::shared_ptr<spdlog::logger> make_log(const Settings& settings) {
  spdlog::sink_ptr sink;
  if (settings.log_file.empty()) {
    sink = std::make_shared<spdlog::sinks::stderr_sink_mt>();
  } else {
    sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(settings.log_file);
  }
  auto log = std::make_shared<spdlog::logger>("remeshd", sink);
  log->set_level(spdlog::level::from_str(settings.log_level));
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

/// Serves until a signal ends it.
void serve(const Configuration& configuration, const sigset_t& signals) {
  remeshd::raise_descriptor_limit();
  const auto log = make_log(configuration.settings);
  remeshd::DaemonOptions options = configuration.settings.daemon;
  options.log = log;
  for (const std::string& warning : configuration.warnings) log->warn(warning);
  for (const std::string& address : options.listen)
    if (!remeshd::parse_listen_address(address).is_loopback())
      log->warn("{} can be reached from elsewhere, and neither encrypts nor authenticates",
                address);
  remeshd::Daemon daemon(options, remeshd::production_engine());
  for (const std::string& address : daemon.addresses())
    log->info("serving remesh.v1 on {}, {}", address,
              options.store.empty() ? "in memory" : "store " + options.store.string());
  int signal = 0;
  sigwait(&signals, &signal);
  log->info("ending on {}", signal == SIGTERM ? "SIGTERM" : "SIGINT");
  leave_within(std::chrono::seconds(8));
  daemon.shutdown();
  log->info("ended");
}

void run(const Configuration& configuration, const sigset_t& signals) {
  if (configuration.answer) {
    std::fputs(configuration.answer->c_str(), stdout);
    return;
  }
  remeshd::check_settings(configuration.settings);
  switch (configuration.task) {
    case remeshd::Task::Serve:
      return serve(configuration, signals);
    case remeshd::Task::CheckConfig:
      for (const std::string& warning : configuration.warnings)
        std::fprintf(stderr, "remeshd: %s\n", warning.c_str());
      std::puts("OK");
      return;
    case remeshd::Task::PrintConfig:
      std::fputs(remeshd::print_config(configuration.settings).c_str(), stdout);
      return;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const sigset_t signals = end_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    run(remeshd::read_configuration({argv + 1, argv + argc}, remeshd::process_environment()),
        signals);
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

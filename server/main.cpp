#include <cstdio>
#include <cstdlib>
#include <exception>

#include "engine/base/error.h"
#include "server/admission/process_memory.h"
#include "server/config/configuration.h"
#include "server/config/environment.h"
#include "server/process/health_probe.h"
#include "server/process/serve.h"
#include "server/process/signal_watch.h"

namespace {

using remeshd::Configuration;
using remeshd::Task;

int probe(const Configuration& configuration) {
  const std::string address = remeshd::health_address(configuration);
  const auto health =
      remeshd::probe_health(address, configuration.health_service, std::chrono::seconds(3));
  constexpr const char* kWords[] = {"serving", "not serving", "unreachable"};
  const int code = static_cast<int>(health);
  std::printf("%s: %s\n", address.c_str(), kWords[code]);
  return code;
}

int run(const Configuration& configuration) {
  if (configuration.answer) {
    std::fputs(configuration.answer->c_str(), stdout);
    return EXIT_SUCCESS;
  }
  if (configuration.task == Task::Health) return probe(configuration);
  remeshd::check_settings(configuration.settings);
  if (configuration.task == Task::PrintConfig) {
    std::fputs(remeshd::print_config(configuration.settings).c_str(), stdout);
  } else if (configuration.task == Task::CheckConfig) {
    std::puts("OK");
  } else {
    remeshd::serve(configuration, remeshd::production_engine());
  }
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  remeshd::keep_few_heaps();
  remeshd::block_signals();
  try {
    return run(
        remeshd::read_configuration({argv + 1, argv + argc}, remeshd::process_environment()));
  } catch (const remeshd::Error& failure) {
    std::fprintf(stderr, "remeshd: %s\n", failure.what());
    if (!failure.info().hint.empty())
      std::fprintf(stderr, "hint: %s\n", failure.info().hint.c_str());
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "remeshd: %s\n", failure.what());
  }
  return EXIT_FAILURE;
}

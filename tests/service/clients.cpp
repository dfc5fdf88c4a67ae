#include <thread>
#include <vector>

#include "tests/service/edit_load.h"
#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"

// What two clients get done beside what one does, with a worker each. Rounds of one and of two take
// turns, so that other load on the machine falls on both.
namespace remeshd::test {
namespace {

struct Settings {
  std::uint32_t nodes = 15000;
  double seconds = 10;
  int rounds = 5;
  bool goals = false;
};

int run(const Settings& settings) {
  const StoreFolder store("clients");
  ServedDaemon daemon({"--workers", "2", "--threads", "1", "--store", store.path()});
  EditLoad load(daemon.stub(), made_by(daemon.stub(), create_tool1(settings.nodes)));
  load.closed_loop(2, settings.seconds / 5);  // to warm up
  std::vector<double> one, two, ratio, used;
  for (int i = 0; i < settings.rounds; ++i) {
    one.push_back(load.closed_loop(1, settings.seconds).done_per_second);
    const double before = daemon.processor_seconds();
    const auto start = Clock::now();
    two.push_back(load.closed_loop(2, settings.seconds).done_per_second);
    used.push_back((daemon.processor_seconds() - before) / seconds_since(start));
    ratio.push_back(two.back() / one.back());
  }
  Goals goals(settings.goals);
  goals.tell("edits by one client", median(one), "/s");
  goals.tell("edits by two clients", median(two), "/s");
  goals.tell("processors that two clients' edits got", median(used));
  goals.at_least("two clients over one, median of the rounds", median(ratio), "", 1.8);
  return goals.exit_status();
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("Throughput of two clients over that of one", settings.goals);
  CLI::App& options = program.options();
  options.add_option("--nodes", settings.nodes);
  options.add_option("--seconds", settings.seconds, "of a round");
  options.add_option("--rounds", settings.rounds);
  return program.run(argc, argv, [&] { return remeshd::test::run(settings); });
}

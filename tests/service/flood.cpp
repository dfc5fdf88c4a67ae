#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/service/edit_load.h"
#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/log_lines.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"
#include "tests/support/processors.h"

// Clients ask for many times what one worker can do: who is refused, how soon and in what words,
// and what becomes of those who are not. The daemon has one processor, the clients another.
namespace remeshd::test {
namespace {

struct Settings {
  std::uint32_t nodes = 15000;
  double seconds = 60;
  double times = 10;
  int queue = 16;
  bool goals = false;
};

int run(const Settings& settings) {
  const OnProcessor generator(1);
  const StoreFolder store("flood");
  ServedDaemon daemon({"--workers", "1", "--threads", "1", "--queue",
                       std::to_string(settings.queue), "--store", store.path()},
                      0);
  const std::string base = made_by(daemon.stub(), create_tool1(settings.nodes));
  EditLoad load(daemon.stub(), base);

  const double quiet = settings.seconds / 2;
  load.closed_loop(2, std::min(2.0, quiet));  // to warm up
  const double started = daemon.processor_seconds();
  const EditLoad::Counts before = load.closed_loop(2, quiet);
  const double flooded = daemon.processor_seconds();
  const EditLoad::Counts flood =
      load.open_loop(settings.times * before.done_per_second, settings.seconds);
  const double over = daemon.processor_seconds();
  const EditLoad::Counts after = load.closed_loop(2, quiet);
  const double ended = daemon.processor_seconds();
  const double quiet_cost =
      (flooded - started + ended - over) / static_cast<double>(before.done + after.done);
  const double flood_cost = (over - flooded) / static_cast<double>(flood.done);
  const double unflooded = (before.done_per_second + after.done_per_second) / 2;

  std::vector<double> in_server;
  for (const LoggedCall& call : logged_calls(daemon.process().log()))
    if (call.status == "RESOURCE_EXHAUSTED") in_server.push_back(call.milliseconds);

  Goals goals(settings.goals);
  goals.tell("edits at capacity before", before.done_per_second, "/s");
  goals.tell("edits at capacity after", after.done_per_second, "/s");
  goals.tell("edits asked for in the flood", static_cast<double>(flood.sent) / settings.seconds,
             "/s");
  goals.tell("  done", static_cast<double>(flood.done), "");
  goals.tell("  refused", static_cast<double>(flood.refused), "");
  goals.at_least("useful throughput, of unflooded", flood.done_per_second / unflooded, "", 0.95);
  goals.at_least("the same by processor time", quiet_cost / flood_cost, "", 0.95);
  goals.tell("a refusal in the server, median", median(in_server), "ms");
  goals.at_most("a refusal in the server, p99", percentile(in_server, 0.99), "ms", 5);
  goals.tell("a refusal at the client, median", median(flood.refusal_ms), "ms");
  goals.at_most("a refusal at the client, p99", percentile(flood.refusal_ms, 0.99), "ms", 25);
  goals.must("there were refusals", flood.refused > 0);
  goals.must_be_at_most("refusals without a delay", static_cast<double>(flood.without_delay), "",
                        0);
  goals.must_be_at_most("accepted and not answered well", static_cast<double>(flood.lost), "", 0);
  for (const auto& [how, count] : flood.other_ends) std::printf("  %d: %s\n", count, how.c_str());
  return goals.exit_status();
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("What a flood of edits does to a daemon with one worker",
                                     settings.goals);
  CLI::App& options = program.options();
  options.add_option("--nodes", settings.nodes);
  options.add_option("--seconds", settings.seconds);
  options.add_option("--times", settings.times, "of the daemon's capacity");
  options.add_option("--queue", settings.queue, "as remeshd's own option");
  return program.run(argc, argv, [&] { return remeshd::test::run(settings); });
}

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <map>
#include <random>
#include <thread>
#include <vector>

#include "tests/service/client_process.h"
#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/log_lines.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"

// How soon a processor is free again once nobody wants what is computed: by a cancelled stream, in
// every stage of a first mesh and of an edit; by a client that is killed; by one that is frozen.
namespace remeshd::test {
namespace {

struct Settings {
  std::uint32_t nodes = 100000;
  int cancels = 200;
  int kills = 20;
  bool frozen = false;
  bool goals = false;
  std::string client_of;  ///< be the client of that address that is killed or frozen
};

struct Stage {
  std::string name;
  double seconds = 0;
};

class Cancels {
 public:
  explicit Cancels(const Settings& settings)
      : settings_(settings),
        daemon_({"--workers", "1", "--compute-limit", "0"}),
        goals_(settings.goals) {}

  int run() {
    base_ = made_by(daemon_.stub(), create_tool1(settings_.nodes));
    for (const bool edit : {false, true}) {
      const std::vector<Stage> stages = watch(request(edit));
      for (int i = 0; i < settings_.cancels / 2; ++i)
        cancel(edit, stages[static_cast<std::size_t>(i) % stages.size()]);
    }
    for (const auto& [stage, times] : by_stage_)
      goals_.tell(stage + ", at most of " + std::to_string(times.size()),
                  1000 * percentile(times, 1), "ms");
    goals_.tell("cancelled after their end", finished_);
    goals_.at_most("free after a cancellation, p99", 1000 * percentile(all_, 0.99), "ms", 100);
    goals_.tell("  processor time used until then, p99", 1000 * percentile(used_, 0.99), "ms");
    goals_.must("free after every cancellation", !stuck_);

    std::vector<double> killed;
    for (int i = 0; i < settings_.kills; ++i) killed.push_back(free_after(SIGKILL, 30));
    if (settings_.kills > 0) {
      goals_.at_most("free after a client's death, at most", 1000 * percentile(killed, 1), "ms",
                     250);
      goals_.must("free after every client's death", !stuck_);
    }
    if (settings_.frozen) {
      // Ten times the nodes: it must not come to its end before the client is given up.
      const std::size_t before = ended_streams();
      goals_.at_most("free after a client froze", free_after(SIGSTOP, 150, 10), "s", 90);
      goals_.must("free at all after a client froze", !stuck_);
      std::this_thread::sleep_for(std::chrono::seconds(1));
      goals_.must("  for its stream was ended", ended_streams() > before);
    }
    return goals_.exit_status();
  }

  /// What the client process does: asks for a mesh that takes minutes, and waits.
  static int be_client(const Settings& settings) {
    const auto stub = v1::RemeshService::NewStub(
        grpc::CreateChannel(settings.client_of, grpc::InsecureChannelCredentials()));
    grpc::ClientContext context;
    const auto stream = stub->EditStream(&context);
    v1::EditStreamRequest request;
    *request.mutable_create() = create_tool1(settings.nodes);
    request.mutable_create()->mutable_options()->set_iterations(1000);
    request.mutable_create()->mutable_options()->set_seed(1000000 +
                                                          static_cast<std::uint64_t>(::getpid()));
    stream->Write(request);
    v1::EditStreamResponse reply;
    while (stream->Read(&reply)) {
    }
    return 0;
  }

 private:
  v1::EditStreamRequest request(bool edit) {
    v1::EditStreamRequest request;
    ++number_;
    if (edit) {
      *request.mutable_edit() = set_parameter(base_, "pin_radius", pin_radius(number_));
    } else {
      *request.mutable_create() = create_tool1(settings_.nodes);
      request.mutable_create()->mutable_options()->set_seed(static_cast<std::uint64_t>(number_));
    }
    return request;
  }

  /// The stages that are told of, and how long each lasts.
  std::vector<Stage> watch(const v1::EditStreamRequest& request) {
    grpc::ClientContext context;
    const auto stream = daemon_.stub().EditStream(&context);
    stream->Write(request);
    stream->WritesDone();
    std::vector<Stage> stages;
    auto since = Clock::now();
    v1::EditStreamResponse reply;
    while (stream->Read(&reply) && reply.has_progress()) {
      const std::string& name = reply.progress().stage();
      if (!stages.empty()) stages.back().seconds += seconds_since(since);
      since = Clock::now();
      if (name == "queued" || (!stages.empty() && stages.back().name == name)) continue;
      stages.push_back({.name = name});
    }
    if (!stages.empty()) stages.back().seconds += seconds_since(since);
    if (!reply.has_result() || stages.empty())
      throw std::runtime_error("no mesh: " + reply.ShortDebugString());
    stream->Finish();
    return stages;
  }

  void cancel(bool edit, const Stage& stage) {
    grpc::ClientContext context;
    const auto stream = daemon_.stub().EditStream(&context);
    stream->Write(request(edit));
    v1::EditStreamResponse reply;
    while (stream->Read(&reply) && reply.has_progress() && reply.progress().stage() != stage.name) {
    }
    std::this_thread::sleep_for(
        duration_of(std::uniform_real_distribution<double>(0, stage.seconds)(random_)));
    if (!reply.has_progress() || daemon_.info().load().running() == 0) {
      ++finished_;
      context.TryCancel();
      stream->Finish();
      return;
    }
    const double used = daemon_.processor_seconds();
    const auto start = Clock::now();
    context.TryCancel();
    stuck_ |= !daemon_.wait_until_idle(30);
    const double spent = seconds_since(start);
    used_.push_back(daemon_.processor_seconds() - used);
    all_.push_back(spent);
    by_stage_[(edit ? "edit, " : "first mesh, ") + stage.name].push_back(spent);
    stream->Finish();
  }

  std::size_t ended_streams() {
    const auto calls = logged_calls(daemon_.process().log());
    return static_cast<std::size_t>(std::ranges::count(calls, "EditStream", &LoggedCall::method));
  }

  double free_after(int signal, double most, std::uint32_t times = 1) {
    const ClientProcess client(
        {"--client-of", daemon_.address(), "--nodes", std::to_string(times * settings_.nodes)});
    while (daemon_.info().load().running() == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(duration_of(std::uniform_real_distribution<double>(0, 2)(random_)));
    const auto start = Clock::now();
    client.signal(signal);
    stuck_ |= !daemon_.wait_until_idle(most);
    return seconds_since(start);
  }

  const Settings settings_;
  ServedDaemon daemon_;
  Goals goals_;
  std::string base_;
  int number_ = 1, finished_ = 0;
  bool stuck_ = false;
  std::mt19937 random_{1};
  std::vector<double> all_, used_;
  std::map<std::string, std::vector<double>> by_stage_;
};

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("How soon a processor is free of what nobody wants any more",
                                     settings.goals);
  CLI::App& options = program.options();
  options.add_option("--nodes", settings.nodes);
  options.add_option("--cancels", settings.cancels, "half of first meshes, half of edits");
  options.add_option("--kills", settings.kills, "of clients");
  options.add_flag("--frozen", settings.frozen,
                   "a client that stops, too: takes up to two minutes");
  options.add_option("--client-of", settings.client_of)->group("");
  return program.run(argc, argv, [&] {
    if (!settings.client_of.empty()) return remeshd::test::Cancels::be_client(settings);
    return remeshd::test::Cancels(settings).run();
  });
}

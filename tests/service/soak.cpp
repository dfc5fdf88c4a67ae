#include <deque>
#include <filesystem>
#include <stdexcept>

#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"

// Edits for a long time, with a small cache and a store from which old revisions are deleted: what
// grows that should not.
namespace remeshd::test {
namespace {

struct Settings {
  double minutes = 120;
  double full_after = 10;  // min
  std::uint32_t nodes = 15000;
  int cache = 64;      // MiB
  int revisions = 50;  // that stay
  bool goals = false;
};

constexpr double kMebi = 1U << 20U;

std::size_t descriptors(const ServedDaemon& daemon) {
  const std::filesystem::directory_iterator all("/proc/" + std::to_string(daemon.process_id()) +
                                                "/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

void remove(v1::RemeshService::Stub& stub, const std::string& id) {
  grpc::ClientContext context;
  v1::DeleteRevisionRequest request;
  v1::DeleteRevisionResponse reply;
  request.set_revision(id);
  request.set_allow_head(true);
  const grpc::Status status = stub.DeleteRevision(&context, request, &reply);
  if (!status.ok()) throw std::runtime_error("DeleteRevision: " + status.error_message());
}

int run(const Settings& settings) {
  const StoreFolder store("soak");
  ServedDaemon daemon({"--store", store.path(), "--cache", std::to_string(settings.cache)});
  std::deque<std::string> ids{made_by(daemon.stub(), create_tool1(settings.nodes))};
  const auto start = Clock::now();
  std::size_t edits = 0, memory_then = 0, files_then = 0, files_most = 0, failed = 0;
  while (seconds_since(start) < 60 * settings.minutes) {
    grpc::ClientContext context;
    v1::EditRevisionResponse reply;
    const auto request =
        set_parameter(ids.back(), "pin_radius", pin_radius(static_cast<int>(++edits)));
    if (daemon.stub().EditRevision(&context, request, &reply).ok())
      ids.push_back(reply.result().revision().id());
    else
      ++failed;
    if (ids.size() > static_cast<std::size_t>(settings.revisions)) {
      remove(daemon.stub(), ids.front());
      ids.pop_front();
    }
    if (seconds_since(start) < 60 * settings.full_after) continue;
    files_most = std::max(files_most, descriptors(daemon));
    if (memory_then != 0) continue;
    memory_then = daemon.memory();
    files_then = descriptors(daemon);
    daemon.forget_peak();
  }
  Goals goals(settings.goals);
  goals.tell("edits", static_cast<double>(edits));
  goals.must_be_at_most("edits that failed", static_cast<double>(failed), "", 0);
  goals.tell("memory once the cache was full", static_cast<double>(memory_then) / kMebi, "MiB");
  goals.tell("memory now", static_cast<double>(daemon.memory()) / kMebi, "MiB");
  // Between two edits, when nothing is computed, as at first.
  goals.must_be_at_most(
      "memory that it grew by since",
      (static_cast<double>(daemon.memory()) - static_cast<double>(memory_then)) / kMebi, "MiB", 32);
  goals.tell("descriptors once the cache was full", static_cast<double>(files_then));
  goals.must_be_at_most("descriptors since, at most", static_cast<double>(files_most), "",
                        static_cast<double>(files_then));
  return goals.exit_status();
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("What grows in a daemon that edits for hours", settings.goals);
  CLI::App& options = program.options();
  options.add_option("--minutes", settings.minutes);
  options.add_option("--full-after", settings.full_after, "minutes until the cache is full");
  options.add_option("--nodes", settings.nodes);
  options.add_option("--cache", settings.cache, "MiB");
  options.add_option("--revisions", settings.revisions, "that stay in the store");
  return program.run(argc, argv, [&] { return remeshd::test::run(settings); });
}

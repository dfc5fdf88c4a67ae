#include <atomic>
#include <filesystem>
#include <fstream>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/service/edit_load.h"
#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/tenant_stub.h"
#include "tests/service/timing.h"

// What a tenant that asks now and then hears of another one that floods the daemon with edits and
// has it compare huge models, with two workers.
namespace remeshd::test {
namespace {

struct Settings {
  std::uint32_t nodes = 15000;
  double seconds = 30;
  double times = 10;
  double pace = 0.25;  // s
  int comparisons = 4;
  int holes = 12;  // in a row and a column of a plate
  bool goals = false;
};

/// A plate with many holes.
std::string plate(int holes, double radius) {
  std::string features =
      R"({"id": "plate", "nature": "ADDITIVE", "type": "block", "parameters": {)";
  const std::string side = std::to_string(10 * holes);
  features += R"("dx": )" + side + R"(, "dy": )" + side +
              R"(, "dz": 5}, "placement": {"origin": [0, 0, 0]}})";
  for (int i = 0; i < holes * holes; ++i)
    features += R"(, {"id": "h)" + std::to_string(i) +
                R"(", "nature": "SUBTRACTIVE", "type": "cylinder", "parameters": {"radius": )" +
                std::to_string(radius) + R"(, "height": 5}, "placement": {"origin": [)" +
                std::to_string(5 + 10 * (i % holes)) + ", " + std::to_string(5 + 10 * (i / holes)) +
                ", 0]}}";
  return R"({"name": "plate", "parameters": {}, "features": [)" + features + "]}";
}

/// ms of edits that are asked for at a pace, each once the last is answered.
std::vector<double> paced_edits(v1::RemeshService::Stub& stub, const std::string& base,
                                const Settings& settings, int& number) {
  std::vector<double> spent;
  const auto start = Clock::now();
  for (auto when = start; seconds_since(start) < settings.seconds;
       when += duration_of(settings.pace)) {
    std::this_thread::sleep_until(when);
    grpc::ClientContext context;
    v1::EditRevisionResponse reply;
    const auto sent = Clock::now();
    const grpc::Status status = stub.EditRevision(
        &context, set_parameter(base, "pin_radius", pin_radius(++number)), &reply);
    if (!status.ok()) throw std::runtime_error("a paced edit failed: " + status.error_message());
    spent.push_back(1000 * seconds_since(sent));
  }
  return spent;
}

/// Comparisons one after the other until `stop`; how many came to their end.
int compare_until(v1::RemeshService::Stub& stub, const Settings& settings, double radius,
                  const std::atomic<bool>& stop) {
  int done = 0;
  while (!stop) {
    grpc::ClientContext context;
    v1::CompareRequest request;
    v1::CompareResponse reply;
    request.mutable_original()->set_document(plate(settings.holes, 3));
    request.mutable_modified()->set_document(plate(settings.holes, radius));
    context.set_deadline(std::chrono::system_clock::now() + std::chrono::minutes(2));
    const grpc::Status status = stub.Compare(&context, request, &reply);
    if (status.ok()) ++done;
    if (!status.ok() && status.error_code() != grpc::StatusCode::RESOURCE_EXHAUSTED)
      throw std::runtime_error("Compare: " + status.error_message());
    if (!status.ok()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return done;
}

/// Comparisons and edits without end, each on a thread of its own.
class Flood {
 public:
  Flood(v1::RemeshService::Stub& stub, EditLoad& load, const Settings& settings, double per_second)
      : edits_(std::async(std::launch::async, [&load, &settings, per_second] {
          return load.open_loop(per_second, settings.seconds + 1);
        })) {
    for (int i = 0; i < settings.comparisons; ++i)
      comparisons_.push_back(std::async(std::launch::async, [this, &stub, &settings, i] {
        return compare_until(stub, settings, 3.1 + 0.1 * i, stop_);
      }));
  }
  /// Where the other tenant fails, its end must not wait for comparisons without end.
  ~Flood() { stop_ = true; }
  Flood(const Flood&) = delete;
  Flood& operator=(const Flood&) = delete;

  /// Throws what one of the threads threw.
  EditLoad::Counts end() {
    stop_ = true;
    for (auto& each : comparisons_) compared_ += each.get();
    return edits_.get();
  }
  /// Comparisons that came to their end.
  [[nodiscard]] int compared() const { return compared_; }

 private:
  std::atomic<bool> stop_ = false;
  int compared_ = 0;
  std::future<EditLoad::Counts> edits_;
  std::vector<std::future<int>> comparisons_;
};

int run(const Settings& settings) {
  const StoreFolder store("tenants");
  const std::filesystem::path tokens = store.path() + ".tokens";
  std::ofstream(tokens) << "flooding a-token-of-the-first\npaced a-token-of-the-second\n";
  std::filesystem::permissions(tokens, std::filesystem::perms(0600));
  ServedDaemon daemon({"--workers", "2", "--threads", "1", "--queue", "16", "--store", store.path(),
                       "--token-file", tokens});
  std::filesystem::remove(tokens);
  const auto flooding = stub_with("a-token-of-the-first", daemon);
  const auto paced = stub_with("a-token-of-the-second", daemon);
  EditLoad load(*flooding, made_by(*flooding, create_tool1(settings.nodes)));
  const std::string base = made_by(*paced, create_tool1(settings.nodes));
  const double capacity = load.closed_loop(2, std::min(2.0, settings.seconds)).done_per_second;

  int number = 0;
  std::vector<double> alone = paced_edits(*paced, base, settings, number);
  Flood flood(*flooding, load, settings, settings.times * capacity);
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const std::vector<double> beside = paced_edits(*paced, base, settings, number);
  const EditLoad::Counts edits = flood.end();
  for (const double spent : paced_edits(*paced, base, settings, number)) alone.push_back(spent);

  Goals goals(settings.goals);
  goals.tell("edits of the flood done", static_cast<double>(edits.done));
  goals.tell("  refused", static_cast<double>(edits.refused));
  goals.tell("huge comparisons done", flood.compared());
  goals.must("the flood was refused at times", edits.refused > 0);
  goals.tell("paced edits alone, median", median(alone), "ms");
  goals.tell("  p95", percentile(alone, 0.95), "ms");
  goals.tell("paced edits beside the flood, median", median(beside), "ms");
  goals.tell("  p95", percentile(beside, 0.95), "ms");
  goals.at_most("p95 beside the flood over alone",
                percentile(beside, 0.95) / percentile(alone, 0.95), "", 1.5);
  return goals.exit_status();
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("What a tenant hears of another one that floods the daemon",
                                     settings.goals);
  CLI::App& options = program.options();
  options.add_option("--nodes", settings.nodes);
  options.add_option("--seconds", settings.seconds, "of each of the three rounds");
  options.add_option("--times", settings.times,
                     "of the daemon's capacity, that the flood asks for");
  options.add_option("--pace", settings.pace, "s between the other tenant's edits");
  options.add_option("--comparisons", settings.comparisons, "at a time");
  options.add_option("--holes", settings.holes, "in a row of the plates that are compared");
  return program.run(argc, argv, [&] { return remeshd::test::run(settings); });
}

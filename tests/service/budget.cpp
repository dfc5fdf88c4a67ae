#include <atomic>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"

// A daemon with a budget of memory and a store with many times that in revisions, which several
// clients make, edit, read and look at in any order: the most memory that it ever had.
namespace remeshd::test {
namespace {

struct Settings {
  int memory = 1024;  // MiB
  double times = 10;
  std::uint32_t nodes = 15000;
  int clients = 4;
  bool goals = false;
};

constexpr double kMebi = 1U << 20U;
constexpr double kBytesPerNode = 700;  // of a revision in memory that shares nothing

class Clients {
 public:
  Clients(ServedDaemon& daemon, const Settings& settings) : daemon_(daemon), settings_(settings) {}

  void run() {
    std::vector<std::jthread> threads;
    for (int i = 0; i < settings_.clients; ++i) threads.emplace_back([this, i] { client(i); });
  }

  [[nodiscard]] double made_bytes() const {
    return kBytesPerNode * settings_.nodes * static_cast<double>(made_);
  }
  [[nodiscard]] int reads() const { return reads_; }
  [[nodiscard]] int refused() const { return refused_; }
  [[nodiscard]] int failed() const { return failed_; }

 private:
  [[nodiscard]] bool enough() const {
    return made_bytes() >= settings_.times * settings_.memory * kMebi || failed_ > 10;
  }

  void client(int number) {
    std::mt19937 random(static_cast<unsigned>(number));
    const auto stub = v1::RemeshService::NewStub(daemon_.connect());
    while (!enough()) {
      make(*stub);
      if (const std::string id = any(random); !id.empty()) edit(*stub, id, random);
      for (int i = 0; i < 2; ++i)
        if (const std::string id = any(random); !id.empty()) read(*stub, id);
    }
  }

  std::string any(std::mt19937& random) {
    const std::scoped_lock lock(mutex_);
    return ids_.empty() ? "" : ids_[random() % ids_.size()];
  }

  void count(const grpc::Status& status, const std::string& id) {
    if (status.ok()) {
      const std::scoped_lock lock(mutex_);
      ids_.push_back(id);
      ++made_;
    } else if (status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED) {
      ++refused_;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    } else {
      ++failed_;
      std::printf("failed: %s\n", status.error_message().c_str());
    }
  }

  void make(v1::RemeshService::Stub& stub) {
    v1::CreateRevisionRequest request = create_tool1(settings_.nodes);
    request.mutable_options()->set_seed(static_cast<std::uint64_t>(++seed_));
    grpc::ClientContext context;
    v1::CreateRevisionResponse reply;
    const grpc::Status status = stub.CreateRevision(&context, request, &reply);
    count(status, reply.result().revision().id());
  }

  void edit(v1::RemeshService::Stub& stub, const std::string& id, std::mt19937& random) {
    grpc::ClientContext context;
    v1::EditRevisionResponse reply;
    const grpc::Status status = stub.EditRevision(
        &context, set_parameter(id, "pin_radius", 3.5 + 1e-9 * (random() % 1000000000)), &reply);
    count(status, reply.result().revision().id());
  }

  void read(v1::RemeshService::Stub& stub, const std::string& id) {
    grpc::ClientContext context;
    v1::GetMeshRequest request;
    request.set_revision(id);
    const auto reader = stub.GetMesh(&context, request);
    v1::GetMeshResponse reply;
    while (reader->Read(&reply)) {
    }
    const grpc::Status status = reader->Finish();
    if (status.ok()) {
      ++reads_;
    } else if (status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED) {
      ++refused_;
    } else {
      ++failed_;
    }
  }

  ServedDaemon& daemon_;
  const Settings settings_;
  std::mutex mutex_;
  std::vector<std::string> ids_;
  std::atomic<std::size_t> made_ = 0;
  std::atomic<int> seed_ = 0, reads_ = 0, refused_ = 0, failed_ = 0;
};

int run(const Settings& settings) {
  const StoreFolder store("budget");
  ServedDaemon daemon({"--store", store.path(), "--memory", std::to_string(settings.memory),
                       "--cache", std::to_string(settings.memory), "--threads", "1"});
  Goals goals(settings.goals);
  goals.tell("memory at the start", static_cast<double>(daemon.memory()) / kMebi, "MiB");
  Clients clients(daemon, settings);
  clients.run();
  const v1::ServerLoad load = daemon.info().load();
  goals.tell("budget", settings.memory, "MiB");
  goals.tell("revisions", load.revisions());
  goals.tell("  in memory they would take about", clients.made_bytes() / kMebi, "MiB");
  goals.tell("  on disk they take", static_cast<double>(load.disk_bytes()) / kMebi, "MiB");
  goals.tell("  in memory now, by the daemon's count",
             static_cast<double>(load.memory_bytes()) / kMebi, "MiB");
  goals.tell("memory now", static_cast<double>(daemon.memory()) / kMebi, "MiB");
  goals.tell("meshes read", clients.reads());
  goals.tell("refused for want of memory", clients.refused());
  goals.must_be_at_most("calls that failed", clients.failed(), "", 0);
  goals.must_be_at_most("most memory", static_cast<double>(daemon.peak_memory()) / kMebi, "MiB",
                        settings.memory);
  return goals.exit_status();
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("The most memory of a daemon that has a budget",
                                     settings.goals);
  CLI::App& options = program.options();
  options.add_option("--memory", settings.memory, "the budget, MiB");
  options.add_option("--times", settings.times, "of the budget in revisions");
  options.add_option("--nodes", settings.nodes);
  options.add_option("--clients", settings.clients);
  return program.run(argc, argv, [&] { return remeshd::test::run(settings); });
}

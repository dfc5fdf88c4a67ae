#include <cstdio>
#include <functional>
#include <limits>
#include <string>

#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/raw_call.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"

// Requests that ask for more than anybody has: each is refused, soon and before it costs memory.
namespace remeshd::test {
namespace {

struct Settings {
  int megabytes = 100;  // of a document
  bool goals = false;
};

constexpr double kMebi = 1U << 20U;

class Hostile {
 public:
  explicit Hostile(const Settings& settings)
      : settings_(settings),
        goals_(settings.goals),
        daemon_({"--threads", "1"}),
        stub_(v1::RemeshService::NewStub(daemon_.connect(true))) {}

  int run() {
    const std::string block = made_by(*stub_, create_block(1000));
    refused("an edit that makes a block 1e9 long", set_parameter(block, "size", 1e9));
    v1::CreateRevisionRequest request = create_block(std::numeric_limits<std::uint32_t>::max());
    refused("4,294,967,295 nodes", request);
    request = create_block(5000001);
    refused("5,000,001 nodes", request);
    request.mutable_options()->set_size(1e-6);
    refused("a size of 1e-6", request);
    request.mutable_options()->set_size(1e-300);
    refused("a size of 1e-300", request);
    v1::EditRevisionRequest edit = set_parameter(block, "size", 11);
    edit.mutable_options()->set_nodes(std::numeric_limits<std::uint32_t>::max());
    refused("an edit to 4,294,967,295 nodes", edit);

    const std::size_t bytes = static_cast<std::size_t>(settings_.megabytes) * 1000000;
    request = {};
    request.set_document(std::string(std::size_t{15} << 20U, ' '));
    refused("a document of 15 MiB", request);
    request.set_document(std::string(bytes, ' '));
    // gRPC 1.51 receives a message whole before it looks at its size.
    refused("a document of " + std::to_string(settings_.megabytes) + " MB", request, false);
    edit = set_parameter(block, "size", 11);
    edit.set_document(std::string(bytes, '['));
    refused("an edit of " + std::to_string(settings_.megabytes) + " MB", edit, false);
    const std::string bomb = gzip_bomb(50000000);
    measured(
        "a bomb of 50 MB in " + std::to_string(bomb.size() / 1000) + " KB",
        [&] {
          return raw_call(daemon_.address(), "/remesh.v1.RemeshService/CreateRevision", bomb);
        },
        true);
    goals_.must("it serves on", daemon_.info().ready());
    return goals_.exit_status();
  }

 private:
  grpc::Status call(grpc::ClientContext& context, const v1::CreateRevisionRequest& request) {
    v1::CreateRevisionResponse reply;
    return stub_->CreateRevision(&context, request, &reply);
  }
  grpc::Status call(grpc::ClientContext& context, const v1::EditRevisionRequest& request) {
    v1::EditRevisionResponse reply;
    return stub_->EditRevision(&context, request, &reply);
  }

  template <typename Request>
  void refused(const std::string& what, const Request& request, bool memory_counts = true) {
    grpc::Status status;
    measured(
        what,
        [&] {
          grpc::ClientContext context;
          const auto start = Clock::now();
          status = call(context, request);
          return seconds_since(start);
        },
        memory_counts);
    goals_.must("  refused", !status.ok());
    std::printf("  %s %s\n", reason_of(status).c_str(), status.error_message().c_str());
  }

  void measured(const std::string& what, const std::function<double()>& attack,
                bool memory_counts) {
    daemon_.info();
    daemon_.forget_peak();
    const auto before = static_cast<double>(daemon_.memory());
    goals_.at_most(what, 1000 * attack(), "ms", 100);
    const double grown = (static_cast<double>(daemon_.peak_memory()) - before) / kMebi;
    if (memory_counts)
      goals_.must_be_at_most("  memory", grown, "MiB", 64);
    else
      goals_.at_most("  memory", grown, "MiB", 64);
  }

  const Settings settings_;
  Goals goals_;
  ServedDaemon daemon_;
  const std::unique_ptr<v1::RemeshService::Stub> stub_;
};

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("What requests cost that ask for more than there is",
                                     settings.goals);
  CLI::App& options = program.options();
  options.add_option("--megabytes", settings.megabytes, "of a document");
  return program.run(argc, argv, [&] { return remeshd::test::Hostile(settings).run(); });
}

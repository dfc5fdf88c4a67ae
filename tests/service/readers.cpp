#include <unistd.h>

#include <algorithm>
#include <list>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "server/transport/descriptor_limit.h"
#include "tests/service/client_process.h"
#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"
#include "tests/support/processors.h"

// What clients cost that do not read: readers of one mesh that stall, a writer that never looks at
// an answer, streams that say nothing. Memory of the daemon, and how long other calls take beside.
// They are processes of their own, since what they cost themselves would count as the daemon's.
namespace remeshd::test {
namespace {

struct Settings {
  std::uint32_t nodes = 100000;
  int readers = 64;
  double writer_seconds = 60;
  int connections = 100;
  int streams = 10000;
  int rounds = 7;
  bool goals = false;
  /// Of a client: what it is, of which daemon, and what it reads.
  std::string client, daemon, revision;
};

constexpr double kMebi = 1U << 20U;
constexpr int kChunks = 4;  // of 1 MiB, that a reader may hold

using Stub = v1::RemeshService::Stub;

/// ms of a call that waits for nobody.
double quick_call(ServedDaemon& daemon) {
  constexpr int kCalls = 2000;
  std::vector<double> times;
  for (int i = 0; i < kCalls; ++i) {
    const auto start = Clock::now();
    daemon.info();
    times.push_back(1000 * seconds_since(start));
  }
  return median(times);
}

double mesh_bytes(Stub& stub, const std::string& revision) {
  grpc::ClientContext context;
  v1::GetMeshRequest request;
  request.set_revision(revision);
  const auto reader = stub.GetMesh(&context, request);
  v1::GetMeshResponse reply;
  double bytes = 0;
  while (reader->Read(&reply)) bytes += static_cast<double>(reply.mesh().part().data().size());
  reader->Finish();
  return bytes;
}

/// What the transport takes ahead of a reader does not grow: a small mesh would be gone at once.
std::shared_ptr<grpc::Channel> connect(const std::string& address) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_HTTP2_BDP_PROBE, 0);
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  return grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments);
}

[[noreturn]] void wait_for_the_end() {
  for (;;) ::pause();
}

struct Reader {
  grpc::ClientContext context;
  std::unique_ptr<Stub> stub;
  std::unique_ptr<grpc::ClientReader<v1::GetMeshResponse>> stream;
};

[[noreturn]] void stall(const Settings& settings) {
  std::list<Reader> readers;
  v1::GetMeshRequest request;
  request.set_revision(settings.revision);
  for (int i = 0; i < settings.readers; ++i) {
    Reader& reader = readers.emplace_back();
    reader.stub = v1::RemeshService::NewStub(connect(settings.daemon));
    reader.stream = reader.stub->GetMesh(&reader.context, request);
    v1::GetMeshResponse header;
    reader.stream->Read(&header);  // it is under way
  }
  wait_for_the_end();
}

/// Writes requests that are answered by errors, and reads none of them.
[[noreturn]] void write_only(const Settings& settings) {
  grpc::ClientContext context;
  const auto stub = v1::RemeshService::NewStub(connect(settings.daemon));
  const auto stream = stub->EditStream(&context);
  v1::EditStreamRequest request;
  request.mutable_edit();
  while (stream->Write(request)) {
  }
  wait_for_the_end();
}

struct Stream {
  grpc::ClientContext context;
  std::unique_ptr<grpc::ClientReaderWriter<v1::EditStreamRequest, v1::EditStreamResponse>> stream;
};

[[noreturn]] void say_nothing(const Settings& settings) {
  std::vector<std::unique_ptr<Stub>> stubs;
  for (int i = 0; i < settings.connections; ++i)
    stubs.push_back(v1::RemeshService::NewStub(connect(settings.daemon)));
  std::list<Stream> streams;
  for (int i = 0; i < settings.streams; ++i) {
    Stream& stream = streams.emplace_back();
    stream.stream =
        stubs[static_cast<std::size_t>(i % settings.connections)]->EditStream(&stream.context);
  }
  wait_for_the_end();
}

[[noreturn]] void be_client(const Settings& settings) {
  raise_descriptor_limit();
  if (settings.client == "stalled") stall(settings);
  if (settings.client == "idle") say_nothing(settings);
  write_only(settings);
}

class Readers {
 public:
  explicit Readers(const Settings& settings)
      : settings_(settings), here_(1), daemon_({"--workers", "1"}, 0), goals_(settings.goals) {}

  int run() {
    settings_.daemon = daemon_.address();
    settings_.revision = made_by(daemon_.stub(), create_tool1(settings_.nodes));
    goals_.tell("the mesh", mesh_bytes(daemon_.stub(), settings_.revision) / 1e6, "MB");
    quick_call(daemon_);

    const double readers = memory_beside("stalled readers", "stalled", settings_.readers, 1);
    goals_.must_be_at_most("memory that stalled readers took", readers / kMebi, "MiB",
                           settings_.readers * kChunks + 64);
    const double writer = memory_beside("a deaf writer", "deaf", 1, settings_.writer_seconds);
    goals_.must_be_at_most("memory that a deaf writer took", writer / kMebi, "MiB", 64);
    const double streams = memory_beside("idle streams", "idle", settings_.streams, 1);
    goals_.must_be_at_most("memory of an idle stream", streams / 1024 / settings_.streams, "KiB",
                           64);
    return goals_.exit_status();
  }

 private:
  /// Times calls beside a client and alone, in turn; for the first round the client stays
  /// `seconds` after it has `streams` open. Returns the most bytes by which memory grew beside it.
  double memory_beside(const std::string& name, const std::string& client, int streams,
                       double seconds) {
    std::vector<double> ratios, grown;
    double alone = quick_call(daemon_);
    for (int i = 0; i < settings_.rounds; ++i) {
      const std::size_t memory = daemon_.memory();
      daemon_.forget_peak();
      double beside = 0;
      {
        const ClientProcess process({"--client", client, "--daemon", settings_.daemon, "--revision",
                                     settings_.revision, "--readers",
                                     std::to_string(settings_.readers), "--connections",
                                     std::to_string(settings_.connections), "--streams",
                                     std::to_string(settings_.streams)});
        wait_for_streams(static_cast<std::uint32_t>(streams));
        std::this_thread::sleep_for(duration_of(i == 0 ? seconds : 1));
        beside = quick_call(daemon_);
      }
      grown.push_back(static_cast<double>(daemon_.peak_memory()) - static_cast<double>(memory));
      wait_for_streams(0);
      std::this_thread::sleep_for(std::chrono::seconds(1));
      const double after = quick_call(daemon_);
      ratios.push_back(beside / ((alone + after) / 2));
      alone = after;
    }
    goals_.at_most("other calls beside " + name + ", of alone", median(ratios), "", 1.1);
    return *std::ranges::max_element(grown);
  }

  void wait_for_streams(std::uint32_t count) {
    const auto start = Clock::now();
    while (daemon_.info().load().streams() != count) {
      if (seconds_since(start) > 60) throw std::runtime_error("the client's streams do not come");
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  Settings settings_;
  /// Where threads of one end are moved to and fro, calls of the same daemon differ by a half.
  const OnProcessor here_;
  ServedDaemon daemon_;
  Goals goals_;
};

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("What clients cost that do not read", settings.goals);
  CLI::App& options = program.options();
  options.add_option("--nodes", settings.nodes);
  options.add_option("--readers", settings.readers);
  options.add_option("--writer-seconds", settings.writer_seconds);
  options.add_option("--connections", settings.connections);
  options.add_option("--streams", settings.streams, "over these connections together");
  options.add_option("--rounds", settings.rounds);
  options.add_option("--client", settings.client)->group("");
  options.add_option("--daemon", settings.daemon)->group("");
  options.add_option("--revision", settings.revision)->group("");
  return program.run(argc, argv, [&] {
    if (!settings.client.empty()) remeshd::test::be_client(settings);
    return remeshd::test::Readers(settings).run();
  });
}

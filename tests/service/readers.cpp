#include <atomic>
#include <cstdio>
#include <list>
#include <memory>
#include <thread>
#include <vector>

#include "server/transport/descriptor_limit.h"
#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"

// What clients cost that do not read: readers of one mesh that stall, a writer that never looks at
// an answer, streams that say nothing. Memory of the daemon, and how long other calls take beside.
namespace remeshd::test {
namespace {

struct Settings {
  std::uint32_t nodes = 100000;
  int readers = 64;
  double writer_seconds = 60;
  int connections = 100;
  int streams = 10000;
  bool goals = false;
};

constexpr double kMebi = 1U << 20U;
constexpr int kChunks = 4;  // of 1 MiB, that a reader may hold

using Stub = v1::RemeshService::Stub;

/// ms of a call that waits for nobody.
double quick_call(ServedDaemon& daemon) {
  std::vector<double> times;
  for (int i = 0; i < 300; ++i) {
    const auto start = Clock::now();
    daemon.info();
    times.push_back(1000 * seconds_since(start));
  }
  return median(times);
}

class Beside {
 public:
  Beside(ServedDaemon& daemon, Goals& goals) : daemon_(daemon), goals_(goals) {}

  /// Runs `load`, which keeps up what it does while the function that it is given runs. Returns the
  /// bytes by which memory grew meanwhile.
  template <typename Load>
  double run(const std::string& name, Load load) {
    const double before = quick_call(daemon_);
    const std::size_t memory = daemon_.memory();
    daemon_.forget_peak();
    double meanwhile = 0;
    load([&] { meanwhile = quick_call(daemon_); });
    const double grown = static_cast<double>(daemon_.peak_memory()) - static_cast<double>(memory);
    const double alone = (before + quick_call(daemon_)) / 2;
    goals_.at_most("other calls beside " + name + ", of alone", meanwhile / alone, "", 1.1);
    return grown;
  }

 private:
  ServedDaemon& daemon_;
  Goals& goals_;
};

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

struct Reader {
  grpc::ClientContext context;
  std::unique_ptr<Stub> stub;
  std::unique_ptr<grpc::ClientReader<v1::GetMeshResponse>> stream;
};

void stalled_readers(ServedDaemon& daemon, const std::string& revision, int count,
                     const std::function<void()>& meanwhile) {
  std::list<Reader> readers;
  v1::GetMeshRequest request;
  request.set_revision(revision);
  for (int i = 0; i < count; ++i) {
    Reader& reader = readers.emplace_back();
    reader.stub = v1::RemeshService::NewStub(daemon.connect());
    reader.stream = reader.stub->GetMesh(&reader.context, request);
    v1::GetMeshResponse header;
    reader.stream->Read(&header);  // it is under way
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  meanwhile();
  for (Reader& reader : readers) {
    reader.context.TryCancel();
    reader.stream->Finish();
  }
}

/// Writes requests that are answered by errors, and reads none of them.
std::size_t deaf_writer(ServedDaemon& daemon, double seconds,
                        const std::function<void()>& meanwhile) {
  grpc::ClientContext context;
  const auto stub = v1::RemeshService::NewStub(daemon.connect());
  const auto stream = stub->EditStream(&context);
  std::atomic<std::size_t> written = 0;
  std::jthread writer([&] {
    v1::EditStreamRequest request;
    request.mutable_edit();
    while (stream->Write(request)) ++written;
  });
  const auto start = Clock::now();
  std::this_thread::sleep_for(duration_of(seconds / 2));
  meanwhile();
  std::this_thread::sleep_for(duration_of(std::max(0.0, seconds - seconds_since(start))));
  context.TryCancel();
  writer.join();
  stream->Finish();
  return written;
}

struct Stream {
  grpc::ClientContext context;
  std::unique_ptr<grpc::ClientReaderWriter<v1::EditStreamRequest, v1::EditStreamResponse>> stream;
};

void idle_streams(ServedDaemon& daemon, int connections, int count,
                  const std::function<void()>& meanwhile) {
  std::vector<std::unique_ptr<Stub>> stubs;
  for (int i = 0; i < connections; ++i)
    stubs.push_back(v1::RemeshService::NewStub(daemon.connect()));
  std::list<Stream> streams;
  for (int i = 0; i < count; ++i) {
    Stream& stream = streams.emplace_back();
    stream.stream = stubs[static_cast<std::size_t>(i % connections)]->EditStream(&stream.context);
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  meanwhile();
  for (Stream& stream : streams) stream.context.TryCancel();
  for (Stream& stream : streams) stream.stream->Finish();
}

int run(const Settings& settings) {
  raise_descriptor_limit();
  Goals goals(settings.goals);
  ServedDaemon daemon({"--workers", "1"});
  const std::string revision = made_by(daemon.stub(), create_tool1(settings.nodes));
  goals.tell("the mesh", mesh_bytes(daemon.stub(), revision) / 1e6, "MB");
  quick_call(daemon);
  Beside beside(daemon, goals);

  const double readers = beside.run("stalled readers", [&](const auto& meanwhile) {
    stalled_readers(daemon, revision, settings.readers, meanwhile);
  });
  goals.must_be_at_most("memory that stalled readers took", readers / kMebi, "MiB",
                        settings.readers * kChunks + 64);

  std::size_t written = 0;
  const double writer = beside.run("a deaf writer", [&](const auto& meanwhile) {
    written = deaf_writer(daemon, settings.writer_seconds, meanwhile);
  });
  goals.tell("requests that it could write", static_cast<double>(written));
  goals.must_be_at_most("memory that a deaf writer took", writer / kMebi, "MiB", 64);

  const double streams = beside.run("idle streams", [&](const auto& meanwhile) {
    idle_streams(daemon, settings.connections, settings.streams, meanwhile);
  });
  goals.must_be_at_most("memory of an idle stream", streams / 1024 / settings.streams, "KiB", 64);
  return goals.exit_status();
}

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
  return program.run(argc, argv, [&] { return remeshd::test::run(settings); });
}

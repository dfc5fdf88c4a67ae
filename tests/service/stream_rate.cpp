#include <grpcpp/generic/generic_stub.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/service/byte_server.h"
#include "tests/service/client_process.h"
#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/mutual_tls.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"
#include "tests/support/processors.h"

// How fast a mesh comes, beside a stream of as many bytes that mean nothing. The two servers have
// one processor, the client another; streams of the two take turns.
namespace remeshd::test {
namespace {

struct Settings {
  std::uint32_t nodes = 460000;
  int rounds = 61;  ///< medians of runs of 9 rounds scatter from .55 to 1.9
  bool goals = false;
  bool mtls = false;  ///< both ends show certificates
  std::string keys;   ///< folder of those
  std::string serve;  ///< be the server of bytes, and write the address into that file
  std::size_t messages = 0, bytes = 0;
};

struct Stream {
  std::size_t messages = 0, bytes = 0;
  double seconds = 0;
};

/// Reads a stream without looking at its messages.
Stream read(const std::shared_ptr<grpc::Channel>& channel, const std::string& revision) {
  v1::GetMeshRequest request;
  request.set_revision(revision);
  const grpc::Slice slice(request.SerializeAsString());
  grpc::GenericStub stub(channel);
  grpc::CompletionQueue queue;
  grpc::ClientContext context;
  void* tag = nullptr;
  bool ok = false;
  const auto start = Clock::now();
  const auto call = stub.PrepareCall(&context, "/remesh.v1.RemeshService/GetMesh", &queue);
  call->StartCall(nullptr);
  queue.Next(&tag, &ok);
  call->WriteLast(grpc::ByteBuffer(&slice, 1), grpc::WriteOptions(), nullptr);
  queue.Next(&tag, &ok);
  Stream stream;
  for (;;) {
    grpc::ByteBuffer message;
    call->Read(&message, nullptr);
    if (!queue.Next(&tag, &ok) || !ok) break;
    ++stream.messages;
    stream.bytes += message.Length();
  }
  grpc::Status status;
  call->Finish(&status, nullptr);
  queue.Next(&tag, &ok);
  if (!status.ok()) throw std::runtime_error("GetMesh: " + status.error_message());
  stream.seconds = seconds_since(start);
  return stream;
}

std::string address_in(const std::filesystem::path& file) {
  for (int i = 0; i < 1000; ++i) {
    std::ifstream in(file);
    if (std::string address; std::getline(in, address)) return address;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  throw std::runtime_error("the server of bytes does not start");
}

int serve_bytes(const Settings& settings) {
  ByteServer server(
      settings.messages, settings.bytes,
      settings.keys.empty() ? grpc::InsecureServerCredentials() : mutual_tls_server(settings.keys));
  const std::string unfinished = settings.serve + ".unfinished";
  std::ofstream(unfinished) << server.address() << '\n';
  std::filesystem::rename(unfinished, settings.serve);
  server.wait();
  return 0;
}

int run(const Settings& settings) {
  const StoreFolder folder("stream-rate");
  std::filesystem::create_directory(folder.path());
  const std::string keys = settings.mtls ? folder.path() : "";
  std::vector<std::string> arguments{"--memory", "8192", "--cache", "8192"};
  std::shared_ptr<grpc::ChannelCredentials> credentials = grpc::InsecureChannelCredentials();
  if (settings.mtls) {
    write_keys(keys);
    credentials = mutual_tls_client(keys);
    arguments.insert(arguments.end(), {"--tls-cert", keys + "/server.cert", "--tls-key",
                                       keys + "/server.key", "--tls-client-ca", keys + "/ca.pem"});
  }
  ServedDaemon daemon(arguments, 0, credentials);
  const std::string revision = made_by(daemon.stub(), create_tool1(settings.nodes));
  const OnProcessor client(1);
  const Stream first = read(daemon.connect(true), revision);

  const std::string file = folder.path() + "/address";
  std::optional<ClientProcess> server;
  std::vector<std::string> serve{"--serve",    file,
                                 "--messages", std::to_string(first.messages),
                                 "--bytes",    std::to_string(first.bytes / first.messages)};
  if (settings.mtls) serve.insert(serve.end(), {"--keys", keys});
  {
    const OnProcessor there(0);
    server.emplace(serve);
  }
  const auto bare_channel = grpc::CreateChannel(address_in(file), credentials);
  const auto channel = daemon.connect(true);

  std::vector<double> mesh, bare, ratio;
  for (int i = 0; i < settings.rounds; ++i) {
    const Stream of_bytes = read(bare_channel, revision), of_mesh = read(channel, revision);
    bare.push_back(1e-6 * static_cast<double>(of_bytes.bytes) / of_bytes.seconds);
    mesh.push_back(1e-6 * static_cast<double>(of_mesh.bytes) / of_mesh.seconds);
    ratio.push_back(mesh.back() / bare.back());
  }
  Goals goals(settings.goals);
  goals.tell("the mesh", 1e-6 * static_cast<double>(first.bytes), "MB");
  goals.tell("  in messages", static_cast<double>(first.messages));
  goals.tell("the first time", first.seconds, "s");
  goals.tell("bare stream", median(bare), "MB/s");
  goals.tell("mesh", median(mesh), "MB/s");
  goals.at_least("mesh over bare, median of the rounds", median(ratio), "", 0.6);
  goals.must("all of it came", first.bytes > 0);
  return goals.exit_status();
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("The rate of a mesh over that of a bare stream of bytes",
                                     settings.goals);
  CLI::App& options = program.options();
  options.add_option("--nodes", settings.nodes);
  options.add_option("--rounds", settings.rounds);
  options.add_flag("--mtls", settings.mtls, "both ends show certificates");
  options.add_option("--keys", settings.keys)->group("");
  options.add_option("--serve", settings.serve)->group("");
  options.add_option("--messages", settings.messages)->group("");
  options.add_option("--bytes", settings.bytes)->group("");
  return program.run(argc, argv, [&] {
    if (!settings.serve.empty()) return remeshd::test::serve_bytes(settings);
    return remeshd::test::run(settings);
  });
}

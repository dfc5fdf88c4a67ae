#include "server/daemon.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/grpcpp.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

#include "server/service/remesh_service.h"
#include "server/session/session.h"

#ifndef REMESHD_VERSION
#error "the build gives the version"
#endif

namespace remeshd {
namespace {

/// gRPC reads a message whole before we can refuse it in words; beyond this it refuses it itself.
constexpr int kMostReceived = 256 << 20;
/// Of all messages being received together.
constexpr std::size_t kReceiveMemory = std::size_t{1} << 30;

Error listen_failed(const std::string& address) {
  ErrorInfo info;
  info.kind = ErrorKind::FailedPrecondition;
  info.reason = "ListenFailed";
  info.message = "cannot listen on " + address;
  info.stage = "request";
  info.hint = "is another daemon using the port, or is the address not of the form HOST:PORT?";
  return Error(std::move(info));
}

int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

SessionLimits session_limits(const DaemonOptions& options) {
  return {.workers = options.workers > 0 ? options.workers : processors(),
          .threads = options.threads > 0 ? options.threads : processors(),
          .queue = options.queue,
          .wait = options.queue_wait,
          .memory = options.memory,
          .max_nodes = options.max_nodes,
          .dumps = options.dumps};
}

std::unique_ptr<Store> open_store(const DaemonOptions& options) {
  if (options.store.empty()) return std::make_unique<Store>();
  auto store = std::make_unique<Store>(options.store, options.store_wait);
  if (options.log)
    for (const std::string& note : store->notes()) options.log->warn("store: {}", note);
  return store;
}

void set_transport(grpc::ServerBuilder& builder) {
  constexpr int kSecond = 1000;
  // The keepalive timeout is TCP_USER_TIMEOUT too: shorter, and slow readers that live are cut.
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, 60 * kSecond);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 30 * kSecond);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 5 * kSecond);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MAX_PING_STRIKES, 0);
  // Otherwise a second daemon on the same port would take half of the calls.
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
  builder.SetMaxReceiveMessageSize(kMostReceived);
  grpc::ResourceQuota quota("remeshd");
  quota.Resize(kReceiveMemory);
  builder.SetResourceQuota(quota);
}

}  // namespace

struct Daemon::Parts {
  std::shared_ptr<spdlog::logger> log;
  Session session;
  std::unique_ptr<grpc::Service> service;
  std::unique_ptr<grpc::Server> server;
  int port = 0;
  std::once_flag ended;

  Parts(const DaemonOptions& options, Engine engine)
      : log(options.log),
        session(std::move(engine), open_store(options), session_limits(options)),
        service(make_remesh_service(session, {.version = REMESHD_VERSION, .log = options.log})) {}
};

Daemon::Daemon(const DaemonOptions& options, Engine engine)
    : parts_(std::make_unique<Parts>(options, std::move(engine))) {
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::ServerBuilder builder;
  set_transport(builder);
  if (!options.listen.empty())
    builder.AddListeningPort(options.listen, grpc::InsecureServerCredentials(), &parts_->port);
  builder.RegisterService(parts_->service.get());
  parts_->server = builder.BuildAndStart();
  if (!parts_->server || (!options.listen.empty() && parts_->port == 0))
    throw listen_failed(options.listen);
  if (auto* health = parts_->server->GetHealthCheckService())
    health->SetServingStatus("remesh.v1.Remesh", true);
}

Daemon::~Daemon() { shutdown(); }

std::shared_ptr<grpc::Channel> Daemon::in_process_channel() {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(-1);  // what comes from this very process is not to be feared
  return parts_->server->InProcessChannel(arguments);
}

int Daemon::port() const { return parts_->port; }

void Daemon::shutdown() {
  std::call_once(parts_->ended, [this] {
    if (!parts_->server) return;
    if (auto* health = parts_->server->GetHealthCheckService()) health->Shutdown();
    // First the session: its answers still reach their clients. What then is left are idle streams.
    parts_->session.stop();
    parts_->server->Shutdown(std::chrono::system_clock::now() + std::chrono::milliseconds(500));
    parts_->server->Wait();
  });
}

}  // namespace remeshd

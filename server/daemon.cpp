#include "server/daemon.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/grpcpp.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "server/service/remesh_service.h"
#include "server/session/session.h"
#include "server/transport/accept_loop.h"
#include "server/transport/descriptor_limit.h"
#include "server/transport/listen_address.h"
#include "server/transport/listening_sockets.h"
#include "server/transport/transport_limits.h"

#ifndef REMESHD_VERSION
#error "the build gives the version"
#endif

namespace remeshd {
namespace {

int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

SessionLimits session_limits(const DaemonOptions& options) {
  return {.workers = options.workers > 0 ? options.workers : processors(),
          .threads = options.threads > 0 ? options.threads : processors(),
          .queue = options.queue,
          .wait = options.queue_wait,
          .memory = options.memory,
          .disk = options.disk,
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

/// The connections that there may be, told where they are fewer than asked for; 0 where nothing is
/// listened on.
std::size_t max_connections(const DaemonOptions& options) {
  if (options.listen.empty()) return 0;
  const std::size_t most = connections_within_descriptors(options.max_connections);
  if (options.log && most < options.max_connections)
    options.log->warn("at most {} connections at a time, not {}: the limit of open files is low",
                      most, options.max_connections);
  return most;
}

}  // namespace

struct Daemon::Parts {
  std::shared_ptr<spdlog::logger> log;
  Session session;
  const std::size_t max_connections;
  std::unique_ptr<grpc::Service> service, cache_service;
  std::unique_ptr<grpc::Server> server;
  std::unique_ptr<AcceptLoop> connections;  ///< null where nothing is listened on
  std::once_flag ended;

  Parts(const DaemonOptions& options, Engine engine)
      : log(options.log),
        session(std::move(engine), open_store(options), session_limits(options)),
        max_connections(remeshd::max_connections(options)),
        service(make_remesh_service(session, {.facts = facts(), .log = options.log})),
        cache_service(make_cache_service(session, {.facts = facts(), .log = options.log})) {}

  [[nodiscard]] ServerFacts facts() const {
    return {.version = REMESHD_VERSION,
            .connections = static_cast<std::uint32_t>(max_connections),
            .streams = kMostStreams};
  }
};

Daemon::Daemon(const DaemonOptions& options, Engine engine) {
  std::optional<ListenAddress> address;
  if (!options.listen.empty()) address = parse_listen_address(options.listen);
  parts_ = std::make_unique<Parts>(options, std::move(engine));
  std::optional<ListeningSockets> sockets;
  if (address) sockets.emplace(*address);

  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::ServerBuilder builder;
  set_transport_limits(builder);
  using Experimental = grpc::ServerBuilder::experimental_type;
  std::shared_ptr<grpc::experimental::ExternalConnectionAcceptor> acceptor;
  if (sockets)
    acceptor = builder.experimental().AddExternalConnectionAcceptor(
        Experimental::ExternalConnectionType::FROM_FD, grpc::InsecureServerCredentials());
  builder.RegisterService(parts_->service.get());
  builder.RegisterService(parts_->cache_service.get());
  parts_->server = builder.BuildAndStart();
  if (!parts_->server) throw std::runtime_error("gRPC does not start");
  if (auto* health = parts_->server->GetHealthCheckService())
    health->SetServingStatus("remesh.v1.RemeshService", true);
  if (!sockets) return;
  const auto hand_over = [acceptor](int listener, Descriptor connection) {
    grpc::experimental::ExternalConnectionAcceptor::NewConnectionParameters parameters;
    parameters.listener_fd = listener;
    parameters.fd = connection.release();
    acceptor->HandleNewConnection(&parameters);
  };
  parts_->connections = std::make_unique<AcceptLoop>(std::move(*sockets), parts_->max_connections,
                                                     hand_over, options.log);
}

Daemon::~Daemon() { shutdown(); }

std::shared_ptr<grpc::Channel> Daemon::in_process_channel() {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(-1);  // what comes from this very process is not to be feared
  return parts_->server->InProcessChannel(arguments);
}

int Daemon::port() const { return parts_->connections ? parts_->connections->sockets().port() : 0; }

std::string Daemon::address() const {
  return parts_->connections ? parts_->connections->sockets().name() : "";
}

void Daemon::shutdown() {
  std::call_once(parts_->ended, [this] {
    if (parts_->connections) parts_->connections->stop();
    if (!parts_->server) return;
    if (auto* health = parts_->server->GetHealthCheckService()) health->Shutdown();
    // First the session: its answers still reach their clients. What then is left are idle streams.
    parts_->session.stop();
    parts_->server->Shutdown(std::chrono::system_clock::now() + std::chrono::milliseconds(500));
    parts_->server->Wait();
  });
}

}  // namespace remeshd

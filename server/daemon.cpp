#include "server/daemon.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/grpcpp.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "server/guard/tls_files.h"
#include "server/limits.h"
#include "server/observe/metrics.h"
#include "server/observe/readiness.h"
#include "server/service/front_desk.h"
#include "server/service/remesh_service.h"
#include "server/session/tenants.h"
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
          .compute = options.compute_limit,
          .memory = options.memory,
          .held = std::min(options.cache, options.memory),
          .disk = options.disk,
          .max_nodes = options.max_nodes,
          .dumps = options.dumps};
}

/// Opens stores: that of the tenant `` in the folder itself, those of the others in `tenants/NAME`
/// below it.
Tenants::OpenStore store_opener(const DaemonOptions& options) {
  return [folder = options.store, wait = options.store_wait,
          log = options.log](const std::string& tenant) {
    if (folder.empty()) return std::make_unique<Store>();
    auto store =
        std::make_unique<Store>(tenant.empty() ? folder : folder / "tenants" / tenant, wait);
    const std::string whose = tenant.empty() ? "" : " of the tenant " + tenant;
    if (log)
      for (const std::string& note : store->notes()) log->warn("store{}: {}", whose, note);
    return store;
  };
}

/// What hinders the daemon while stores of tenants cannot be written to; empty for none.
std::string why_not_stored(const std::set<std::string>& tenants) {
  if (tenants.empty()) return "";
  std::string named;
  for (const std::string& tenant : tenants)
    if (!tenant.empty()) named += (named.empty() ? "" : ", ") + tenant;
  return (named.empty() ? "it" : "that of " + named) +
         " cannot be written to; revisions live in memory";
}

/// The most connections at a time; 0 where nothing is listened on. Warns where the limit of
/// descriptors allows fewer than asked for.
std::size_t max_connections(const DaemonOptions& options) {
  if (options.listen.empty()) return 0;
  const std::size_t most = connections_within_descriptors(options.max_connections);
  if (options.log && most < options.max_connections)
    options.log->warn("at most {} connections at a time, not {}: the limit of open files is low",
                      most, options.max_connections);
  return most;
}

using Acceptor = std::shared_ptr<grpc::experimental::ExternalConnectionAcceptor>;
/// By the descriptor of the listening socket.
using Acceptors = std::map<int, Acceptor>;

/// Makes gRPC's acceptors for the connections of the sockets: without encryption for a Unix socket,
/// which its owner alone can reach; for others TLS where it is configured.
Acceptors add_acceptors(grpc::ServerBuilder& builder, const std::vector<ListeningSockets>& sockets,
                        const TlsFiles& tls) {
  using Type = grpc::ServerBuilder::experimental_type::ExternalConnectionType;
  Acceptor clear, encrypted;
  Acceptors out;
  for (const ListeningSockets& each : sockets) {
    const bool encrypts = tls.used() && !each.is_unix();
    Acceptor& acceptor = encrypts ? encrypted : clear;
    if (!acceptor)
      acceptor = builder.experimental().AddExternalConnectionAcceptor(
          Type::FROM_FD, encrypts ? make_tls_credentials(tls) : grpc::InsecureServerCredentials());
    for (const Descriptor& listener : each.descriptors()) out.emplace(listener.get(), acceptor);
  }
  return out;
}

/// gRPC's library of reflection turns it on for every server of the process; this turns it off for
/// one.
struct NoReflection final : grpc::ServerBuilderOption {
  void UpdateArguments(grpc::ChannelArguments* /*arguments*/) override {}
  void UpdatePlugins(std::vector<std::unique_ptr<grpc::ServerBuilderPlugin>>* plugins) override {
    std::erase_if(*plugins, [](const std::unique_ptr<grpc::ServerBuilderPlugin>& plugin) {
      return dynamic_cast<grpc::reflection::ProtoServerReflectionPlugin*>(plugin.get()) != nullptr;
    });
  }
};

}  // namespace

struct Daemon::Parts {
  std::shared_ptr<spdlog::logger> log;
  Readiness readiness;
  const std::shared_ptr<FrontDesk> desk;
  const std::function<std::uint64_t()> helper_crashes;  ///< may be empty
  const bool shares;                                    ///< revisions with other daemons
  Tenants tenants;
  const std::size_t max_connections;
  std::unique_ptr<grpc::Service> service, cache_service;
  std::unique_ptr<grpc::Server> server;
  std::unique_ptr<AcceptLoop> connections;             ///< null where nothing is listened on
  std::atomic<const AcceptLoop*> accepting = nullptr;  ///< `connections`, atomic: calls read it too
  std::once_flag ended;

  Parts(const DaemonOptions& options, Engine engine)
      : log(options.log),
        desk(std::make_shared<FrontDesk>(
            FrontDesk{.log = options.log, .metrics = options.metrics, .doorman = options.doorman})),
        helper_crashes(engine.helper_crashes),
        shares(options.sharing.objects != nullptr),
        tenants(std::move(engine), session_limits(options), store_opener(options), options.metrics,
                options.sharing),
        max_connections(remeshd::max_connections(options)),
        service(make_remesh_service(tenants, {.facts = facts(), .desk = desk})),
        cache_service(make_cache_service(tenants, {.facts = facts(), .desk = desk})) {
    if (desk->doorman)
      desk->doorman->prepare_with([this](const std::string& tenant) { tenants.open(tenant); });
  }
  ~Parts() {
    if (desk->doorman) desk->doorman->prepare_with({});
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  [[nodiscard]] std::size_t open_connections() const {
    const AcceptLoop* const loop = accepting;
    return loop == nullptr ? 0 : loop->count();
  }

  [[nodiscard]] ServerFacts facts() const {
    return {.version = REMESHD_VERSION,
            .connections = static_cast<std::uint32_t>(max_connections),
            .streams = limits::kStreamsPerConnection,
            .readiness = &readiness,
            .open_connections = [this] { return open_connections(); },
            .open_streams = [streams = desk->streams] { return streams->load(); }};
  }

  void tell_metrics() {
    if (!desk->metrics) return;
    desk->metrics->set_source("daemon", [this](MetricsReadings& out) {
      const Load load = tenants.load();
      out.ready = readiness.ready();
      for (const Lane lane : {Lane::Metadata, Lane::Preparation, Lane::Computation})
        out.queue_depth.emplace_back(name_of(lane), tenants.queued(lane));
      out.computations_running = load.running;
      out.memory_bytes = load.memory_bytes;
      out.memory_budget_bytes = tenants.limits().memory;
      if (tenants.persistent()) out.disk_bytes = load.disk_bytes;
      if (tenants.limits().disk > 0) out.disk_budget_bytes = tenants.limits().disk;
      out.revisions = load.revisions;
      if (shares) out.tier_waiting = load.tier_waiting;
      if (connections) out.connections = connections->count();
      out.streams = desk->streams->load();
      if (helper_crashes) out.helper_crashes = static_cast<double>(helper_crashes());
    });
  }

  /// The health service answers for the process under `` and `liveness`, for its readiness under
  /// the service's name.
  void tell_health() {
    grpc::HealthCheckServiceInterface* const health = server->GetHealthCheckService();
    if (health == nullptr) return;
    health->SetServingStatus("liveness", true);
    tenants.on_store_health([this](const std::set<std::string>& unhealthy) {
      readiness.set("store", why_not_stored(unhealthy));
    });
    tenants.on_memory_full([this](bool full) {
      readiness.set("memory", full ? "revisions fill it, and there is no store" : "");
    });
    readiness.on_change(
        [this, health, was_ready = true](bool ready, const std::string& why_not) mutable {
          health->SetServingStatus("remesh.v1.RemeshService", ready);
          if (log && !ready && !desk->gate->closed()) log->warn("not ready: {}", why_not);
          if (log && ready && !was_ready) log->info("ready again");
          was_ready = ready;
        });
  }
};

Daemon::Daemon(const DaemonOptions& options, Engine engine) {
  std::vector<ListenAddress> addresses;
  for (const std::string& text : options.listen) addresses.push_back(parse_listen_address(text));
  parts_ = std::make_unique<Parts>(options, std::move(engine));
  std::vector<ListeningSockets> sockets;
  sockets.reserve(addresses.size());
  for (const ListenAddress& address : addresses) sockets.emplace_back(address);

  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::ServerBuilder builder;
  if (!options.reflection) builder.SetOption(std::make_unique<NoReflection>());
  set_transport_limits(builder);
  Acceptors acceptors = add_acceptors(builder, sockets, options.tls);
  builder.RegisterService(parts_->service.get());
  builder.RegisterService(parts_->cache_service.get());
  parts_->server = builder.BuildAndStart();
  if (!parts_->server) throw std::runtime_error("gRPC does not start");
  parts_->tell_health();
  if (sockets.empty()) return;
  const auto hand_over = [acceptors = std::move(acceptors)](int listener, Descriptor connection) {
    grpc::experimental::ExternalConnectionAcceptor::NewConnectionParameters parameters;
    parameters.listener_fd = listener;
    parameters.fd = connection.release();
    acceptors.at(listener)->HandleNewConnection(&parameters);
  };
  parts_->connections = std::make_unique<AcceptLoop>(std::move(sockets), parts_->max_connections,
                                                     hand_over, options.log);
  parts_->accepting = parts_->connections.get();
  parts_->tell_metrics();
}

Daemon::~Daemon() { shutdown(); }

std::shared_ptr<grpc::Channel> Daemon::in_process_channel() {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(-1);  // what comes from this very process is not to be feared
  return parts_->server->InProcessChannel(arguments);
}

int Daemon::port() const {
  if (!parts_->connections) return 0;
  for (const ListeningSockets& sockets : parts_->connections->sockets())
    if (sockets.port() != 0) return sockets.port();
  return 0;
}

std::vector<std::string> Daemon::addresses() const {
  std::vector<std::string> names;
  if (!parts_->connections) return names;
  for (const ListeningSockets& sockets : parts_->connections->sockets())
    names.push_back(sockets.name());
  return names;
}

std::string Daemon::address() const {
  const std::vector<std::string> all = addresses();
  return all.empty() ? "" : all.front();
}

void Daemon::shutdown(double grace) {
  std::call_once(parts_->ended, [this, grace] {
    if (!parts_->server) return;
    parts_->desk->gate->close();
    parts_->readiness.set("end", "the daemon is shutting down");
    // New connections are still taken, so that probes hear NOT_SERVING and callers UNAVAILABLE.
    parts_->desk->gate->wait_until_empty(std::chrono::duration<double>(grace));
    if (parts_->desk->metrics) parts_->desk->metrics->set_source("daemon", {});
    if (parts_->connections) parts_->connections->stop();
    parts_->tenants.on_store_health({});
    parts_->tenants.on_memory_full({});
    parts_->readiness.on_change({});
    if (auto* health = parts_->server->GetHealthCheckService()) health->Shutdown();
    // First the sessions: their answers still reach their clients. What then is left are idle
    // streams.
    parts_->tenants.stop();
    parts_->server->Shutdown(std::chrono::system_clock::now() + std::chrono::milliseconds(500));
    parts_->server->Wait();
  });
}

}  // namespace remeshd

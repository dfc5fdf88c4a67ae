#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "server/guard/tls_files.h"
#include "server/limits.h"
#include "server/session/engine.h"
#include "server/tier/sharing.h"

namespace grpc {
class Channel;
}  // namespace grpc
namespace spdlog {
class logger;
}

namespace remeshd {

class Doorman;
class Metrics;

struct DaemonOptions {
  /// As `parse_listen_address` takes them; port 0 takes a free one. None: nothing is listened on,
  /// `in_process_channel` only.
  std::vector<std::string> listen = {"127.0.0.1:50051"};
  std::size_t max_connections =
      limits::kConnections;  ///< at a time; fewer where descriptors do not suffice
  /// Folder of the revisions; those of a tenant that tokens name are in `tenants/NAME` in it.
  /// Empty: revisions live in memory and end with the daemon.
  std::filesystem::path store;
  double store_wait = 0;                   ///< s to wait for another process to let go of the store
  int workers = 0;                         ///< computations at a time; 0: one per processor
  int threads = 0;                         ///< at most, for one computation; 0: one per processor
  std::size_t queue = limits::kQueue;      ///< computations that may wait for a worker
  double queue_wait = limits::kQueueWait;  ///< s that one may wait
  double compute_limit = limits::kComputeTime;  ///< s that one may take; 0: any
  std::uint64_t memory =
      limits::kMemory;                  ///< bytes that computations, loads and revisions may take
  std::uint64_t cache = limits::kHeld;  ///< bytes of `memory` that revisions held may take
  std::uint64_t disk = 0;               ///< bytes that stored meshes may take; 0: no limit
  std::uint32_t max_nodes = kDefaultMaxNodes;  ///< most that a request may ask for
  std::filesystem::path dumps;                 ///< for the stages of every computation; empty: none
  std::shared_ptr<spdlog::logger> log;         ///< null: no log
  std::shared_ptr<Metrics> metrics;            ///< null: nothing is counted
  TlsFiles tls;                                ///< for all addresses but Unix sockets
  /// Asks callers for a token, which tells their tenant; the daemon opens the store of each tenant
  /// that it knows. Null: everybody is let in, as one and the same tenant.
  std::shared_ptr<Doorman> doorman;
  Sharing sharing;          ///< with other daemons; needs a store
  bool reflection = false;  ///< whether clients can query the protocol by gRPC reflection
};

/// remeshd as an object: serves the sessions of its tenants, each with a store of its own, on
/// sockets or within this process.
class Daemon {
 public:
  /// Serves from when this returns. Throws Error: `LISTEN_INVALID` before anything else, what Store
  /// throws, `LISTEN_FAILED`; SecretFileError for `tls`.
  Daemon(const DaemonOptions& options, Engine engine);
  /// As `shutdown`.
  ~Daemon();
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  /// A channel to this daemon that uses no port.
  std::shared_ptr<grpc::Channel> in_process_channel();
  /// The TCP port of the first address that has one; 0 if the daemon listens on none.
  [[nodiscard]] int port() const;
  /// Where it listens, as a client takes it: `127.0.0.1:50051`, `unix:/run/remeshd.sock`; in the
  /// order of `DaemonOptions::listen`.
  [[nodiscard]] std::vector<std::string> addresses() const;
  /// The first of them; empty where it does not listen.
  [[nodiscard]] std::string address() const;
  /// Ends the daemon. From now on it is not ready and refuses new requests as UNAVAILABLE, with a
  /// delay; what is under way may go on for `grace` s, and is then answered with UNAVAILABLE. Stops
  /// every computation and returns when all is at rest. A second call does nothing.
  void shutdown(double grace = 0);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The real engine, of `engine/`; quick tests use a fake one.
Engine production_engine();

}  // namespace remeshd

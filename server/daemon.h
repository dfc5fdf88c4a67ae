#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "server/session/engine.h"

namespace grpc {
class Channel;
}
namespace spdlog {
class logger;
}

namespace remeshd {

struct DaemonOptions {
  /// As `parse_listen_address` takes it; port 0 takes a free one. Empty: nothing is listened on,
  /// `in_process_channel` only.
  std::string listen = "127.0.0.1:50051";
  std::size_t max_connections = 1024;   ///< at a time; fewer where descriptors do not suffice
  std::filesystem::path store;          ///< empty: revisions live in memory and end with the daemon
  double store_wait = 0;                ///< s to wait for another process to let go of the store
  int workers = 0;                      ///< computations at a time; 0: one per processor
  int threads = 0;                      ///< at most, for one computation; 0: one per processor
  std::size_t queue = 64;               ///< computations that may wait for a worker
  double queue_wait = 60;               ///< s that one may wait
  std::uint64_t memory = 1ULL << 30;    ///< bytes of revisions held in memory
  std::uint64_t disk = 0;               ///< bytes that stored meshes may take; 0: no limit
  std::uint32_t max_nodes = 5000000;    ///< that may be asked for
  std::filesystem::path dumps;          ///< for the stages of every computation; empty: none
  std::shared_ptr<spdlog::logger> log;  ///< null: no log
};

/// remeshd as an object: the service over a session over a store, on a port or in this process.
class Daemon {
 public:
  /// Serves from when this returns. Throws Error: `LISTEN_INVALID` before anything else, what Store
  /// throws, `LISTEN_FAILED`.
  Daemon(const DaemonOptions& options, Engine engine);
  /// As `shutdown`.
  ~Daemon();
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  /// A channel to this daemon that uses no port.
  std::shared_ptr<grpc::Channel> in_process_channel();
  /// The port it listens on; 0 where it does not.
  [[nodiscard]] int port() const;
  /// Where it listens, as a client takes it: `127.0.0.1:50051`, `unix:/run/remeshd.sock`; or empty.
  [[nodiscard]] std::string address() const;
  /// Answers what is under way with UNAVAILABLE, stops every computation and returns when all is at
  /// rest. A second call does nothing.
  void shutdown();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The engine that meshes.
Engine production_engine();

}  // namespace remeshd

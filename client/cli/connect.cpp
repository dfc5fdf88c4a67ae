#include "client/cli/connect.h"

#include <grpcpp/channel.h>

#include <memory>

#include "client/cli/connect_options.h"
#include "client/cli/store_folder.h"
#include "server/daemon.h"

namespace remeshd::cli {
namespace {

/// s to wait for another `--local` that has the store.
constexpr double kStoreWait = 60;

/// A daemon without a port, and a channel to it, which is destroyed before the daemon.
struct LocalDaemon {
  explicit LocalDaemon(const DaemonOptions& options)
      : daemon(options, production_engine()), channel(daemon.in_process_channel()) {}
  Daemon daemon;
  std::shared_ptr<grpc::Channel> channel;
};

}  // namespace

client::Client connect(const GlobalOptions& options) {
  if (!options.local) return client::Client::connect(options.address, connect_options(options));
  DaemonOptions daemon;
  daemon.listen.clear();
  daemon.store = options.store.empty() ? default_store_folder() : options.store;
  daemon.store_wait = kStoreWait;
  const auto local = std::make_shared<LocalDaemon>(daemon);
  return client::Client(std::shared_ptr<grpc::Channel>(local, local->channel.get()));
}

}  // namespace remeshd::cli

#include "tests/service/served_daemon.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/service/timing.h"
#include "tests/support/processors.h"

namespace remeshd::test {

ServedDaemon::ServedDaemon(std::vector<std::string> arguments, std::optional<int> processor,
                           Credentials credentials)
    : credentials_(std::move(credentials)) {
  arguments.insert(arguments.begin(), {"--listen", "127.0.0.1:0"});
  {
    std::optional<OnProcessor> there;
    if (processor) there.emplace(*processor);
    process_ = std::make_unique<Process>(arguments);
  }
  address_ = process_->address();
  if (address_.empty()) throw std::runtime_error("remeshd does not serve:\n" + process_->log());
  stub_ = v1::RemeshService::NewStub(connect());
}

std::shared_ptr<grpc::Channel> ServedDaemon::connect(bool unlimited_messages) const {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  if (unlimited_messages) {
    arguments.SetMaxReceiveMessageSize(-1);
    arguments.SetMaxSendMessageSize(-1);
  }
  return grpc::CreateCustomChannel(address_, credentials_, arguments);
}

std::string ServedDaemon::obituary(const std::string& what) {
  // A process that dies takes a moment to be a dead one.
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  siginfo_t end{};
  std::string text = what;
  // It stays a dead one, for the process' own owner to wait for.
  if (::waitid(P_PID, static_cast<id_t>(process_->id()), &end, WEXITED | WNOHANG | WNOWAIT) == 0 &&
      end.si_pid != 0)
    text += "; remeshd ended by " + std::string(end.si_code == CLD_EXITED ? "status " : "signal ") +
            std::to_string(end.si_status);
  return text + "\n" + process_->log();
}

v1::ServerInfo ServedDaemon::info() {
  grpc::ClientContext context;
  v1::GetServerInfoResponse reply;
  const grpc::Status status = stub_->GetServerInfo(&context, {}, &reply);
  if (!status.ok()) throw std::runtime_error(obituary("GetServerInfo: " + status.error_message()));
  return reply.server();
}

double ServedDaemon::processor_seconds() const {
  std::ifstream in("/proc/" + std::to_string(process_->id()) + "/stat");
  std::string line;
  std::getline(in, line);
  // After the name, which may have blanks: state and ten more, then user and system time.
  std::istringstream fields(line.substr(line.rfind(')') + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  long user = 0, system = 0;
  fields >> user >> system;
  return static_cast<double>(user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

void ServedDaemon::forget_peak() const {
  std::ofstream("/proc/" + std::to_string(process_->id()) + "/clear_refs") << 5;
}

bool ServedDaemon::wait_until_idle(double seconds) {
  const auto start = Clock::now();
  for (;;) {
    const v1::ServerLoad load = info().load();
    if (load.running() == 0 && load.queued() == 0) return true;
    if (seconds_since(start) > seconds) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

StoreFolder::StoreFolder(const std::string& name)
    : path_(std::filesystem::temp_directory_path() /
            ("remeshd-" + name + "-" + std::to_string(::getpid()))) {
  std::filesystem::remove_all(path_);
}

StoreFolder::~StoreFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace remeshd::test

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/daemon/process.h"

namespace remeshd::test {

/// remeshd as a process on a free port of loopback, kept on one processor where that is told
/// (`OnProcessor`), and a stub for it.
class ServedDaemon {
 public:
  using Credentials = std::shared_ptr<grpc::ChannelCredentials>;

  /// `credentials`: of all connections to it. Throws std::runtime_error where it does not serve
  /// within 10 s.
  explicit ServedDaemon(std::vector<std::string> arguments, std::optional<int> processor = {},
                        Credentials credentials = grpc::InsecureChannelCredentials());

  v1::RemeshService::Stub& stub() { return *stub_; }
  Process& process() { return *process_; }
  [[nodiscard]] pid_t process_id() const { return process_->id(); }
  [[nodiscard]] const std::string& address() const { return address_; }
  /// A connection of its own.
  [[nodiscard]] std::shared_ptr<grpc::Channel> connect(bool unlimited_messages = false) const;
  /// Throws std::runtime_error where it does not answer.
  v1::ServerInfo info();
  /// Processor time that it has used so far, in s. Other programs on the machine do not add to it.
  [[nodiscard]] double processor_seconds() const;
  /// Bytes in memory now, and the most there were since `forget_peak`.
  [[nodiscard]] std::size_t memory() const { return process_->memory("VmRSS"); }
  [[nodiscard]] std::size_t peak_memory() const { return process_->memory("VmHWM"); }
  void forget_peak() const;
  /// Waits until `running` and `queued` are 0; false after `seconds`.
  bool wait_until_idle(double seconds);

 private:
  /// What went wrong, with how the process ended and all that it said.
  std::string obituary(const std::string& what);

  const Credentials credentials_;
  std::unique_ptr<Process> process_;
  std::string address_;
  std::unique_ptr<v1::RemeshService::Stub> stub_;
};

/// A folder for a store, empty at first and removed in the end.
class StoreFolder {
 public:
  explicit StoreFolder(const std::string& name);
  StoreFolder(const StoreFolder&) = delete;
  StoreFolder& operator=(const StoreFolder&) = delete;
  ~StoreFolder();

  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  const std::filesystem::path path_;
};

}  // namespace remeshd::test

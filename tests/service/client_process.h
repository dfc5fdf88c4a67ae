#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace remeshd::test {

/// This very program as another process, to be killed or stopped in the middle of a call. Ends it
/// in the end.
class ClientProcess {
 public:
  /// Throws std::runtime_error where it cannot be started.
  explicit ClientProcess(std::vector<std::string> arguments);
  ClientProcess(const ClientProcess&) = delete;
  ClientProcess& operator=(const ClientProcess&) = delete;
  ~ClientProcess();

  void signal(int number) const;

 private:
  pid_t id_ = 0;
};

}  // namespace remeshd::test

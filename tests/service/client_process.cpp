#include "tests/service/client_process.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

extern char** environ;

namespace remeshd::test {

ClientProcess::ClientProcess(std::vector<std::string> arguments) {
  constexpr const char* kThisProgram = "/proc/self/exe";
  arguments.insert(arguments.begin(), kThisProgram);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  if (::posix_spawn(&id_, kThisProgram, nullptr, nullptr, argv.data(), environ) != 0)
    throw std::runtime_error("no client process can be started");
}

ClientProcess::~ClientProcess() {
  signal(SIGKILL);
  ::waitpid(id_, nullptr, 0);
}

void ClientProcess::signal(int number) const { ::kill(id_, number); }

}  // namespace remeshd::test

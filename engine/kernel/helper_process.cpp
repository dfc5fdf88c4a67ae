#include "engine/kernel/helper_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>

namespace remeshd::kernel {
namespace {

constexpr int kPollMs = 20;

class FileDescriptor {
 public:
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() { close_now(); }

  [[nodiscard]] int get() const { return fd_; }
  void close_now() {
    if (fd_ >= 0) close(fd_);
    fd_ = -1;
  }

 private:
  int fd_;
};

/// A started process; killed and reaped at the latest when this goes.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() { kill_now(); }

  void kill_now() {
    if (pid_ < 0) return;
    kill(pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
  }
  /// The status of waitpid if it has ended. Where somebody else reaps all children it counts as a
  /// plain exit: the answer itself tells whether it is whole.
  std::optional<int> ended() {
    int status = 0;
    const pid_t got = waitpid(pid_, &status, WNOHANG);
    if (got == 0 || (got < 0 && errno == EINTR)) return std::nullopt;
    pid_ = -1;
    return got < 0 ? 0 : status;
  }

 private:
  pid_t pid_;
};

/// posix_spawn, never fork: this process may run gRPC, whose locks a forked copy would inherit.
int spawn(const std::filesystem::path& program, std::vector<std::string>& arguments, int socket,
          pid_t& pid) {
  const std::string path = program.string();
  std::string name = program.filename().string();
  std::vector<char*> argv{name.data()};
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, STDIN_FILENO, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);

  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);

  // The daemon's environment may hold what is none of the helper's business.
  std::array<char*, 1> environment{nullptr};
  const int failure =
      posix_spawn(&pid, path.c_str(), &actions, &attributes, argv.data(), environment.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failure;
}

/// Sends what the socket takes; false once the helper reads no more.
bool send_some(int socket, std::span<const std::byte>& input) {
  const ssize_t n = send(socket, input.data(), input.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (n < 0) return errno == EAGAIN || errno == EINTR;
  input = input.subspan(static_cast<std::size_t>(n));
  return true;
}

/// Appends what has come; false once nothing more will.
bool receive_some(int socket, std::vector<std::byte>& answer) {
  std::array<std::byte, 1 << 16> buffer;
  const ssize_t n = recv(socket, buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (n < 0) return errno == EAGAIN || errno == EINTR;
  answer.insert(answer.end(), buffer.begin(), buffer.begin() + n);
  return n > 0;
}

}  // namespace

HelperEnd run_helper(const std::filesystem::path& program, std::vector<std::string> arguments,
                     std::span<const std::byte> input, const HelperLimits& limits, const Run& run) {
  run.poll();
  // A socket and no pipes: a write to a helper that died must not raise SIGPIPE in this process.
  std::array<int, 2> ends{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    return {.kind = HelperEnd::Kind::NotStarted, .code = errno};
  const FileDescriptor ours(ends[0]);
  FileDescriptor theirs(ends[1]);
  pid_t pid = -1;
  if (const int failure = spawn(program, arguments, theirs.get(), pid); failure != 0)
    return {.kind = HelperEnd::Kind::NotStarted, .code = failure};
  Child child(pid);
  theirs.close_now();

  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto too_late = [&] {
    return std::chrono::duration<double>(Clock::now() - start).count() > limits.seconds;
  };

  HelperEnd end;
  bool sending = true;
  const auto stop_sending = [&] {
    shutdown(ours.get(), SHUT_WR);
    sending = false;
  };
  for (bool more = true; more;) {
    run.poll();
    if (too_late()) return {.kind = HelperEnd::Kind::TimedOut};
    if (sending && input.empty()) stop_sending();
    pollfd watched{ours.get(), static_cast<short>(POLLIN | (sending ? POLLOUT : 0)), 0};
    if (poll(&watched, 1, kPollMs) <= 0) continue;
    if (sending && (watched.revents & POLLOUT) != 0 && !send_some(ours.get(), input))
      stop_sending();
    if ((watched.revents & (POLLIN | POLLHUP | POLLERR)) != 0)
      more = receive_some(ours.get(), end.answer);
    if (end.answer.size() > limits.answer_bytes) return {.kind = HelperEnd::Kind::TalkedTooMuch};
  }
  for (;;) {
    if (const std::optional<int> status = child.ended()) {
      const bool exited = WIFEXITED(*status);
      end.kind = exited ? HelperEnd::Kind::Exited : HelperEnd::Kind::Signalled;
      end.code = exited ? WEXITSTATUS(*status) : WTERMSIG(*status);
      return end;
    }
    run.poll();
    if (too_late()) return {.kind = HelperEnd::Kind::TimedOut};
    poll(nullptr, 0, 1);
  }
}

}  // namespace remeshd::kernel

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/base/run.h"

namespace remeshd::kernel {

/// How a helper ended, and all of its output unless it was stopped.
struct HelperEnd {
  enum class Kind { Exited, Signalled, TimedOut, TalkedTooMuch, NotStarted };
  Kind kind = Kind::Exited;
  int code = 0;  ///< exit code, signal, or errno where it did not start
  std::vector<std::byte> answer;
};

struct HelperLimits {
  double seconds = 60;           ///< s from start to end
  std::size_t answer_bytes = 0;  ///< it is killed when its output is longer
};

/// Starts a program, sends it `input` on its stdin and collects its stdout; its stderr is lost.
///
/// Post: the process has ended and is reaped, whatever happened; no file descriptor is left open.
/// The program inherits no file descriptors but stdin, stdout and stderr, no environment variables
/// and no blocked signals. It has a process group of its own, so that a Ctrl-C at the terminal
/// does not reach it.
/// Throws Error(Cancelled) within 20 ms of a stop request.
HelperEnd run_helper(const std::filesystem::path& program, std::vector<std::string> arguments,
                     std::span<const std::byte> input, const HelperLimits& limits, const Run& run);

}  // namespace remeshd::kernel

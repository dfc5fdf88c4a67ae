#pragma once

#include <string>
#include <vector>

namespace remeshd::test {

/// What a child process wrote and how it ended.
struct ChildEnd {
  std::string output;  ///< its stdout
  std::string errors;  ///< the end of its stderr
  int signal = 0;      ///< that ended it
  int exit_code = 0;
  bool too_long = false;   ///< it was killed by this process
  double cpu_seconds = 0;  ///< processor time, its own and that of its children
  double peak_bytes = 0;   ///< most resident memory; not below what this process has itself

  [[nodiscard]] bool well() const { return signal == 0 && exit_code == 0 && !too_long; }
  /// `exit code 3`, `signal 11`, `killed after its time`.
  [[nodiscard]] std::string how() const;
};

/// This very program, to be run as a child with other arguments.
inline const std::string kThisProgram = "/proc/self/exe";

/// Runs a program, looked for in PATH where it is a bare name, to its end or for `seconds` of wall
/// clock. `arguments` begin with the name it is called by.
///
/// Throws std::runtime_error where no process can be started.
ChildEnd run_child(const std::string& program, const std::vector<std::string>& arguments,
                   double seconds);

/// In a child: the processor time from now on after which the system ends it with SIGXCPU.
void limit_processor_time(double seconds);

}  // namespace remeshd::test

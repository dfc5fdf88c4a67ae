#pragma once

#include <string>
#include <vector>

namespace remeshd::campaign {

/// What a child process wrote and how it ended.
struct WorkerResult {
  std::vector<std::string> lines;  ///< of its stdout
  std::string errors;              ///< the end of its stderr
  int signal = 0;                  ///< that ended it
  int exit_code = 0;
  bool too_long = false;  ///< it was killed by this process
};

/// Runs this program with the arguments, to its end or for `seconds` of wall clock.
/// Throws std::runtime_error where no process can be started.
WorkerResult run_worker(const std::vector<std::string>& arguments, double seconds);

/// In a worker: the processor time from now on after which the system ends it with SIGXCPU.
void limit_processor_time(double seconds);

}  // namespace remeshd::campaign

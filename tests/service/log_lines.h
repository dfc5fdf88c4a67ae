#pragma once

#include <string>
#include <vector>

namespace remeshd::test {

/// A line that the daemon's log has for a call.
struct LoggedCall {
  std::string method, status, reason;
  double milliseconds = 0;
};

/// The calls of a log, in the order in which they ended.
std::vector<LoggedCall> logged_calls(const std::string& log);

}  // namespace remeshd::test

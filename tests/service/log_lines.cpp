#include "tests/service/log_lines.h"

#include <sstream>

namespace remeshd::test {

std::vector<LoggedCall> logged_calls(const std::string& log) {
  std::vector<LoggedCall> calls;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" call=") == std::string::npos) continue;
    LoggedCall call;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      const auto equals = word.find('=');
      if (equals == std::string::npos) continue;
      const std::string name = word.substr(0, equals), value = word.substr(equals + 1);
      if (name == "method") call.method = value;
      if (name == "status") call.status = value;
      if (name == "reason") call.reason = value;
      if (name == "ms") call.milliseconds = std::stod(value);
    }
    calls.push_back(std::move(call));
  }
  return calls;
}

}  // namespace remeshd::test

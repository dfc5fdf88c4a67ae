#pragma once

#include <stdexcept>
#include <string>

namespace remeshd {

/// The configuration is wrong; `what` names the place, the value and what would be right.
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace remeshd

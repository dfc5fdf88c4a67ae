#pragma once

#include <string>

#include "server/config/option_table.h"

namespace remeshd {

/// An option with a value and the place that gives it.
struct GivenOption {
  const Option* option;
  OptionValue value;
  std::string place;  ///< `remeshd.toml:3: maxNodes`, `REMESHD_MAX_NODES`, `--max-nodes`
};

}  // namespace remeshd

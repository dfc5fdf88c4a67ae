#pragma once

#include <array>

#include "engine/remesh/report.h"

namespace remeshd::test {

/// A way as the README calls it.
inline const char* name_of(Way way) {
  constexpr std::array kNames{"unchanged", "morphed", "local",  "full",
                              "fresh",     "TetGen",  "renewed"};
  return kNames.at(static_cast<std::size_t>(way));
}

}  // namespace remeshd::test

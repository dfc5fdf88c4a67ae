#pragma once

#include <array>

#include "engine/revision/report.h"

namespace remeshd::test {

/// A strategy as the README calls it.
inline const char* name_of(MeshStrategy strategy) {
  constexpr std::array kNames{"unchanged", "morphed", "local",  "full",
                              "fresh",     "TetGen",  "renewed"};
  return kNames.at(static_cast<std::size_t>(strategy));
}

}  // namespace remeshd::test

#pragma once

#include <string>

#include "engine/remesh/remesh.h"

namespace remeshd {

/// Reads a revision as it was stored before there were arrays by name: algorithm version 13 and
/// before. Throws Error(Internal) on anything else.
Revision read_first_format(const std::string& bytes, const Run& run);

}  // namespace remeshd

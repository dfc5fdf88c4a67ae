#pragma once

#include <string>

#include "engine/revision/revision.h"

namespace remeshd {

/// Reads a revision as it was stored before there were arrays by name: all in one piece, in formats
/// 8 and 9. What follows the revision in the bytes is left alone.
/// Throws Error(Internal) on anything else, and on indices beyond an array.
Revision read_older_format(const std::string& bytes, const Run& run);

}  // namespace remeshd

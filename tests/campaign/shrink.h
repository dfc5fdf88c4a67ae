#pragma once

#include <filesystem>

namespace remeshd::campaign {

/// Makes a stored case smaller as long as its last step fails in the same way: fewer steps, edits,
/// features and nodes, numbers for expressions, fewer digits. Writes `NAME.small.json` beside it
/// and returns that file. `seconds`: no try is started later.
std::filesystem::path shrink_file(const std::filesystem::path& file, double seconds);

}  // namespace remeshd::campaign

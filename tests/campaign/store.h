#pragma once

#include <filesystem>

#include "tests/campaign/work.h"

namespace remeshd::campaign {

/// Writes the case up to the step that failed, to be replayed: `invalid-volume-7-123-2.json` in the
/// folder, by failure, seed, number and step. Returns the file.
std::filesystem::path store_failure(const std::filesystem::path& folder, const WorkedCase& worked,
                                    const Outcome& outcome);

void write_case_file(const std::filesystem::path& file, const CampaignCase& c);
CampaignCase read_case_file(const std::filesystem::path& file);

}  // namespace remeshd::campaign

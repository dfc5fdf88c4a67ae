#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "server/config/given_option.h"

namespace remeshd {

/// Reads a TOML file whose keys are `Option::key` (or `snake_key`), all at the top level.
///
/// Throws ConfigError, naming file and line: the file cannot be read, is no TOML or has more than
/// 1 MiB; a key is unknown (the nearest one is suggested) or given in both ways; a value is of
/// another kind than the option's.
std::vector<GivenOption> read_config_file(const std::filesystem::path& file);

/// The same for a text; `name` stands for the file in messages.
std::vector<GivenOption> read_config_text(std::string_view text, const std::string& name);

}  // namespace remeshd

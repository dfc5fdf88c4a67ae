#include "server/config/environment.h"

#include <unistd.h>

#include <algorithm>
#include <string_view>

#include "server/config/config_error.h"
#include "server/config/nearest_name.h"

namespace remeshd {
namespace {

constexpr std::string_view kPrefix = "REMESHD_";
constexpr std::string_view kConfig = "REMESHD_CONFIG";
constexpr std::string_view kHelper = "REMESHD_TETGEN";  // read where the helper is started

bool is_of_kubernetes(std::string_view name) {
  return name == "REMESHD_PORT" || name.starts_with("REMESHD_PORT_") ||
         name.starts_with("REMESHD_SERVICE_");
}

/// Of an unknown variable. The prefix, which all have in common, would make all of them similar.
std::string warning(const std::string& name) {
  std::vector<std::string> endings;
  for (std::string& known : option_names(&Option::variable))
    endings.push_back(known.substr(kPrefix.size()));
  for (const std::string_view known : {kConfig, kHelper})
    endings.emplace_back(known.substr(kPrefix.size()));
  std::string nearest = nearest_name(name.substr(kPrefix.size()), endings);
  if (!nearest.empty()) nearest = "; did you mean `" + std::string(kPrefix) + nearest + "`?";
  return "environment: " + name + " is unknown" + nearest;
}

}  // namespace

Environment read_environment(const std::vector<std::string>& settings) {
  Environment out;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (!setting.starts_with(kPrefix) || equals == std::string::npos) continue;
    const std::string name = setting.substr(0, equals);
    const std::string value = setting.substr(equals + 1);
    if (value.empty() || name == kHelper) continue;
    if (name == kConfig) {
      out.config_file = value;
      continue;
    }
    const auto& table = option_table();
    const auto option = std::find_if(table.begin(), table.end(),
                                     [&](const Option& each) { return each.variable() == name; });
    if (option == table.end()) {
      if (!is_of_kubernetes(name)) out.warnings.push_back(warning(name));
      continue;
    }
    try {
      out.given.push_back({&*option, parse_option_value(option->kind, value), name});
    } catch (const ConfigError& why) {
      throw ConfigError(name + ": " + why.what());
    }
  }
  return out;
}

std::vector<std::string> process_environment() {
  std::vector<std::string> settings;
  for (char** setting = environ; setting != nullptr && *setting != nullptr; ++setting)
    settings.emplace_back(*setting);
  return settings;
}

}  // namespace remeshd

#include "server/config/environment.h"

#include <unistd.h>

#include <algorithm>
#include <regex>
#include <string_view>

#include "engine/base/text/nearest_name.h"
#include "server/config/config_error.h"

namespace remeshd {
namespace {

constexpr std::string_view kPrefix = "REMESHD_";
constexpr std::string_view kConfig = "REMESHD_CONFIG";
constexpr std::string_view kHelper = "REMESHD_TETGEN";  // read where the helper is started

/// Whether a variable is one that Kubernetes, or a link between Docker containers, sets for a
/// service whose name begins with `remeshd`.
bool is_of_a_service(const std::string& name) {
  static const std::regex shape(
      "REMESHD(_[A-Z0-9_]+)?_(SERVICE_HOST|SERVICE_PORT(_[A-Z0-9_]+)?|"
      "PORT(_[0-9]+_(TCP|UDP|SCTP)(_(PROTO|PORT|ADDR))?)?)");
  return std::regex_match(name, shape);
}

/// The error for an unknown variable. Names are compared without the prefix, which all have in
/// common and which would make all of them similar.
ConfigError unknown(const std::string& name) {
  std::vector<std::string> endings;
  for (std::string& known : option_names(&Option::variable))
    endings.push_back(known.substr(kPrefix.size()));
  for (const std::string_view known : {kConfig, kHelper})
    endings.emplace_back(known.substr(kPrefix.size()));
  std::string nearest = nearest_name(name.substr(kPrefix.size()), endings);
  if (!nearest.empty()) nearest = "; did you mean `" + std::string(kPrefix) + nearest + "`?";
  return ConfigError("environment: " + name + " is unknown" + nearest);
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
      if (!is_of_a_service(name)) throw unknown(name);
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

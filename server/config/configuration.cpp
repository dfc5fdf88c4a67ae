#include "server/config/configuration.h"

#include <utility>

#include "server/config/config_error.h"
#include "server/config/config_file.h"
#include "server/config/environment.h"
#include "server/transport/listen_address.h"

namespace remeshd {
namespace {

void set_all(const std::vector<GivenOption>& given, Settings& settings) {
  for (const GivenOption& each : given) {
    try {
      each.option->set(settings, each.value);
    } catch (const ConfigError& why) {
      throw ConfigError(each.place + ": " + why.what());
    }
  }
}

}  // namespace

Configuration read_configuration(std::vector<std::string> arguments,
                                 const std::vector<std::string>& environment) {
  Configuration out;
  const CommandLine command_line = read_command_line(std::move(arguments));
  out.task = command_line.task;
  out.answer = command_line.answer;
  if (out.answer) return out;
  const Environment variables = read_environment(environment);
  out.warnings = variables.warnings;
  const std::string& file =
      command_line.config_file.empty() ? variables.config_file : command_line.config_file;
  if (!file.empty()) set_all(read_config_file(file), out.settings);
  set_all(variables.given, out.settings);
  set_all(command_line.given, out.settings);
  return out;
}

void check_settings(const Settings& settings) {
  if (settings.daemon.listen.empty()) throw ConfigError("listen: no address is given");
  for (const std::string& address : settings.daemon.listen) parse_listen_address(address);
}

std::string print_config(const Settings& settings) {
  std::string out;
  for (const Option& option : option_table())
    out += "# " + option.help + '\n' + option.key() + " = " + to_toml(option.get(settings)) + '\n';
  return out;
}

}  // namespace remeshd

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "server/config/option_value.h"
#include "server/config/settings.h"

namespace remeshd {

/// One setting. Its three names follow from one: `--max-nodes`, `maxNodes` in a file,
/// `REMESHD_MAX_NODES` in the environment.
struct Option {
  std::string name;  ///< `max-nodes`
  OptionKind kind;
  std::string argument;  ///< what the help calls its value: `N`; empty for a switch
  std::string help;
  /// Throws ConfigError where the value is out of range. Pre: the value is of `kind`.
  std::function<void(Settings&, const OptionValue&)> set;
  std::function<OptionValue(const Settings&)> get;

  [[nodiscard]] std::string flag() const { return "--" + name; }
  [[nodiscard]] std::string key() const;        ///< `maxNodes`
  [[nodiscard]] std::string snake_key() const;  ///< `max_nodes`
  [[nodiscard]] std::string variable() const;   ///< `REMESHD_MAX_NODES`
};

/// Every option that there is, in the order of `--help`. A new one is a line here.
const std::vector<Option>& option_table();

/// One name of every option: `option_names(&Option::key)`.
std::vector<std::string> option_names(std::string (Option::*name)() const);

}  // namespace remeshd

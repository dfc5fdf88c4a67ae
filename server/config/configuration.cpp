#include "server/config/configuration.h"

#include <algorithm>
#include <utility>

#include "server/config/config_error.h"
#include "server/config/config_file.h"
#include "server/config/environment.h"
#include "server/designs/postgres.h"
#include "server/guard/tier_secrets.h"
#include "server/guard/tls_files.h"
#include "server/guard/tokens.h"
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

/// Addresses that other machines can reach need mutual TLS: a stranger without a certificate gets
/// no further than the handshake, whereas a token is checked after gRPC has read the call.
void check_reach(const std::string& address, const Settings& settings) {
  if (parse_listen_address(address).is_loopback()) return;
  if (settings.daemon.tls.mutual() || settings.behind_proxy) return;
  throw ConfigError("listen: other machines can reach " + address +
                    ": that needs tls-cert, tls-key and tls-client-ca, or behind-proxy where a "
                    "proxy guards it");
}

void check_metrics(const Settings& settings) {
  const ListenAddress address = parse_listen_address(settings.metrics);
  if (address.is_unix()) throw ConfigError("metrics: is to be HOST:PORT");
  if (!address.is_loopback() && !settings.insecure_metrics)
    throw ConfigError("metrics: other machines can reach " + settings.metrics +
                      ", and whoever does may read them; insecure-metrics allows it");
}

void check_tier(const Settings& settings) {
  const TierSettings& tier = settings.tier;
  if (tier.place.find("://") != std::string::npos && !is_http(tier.place))
    throw ConfigError("tier: " + tier.place + " is neither a folder nor http:// or https://");
  if (settings.daemon.store.empty())
    throw ConfigError("tier: needs a store, where what it is to get waits");
  if (tier.key_file.empty()) throw ConfigError("tier: needs a tier-key-file");
  if (tier.s3_region.empty() != tier.s3_credentials_file.empty())
    throw ConfigError("tier-s3-region and tier-s3-credentials-file go together");
  if (!tier.s3_region.empty() && !is_http(tier.place))
    throw ConfigError("tier-s3-region: the tier is a folder");
  read_tier_secrets(tier.key_file, tier.s3_credentials_file);
}

void check_designs(const Settings& settings) {
  const DesignSettings& designs = settings.designs;
  if (!designs.catalogue.empty() || !designs.replicas.empty()) {
    if (settings.tier.place.empty())
      throw ConfigError(std::string(designs.catalogue.empty() ? "replicas" : "catalogue") +
                        ": needs a tier, from which the others have the revisions");
    if (!designs.catalogue.empty() && !designs.replicas.empty())
      throw ConfigError("replicas: with a catalogue, designs are at all of them");
  }
  if (!designs.catalogue.empty())
    if (const std::string fault = Postgres::fault_of(designs.catalogue); !fault.empty())
      throw ConfigError("catalogue: " + fault);
  if (designs.replicas.empty() != designs.replica.empty())
    throw ConfigError("replicas and replica go together");
  if (!designs.replica.empty() &&
      std::ranges::find(designs.replicas, designs.replica) == designs.replicas.end())
    throw ConfigError("replica: " + designs.replica + " is none of the replicas");
}

}  // namespace

Configuration read_configuration(std::vector<std::string> arguments,
                                 const std::vector<std::string>& environment) {
  Configuration out;
  const CommandLine command_line = read_command_line(std::move(arguments));
  out.task = command_line.task;
  out.answer = command_line.answer;
  out.health_address = command_line.health_address;
  out.health_service = command_line.health_service;
  if (out.answer) return out;
  const Environment variables = read_environment(environment);
  const std::string& file =
      command_line.config_file.empty() ? variables.config_file : command_line.config_file;
  if (!file.empty()) set_all(read_config_file(file), out.settings);
  set_all(variables.given, out.settings);
  set_all(command_line.given, out.settings);
  return out;
}

void check_settings(const Settings& settings) {
  if (settings.daemon.listen.empty()) throw ConfigError("listen: no address is given");
  for (const std::string& address : settings.daemon.listen) check_reach(address, settings);
  if (!settings.health_socket.empty())
    parse_listen_address("unix:" + settings.health_socket.string());
  if (!settings.metrics.empty()) check_metrics(settings);
  check_tls_files(settings.daemon.tls);
  if (!settings.tier.place.empty()) check_tier(settings);
  check_designs(settings);
  if (!settings.token_file.empty()) Tokens::read(settings.token_file);
}

std::string health_address(const Configuration& configuration) {
  if (!configuration.health_address.empty()) return configuration.health_address;
  const Settings& settings = configuration.settings;
  if (!settings.health_socket.empty()) return "unix:" + settings.health_socket.string();
  for (const std::string& address : settings.daemon.listen)
    if (address.starts_with("unix:")) return address;
  if (settings.daemon.listen.empty() || settings.daemon.listen.front().ends_with(":0"))
    throw ConfigError("--health: name the address, or configure a health-socket");
  return settings.daemon.listen.front();
}

std::string print_config(const Settings& settings) {
  std::string out;
  for (const Option& option : option_table())
    out += "# " + option.help + '\n' + option.key() + " = " + to_toml(option.get(settings)) + '\n';
  return out;
}

}  // namespace remeshd

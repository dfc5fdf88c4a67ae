// What an operator writes: configuration file, environment and flags; tokens; addresses. The first
// byte chooses which. No name is asked for in the network (no_resolver.cpp).
#include <algorithm>

#include "engine/base/error.h"
#include "server/config/config_error.h"
#include "server/config/config_file.h"
#include "server/config/configuration.h"
#include "server/config/environment.h"
#include "server/guard/secret_file.h"
#include "server/guard/tokens.h"
#include "server/transport/listen_address.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/scratch_folder.h"
#include "tests/fuzz/targets.h"

namespace remeshd::fuzz {
namespace {

/// Settings that were read are printed as a file that is read as the same settings.
void check_printed(const Settings& settings) {
  const std::string text = print_config(settings);
  Settings back;
  for (const GivenOption& given : read_config_text(text, "printed"))
    given.option->set(back, given.value);
  expect(print_config(back) == text, "settings that are printed are others");
}

void check_settings_told(const Settings& settings) {
  check_printed(settings);
  check_settings(settings);
}

void toml(std::string_view text) {
  Settings settings;
  for (const GivenOption& given : read_config_text(text, "remeshd.toml"))
    given.option->set(settings, given.value);
  check_settings_told(settings);
}

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> out;
  Input input(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  while (!input.empty()) out.emplace_back(input.until('\n'));
  return out;
}

/// Neither arguments nor variables have a NUL in them.
std::vector<std::string> texts_of_process(std::string_view text) {
  std::vector<std::string> out = split(text);
  for (std::string& each : out) each.resize(std::min(each.find('\0'), each.size()));
  return out;
}

void environment(std::string_view text) {
  Settings settings;
  for (const GivenOption& given : read_environment(texts_of_process(text)).given)
    given.option->set(settings, given.value);
  check_settings_told(settings);
}

/// Files that an input would name are left alone: they may be devices.
void flags(std::string_view text) {
  std::vector<std::string> arguments = texts_of_process(text);
  std::erase_if(arguments, [](const std::string& a) { return a.starts_with("--config"); });
  const Configuration read = read_configuration(arguments, {});
  if (read.answer) return;
  if (read.task == Task::Health) health_address(read);
  check_settings_told(read.settings);
}

void tokens(std::string_view text) {
  const ScratchFolder folder;
  folder.write("tokens", text);
  const Tokens read = Tokens::read(folder.path() / "tokens");
  expect(!read.tenant_of("").has_value(), "an empty token is somebody's");
  for (const std::string& line : split(text)) {
    const auto tenant = read.tenant_of(line.substr(line.find(' ') + 1));
    if (tenant) expect(!tenant->empty() && tenant->size() <= 64, "a tenant without a name");
  }
}

void address(std::string_view text) {
  const ListenAddress read = parse_listen_address(std::string(text));
  expect(!read.sockets.empty(), "an address without a socket");
  for (const SocketAddress& socket : read.sockets) {
    const std::string number = numeric(socket);
    expect(read.is_unix() ? number.empty() : parse_listen_address(number).port == read.port,
           "an address that is told as another: " + number);
  }
}

constexpr void (*kKinds[])(std::string_view) = {toml, environment, flags, tokens, address};

}  // namespace
}  // namespace remeshd::fuzz

int fuzz_config(const std::uint8_t* data, std::size_t size) {
  using namespace remeshd;
  fuzz::Input input(data, size);
  const auto kind = fuzz::kKinds[input.byte() % std::size(fuzz::kKinds)];
  try {
    kind(input.rest());
  } catch (const ConfigError& error) {
    fuzz::expect(*error.what() != '\0', "an error without words");
  } catch (const SecretFileError& error) {
    fuzz::expect(*error.what() != '\0', "an error without words");
  } catch (const Error& error) {
    fuzz::expect_in_words(error);
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::config_seeds() {
  Settings settings;
  settings.daemon.listen = {"127.0.0.1:0", "unix:/run/remeshd.sock", "[::1]:50051"};
  settings.daemon.store = "/var/lib/remeshd";
  const auto of_kind = [](int kind, const std::string& text) {
    return static_cast<char>(kind) + text;
  };
  Seeds seeds{of_kind(0, "listen = [\"127.0.0.1:0\"]\nmax_nodes = 20000\nqueueWait = 1.5\n"),
              of_kind(0, "reflection = true\nlogFormat = \"json\"\ntls-cert = '''x'''\n"),
              of_kind(1, "REMESHD_MAX_NODES=20000\nREMESHD_LISTEN=localhost:1,[::1]:2\nHOME=/x"),
              of_kind(2, "--listen\n127.0.0.1:0\n--max-nodes=20000\n--reflection\n--grace\n.5"),
              of_kind(2, "--health\nlocalhost:1\n--live"),
              of_kind(2, "--print-config\n--metrics\n127.0.0.1:9090\n--insecure-metrics=false"),
              of_kind(3, "# tenants\nalpha 0123456789abcdef\nbeta  fedcba9876543210\n")};
  for (const char* text : {"127.0.0.1:80", "[::1]:80", "localhost:1", "unix:/run/x", "host.name:7"})
    seeds.push_back(of_kind(4, text));
  // Each option by itself, so that none of its names has to be guessed.
  for (const Option& option : option_table()) {
    const std::string value = to_toml(option.get(settings));
    seeds.push_back(of_kind(0, option.key() + " = " + value + "\n"));
  }
  return seeds;
}

#include "client/cli/connect_options.h"

#include <fstream>
#include <iterator>
#include <sstream>

#include "client/cli/exit_code.h"
#include "remeshd/mesh_file.h"

namespace remeshd::cli {
namespace {

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw client::FileError(file.string() + ": cannot be read");
  return text;
}

}  // namespace

client::ConnectOptions connect_options(const GlobalOptions& options) {
  if (options.tls_cert.empty() != options.tls_key.empty())
    throw UsageError("--tls-cert and --tls-key belong together");
  client::ConnectOptions out;
  if (!options.tls_ca.empty()) out.root_certificates = read_file(options.tls_ca);
  if (!options.tls_cert.empty()) out.certificate = read_file(options.tls_cert);
  if (!options.tls_key.empty()) out.private_key = read_file(options.tls_key);
  if (!options.token_file.empty()) {
    std::istringstream words(read_file(options.token_file));
    std::string more;
    if (!(words >> out.token) || words >> more)
      throw client::FileError(options.token_file.string() + ": is to hold one token and no more");
  }
  return out;
}

}  // namespace remeshd::cli

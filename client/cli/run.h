#pragma once

#include <filesystem>
#include <functional>
#include <istream>
#include <optional>
#include <ostream>
#include <stop_token>
#include <string>
#include <vector>

#include "remeshd/client.h"

namespace remeshd::cli {

/// Options that every command takes, before or after its name.
struct GlobalOptions {
  /// Address of the daemon, or of several, with commas between; environment REMESH_ADDRESS.
  std::string address = "127.0.0.1:50051";
  /// PEM files for TLS: who signs the daemon's certificate, the own one and its key; empty: none.
  std::filesystem::path tls_ca, tls_cert, tls_key;
  std::filesystem::path token_file;  ///< holds the token to send; empty: none
  bool local = false;                ///< work in this process, without a daemon
  std::filesystem::path store;       ///< of `local`; empty: by the XDG cache rules
  std::optional<double> timeout;     ///< s, for each call
  double patience = 30;              ///< s, where no daemon is available
};

/// What surrounds a command.
struct Surroundings {
  std::istream& in;       ///< documents whose name is `-`
  std::ostream& out;      ///< data
  std::ostream& err;      ///< messages
  bool terminal = false;  ///< whether `err` is a terminal that shows progress bars
  std::stop_token stop;   ///< requested by an interrupt
  /// Connects to the daemon; called at most once.
  std::function<client::Client(const GlobalOptions&)> connect;
};

/// Runs `remesh` with these arguments (the program's name is not among them) and returns its exit
/// code. Throws nothing.
int run(const std::vector<std::string>& arguments, const Surroundings& surroundings);

}  // namespace remeshd::cli

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <stop_token>
#include <string>

#include "client/cli/console.h"
#include "client/cli/documents.h"
#include "client/cli/mesh_outputs.h"
#include "client/cli/run.h"
#include "remeshd/client.h"

namespace remeshd::cli {

/// What a command works with: the daemon, the two output streams, and the interrupt.
class Session {
 public:
  Session(const Surroundings& surroundings, const GlobalOptions& options, Console& console)
      : surroundings_(surroundings),
        options_(options),
        console_(console),
        documents_(surroundings.in) {}

  [[nodiscard]] std::ostream& out() const { return surroundings_.out; }
  [[nodiscard]] Console& console() const { return console_; }
  [[nodiscard]] Documents& documents() { return documents_; }
  /// Connects on first use.
  [[nodiscard]] const client::Client& client();
  /// How calls are made here: they end with an interrupt or after --timeout, and are made again for
  /// --patience.
  [[nodiscard]] client::CallOptions call() const;
  /// A stream of edits that shows its progress.
  [[nodiscard]] client::EditStream stream();
  /// Throws Interrupted after an interrupt.
  void poll() const;
  /// Throws FileError where something of the data stream could not be written.
  void check_output() const;

  /// Writes text to a file, or to the data stream where the name is `-`.
  void write_text(const std::filesystem::path& file, const std::string& text) const;
  /// Fetches the mesh of a revision, its model or both, as the files need, and writes them. Throws
  /// CallError, FileError.
  void write_mesh_of(const std::string& revision, const MeshOutputs& outputs);

 private:
  client::OnTransfer show_transfer();
  client::Mesh fetch_mesh(const std::string& revision);
  std::string fetch_model(const std::string& revision);

  const Surroundings& surroundings_;
  const GlobalOptions& options_;
  Console& console_;
  Documents documents_;
  std::optional<client::Client> client_;
};

/// Throws FileError unless the folder of the file is there; an empty name and `-` are fine. To be
/// called before something is made to be written there.
void check_text_file(const std::filesystem::path& file);

}  // namespace remeshd::cli

#include "client/cli/session.h"

#include "client/cli/exit_code.h"
#include "remeshd/mesh_file.h"

namespace remeshd::cli {

const client::Client& Session::client() {
  if (!client_) client_.emplace(surroundings_.connect(options_));
  return *client_;
}

client::CallOptions Session::call() const {
  return {.stop = surroundings_.stop, .timeout = options_.timeout, .reconnect = options_.patience};
}

client::EditStream Session::stream() {
  return client().stream(
      [this](const std::string&, const remesh::v1::Progress& progress) {
        console_.progress(progress);
      },
      call());
}

void Session::poll() const {
  if (surroundings_.stop.stop_requested()) throw Interrupted();
}

void Session::check_output() const {
  if (!out().flush()) throw client::FileError("cannot write to the standard output");
}

void Session::write_text(const std::filesystem::path& file, const std::string& text) const {
  if (file == kStandardStream) {
    out() << text;
    check_output();
  } else {
    client::write_file(file, text);
  }
}

client::OnTransfer Session::show_transfer() {
  return [this](std::uint64_t done, std::uint64_t total) {
    remesh::v1::Progress progress;
    progress.set_stage("transfer");
    progress.set_fraction(total == 0 ? 1 : static_cast<double>(done) / static_cast<double>(total));
    if (console_.verbose()) console_.progress(progress);
  };
}

client::Mesh Session::fetch_mesh(const std::string& revision) {
  client::Mesh mesh = client().get_mesh(revision, call(), show_transfer());
  console_.end_progress();
  poll();
  return mesh;
}

std::string Session::fetch_model(const std::string& revision) {
  std::string bytes = client().get_mesh_file(revision, kModelFormat, call(), show_transfer());
  console_.end_progress();
  poll();
  return bytes;
}

void Session::write_mesh_of(const std::string& revision, const MeshOutputs& outputs) {
  std::optional<client::Mesh> mesh;
  std::optional<std::string> model;
  for (const std::filesystem::path& file : outputs.files) {
    const bool of_model = outputs.format_of(file) == kModelFormat;
    if (of_model && !model) model = fetch_model(revision);
    if (!of_model && !mesh) mesh = fetch_mesh(revision);
  }
  for (const std::filesystem::path& file : outputs.files) {
    const std::string format = outputs.format_of(file);
    write_text(file, format == kModelFormat ? *model : client::mesh_in_format(format, *mesh));
    if (file != kStandardStream) console_.detail("wrote " + file.string());
  }
}

void check_text_file(const std::filesystem::path& file) {
  if (file.empty() || file == kStandardStream) return;
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw client::FileError(file.string() + ": there is no folder " + folder.string());
}

}  // namespace remeshd::cli

// An optimisation loop in small: meshes a model, sends edits over one stream, each on the result of
// the last, and writes every mesh.
//
//   edit_loop HOST:PORT FOLDER NODES MODEL.json EDIT.json...
//
// prints a table: seconds, nodes, share of nodes and tets kept, quality.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "remeshd/client.h"
#include "remeshd/mesh_file.h"

namespace {

/// Documents travel as they are: the daemon reads them and says what is wrong with one.
std::string read(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return text;
}

double percent(std::uint32_t part, std::uint32_t whole) {
  return whole == 0 ? 0 : 100.0 * part / whole;
}

void print_row(const std::string& step, const remesh::v1::Report& report) {
  std::printf("%-20s %8.3f %8u %8u %8.1f %8.1f %8.3f %8.3f %8.1f\n", step.c_str(),
              report.seconds().total(), report.nodes(), report.tets(),
              percent(report.nodes_kept(), report.nodes()),
              percent(report.tets_kept(), report.tets()), report.quality().volume_length_mean(),
              report.quality().volume_length_min(), report.quality().dihedral_min());
  std::fflush(stdout);
}

void run(int count, char** arguments) {
  namespace client = remeshd::client;
  const client::Client daemon = client::Client::connect(arguments[1]);
  const std::filesystem::path folder = arguments[2];
  std::filesystem::create_directories(folder);

  client::EditStream stream = daemon.stream();
  std::printf("%-20s %8s %8s %8s %8s %8s %8s %8s %8s\n", "step", "seconds", "nodes", "tets",
              "nodes", "tets", "quality", "quality", "angle");
  std::printf("%-20s %8s %8s %8s %8s %8s %8s %8s %8s\n", "", "", "", "", "kept %", "kept %", "mean",
              "least", "least");
  for (int i = 4; i < count; ++i) {
    const std::filesystem::path document = arguments[i];
    remesh::v1::RevisionResult reply;
    if (i == 4) {
      remesh::v1::CreateRevisionRequest request;
      request.set_document(read(document));
      request.mutable_options()->set_nodes(
          static_cast<std::uint32_t>(std::strtoul(arguments[3], nullptr, 10)));
      reply = stream.create(request).get();
    } else {
      remesh::v1::EditRevisionRequest request;  // without a base: on the design's head
      request.set_document(read(document));
      reply = stream.edit(request).get();
    }
    // `tool1-ac.edit.json` becomes `tool1-ac.vtu`. An optimiser would analyse the mesh here.
    const std::filesystem::path name = document.stem().stem();
    client::write_mesh(folder / (name.string() + ".vtu"), daemon.get_mesh(reply.revision().id()));
    print_row(name.string(), reply.report());
  }
  stream.finish();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fputs("usage: edit_loop HOST:PORT FOLDER NODES MODEL.json EDIT.json...\n", stderr);
    return 2;
  }
  try {
    run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "edit_loop: %s\n", error.what());
    return 1;
  }
  return 0;
}

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "remeshd/client.h"
#include "server/daemon.h"
#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"

// What meshes in a stream cost: bytes of a mesh told by its difference from its parent's over those
// of the whole, and the time beside the engine's of durable edits with such a mesh and without.
namespace remeshd::test {
namespace {

using client::Client;
using client::EditStream;
using client::MeshWanted;

struct Settings {
  int edits = 40;
  std::uint32_t nodes = 15000;
  bool goals = false;
};

remesh::v1::EditRevisionRequest pins(double radius) {
  remesh::v1::EditRevisionRequest request;
  request.set_document("{\"edits\": [{\"setParameter\": {\"name\": \"pin_radius\", \"value\": " +
                       std::to_string(radius) + "}}]}");
  return request;
}

int run(const Settings& settings) {
  DaemonOptions options;
  options.listen = {"127.0.0.1:0"};
  options.workers = 1;
  options.threads = 1;
  const StoreFolder store("mesh-delta");
  options.store = store.path();
  Daemon daemon(options, production_engine());
  const Client client = Client::connect(daemon.address());

  remesh::v1::CreateRevisionRequest first;
  std::ifstream in(std::string(REMESHD_CASES_DIR) + "/tool1-a.json");
  first.set_document(std::string(std::istreambuf_iterator<char>(in), {}));
  first.mutable_options()->set_nodes(settings.nodes);
  EditStream stream = client.stream(), without_meshes = client.stream();
  auto begun = stream.create(first, MeshWanted{.delta = true});
  (void)begun.mesh.get();
  first.set_design("without meshes");
  (void)without_meshes.create(first).get();
  std::vector<double> with_mesh, alone, engine, share, changed;
  for (int k = 0; k < settings.edits; ++k) {
    // Every second one without its mesh, so that both stand beside each other.
    const bool mesh = k % 2 == 0;
    const double radius = 4 + 0.01 * (k % 7) + 0.0001 * k;
    const auto start = Clock::now();
    if (!mesh) {
      const auto result = without_meshes.edit(pins(radius)).get();
      alone.push_back(1000 * seconds_since(start) - 1000 * result.report().seconds().total());
      continue;
    }
    auto answers = stream.edit(pins(radius), MeshWanted{.delta = true});
    const auto result = answers.result.get();
    const auto made = answers.mesh.get();
    const double total = 1000 * seconds_since(start);
    engine.push_back(1000 * result.report().seconds().total());
    with_mesh.push_back(total - engine.back());
    const auto bytes = [&](const MeshWanted& wanted) {
      std::uint64_t all = 0;
      const auto note = [&](std::uint64_t /*done*/, std::uint64_t whole) { all = whole; };
      (void)client.get_mesh(made->revision, {}, note, wanted);
      return static_cast<double>(all);
    };
    const auto parent = std::make_shared<const client::Mesh>(client.get_mesh(made->parent));
    share.push_back(bytes({.delta = true, .base = parent}) / bytes({}));
    changed.push_back(1 - 1.0 * result.report().tets_kept() / result.report().tets());
  }
  stream.finish();
  Goals goals(settings.goals);
  goals.tell("tets that are new, of an edit's", median(changed));
  goals.must_be_at_most("bytes of a difference over those of the mesh", percentile(share, 1), "",
                        .1);
  goals.tell("engine, of an edit", median(engine), "ms");
  goals.tell("beside it: rpc and store", median(alone), "ms");
  goals.at_most("beside it: rpc, store and mesh", median(with_mesh), "ms", 15);
  return goals.exit_status();
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("Measures meshes that come in a stream as differences",
                                     settings.goals);
  CLI::App& options = program.options();
  options.add_option("--edits", settings.edits)->check(CLI::Range(2, 100000));
  options.add_option("--nodes", settings.nodes);
  return program.run(argc, argv, [&] { return remeshd::test::run(settings); });
}

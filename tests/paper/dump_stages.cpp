// Runs one case with dumps: dump_stages EDIT NODES FOLDER, e.g. dump_stages tool1-ac 15000 dumps
// leaves the stages of the first mesh in FOLDER/original and those of the remesh in FOLDER/remesh.
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "engine/base/error.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"

using namespace remeshd;

int main(int argc, char** argv) try {
  if (argc != 4) {
    std::fputs("usage: dump_stages EDIT NODES FOLDER\n", stderr);
    return 2;
  }
  for (const test::EditCase& c : test::seven_cases()) {
    if (c.edit != argv[1]) continue;
    const std::filesystem::path folder = argv[3];
    MeshOptions options;
    options.nodes = static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10));
    options.iterations = 10;
    Run run;
    run.dumps = folder / "original";
    const ModelSource model = test::case_model(c.original);
    const Revision original = make_revision(nullptr, model, options, run);
    options.nodes.reset();
    run.dumps = folder / "remesh";
    make_revision(&original, apply(model, test::case_edit(c.edit)), options, run);
    return 0;
  }
  std::fprintf(stderr, "dump_stages: there is no case %s\n", argv[1]);
  return 2;
} catch (const Error& error) {
  std::fprintf(stderr, "dump_stages: %s\n", error.what());
  return 1;
}

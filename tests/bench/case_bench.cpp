// Runs one case through the engine alone and prints what the Report says, a line a mesh:
//   case_bench EDIT NODES ITERATIONS SEED [REPEATS]      e.g. case_bench tool1-ac 15000 10 1
// The original, the remesh and a regular run of the modified model with the remesh's node count.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/base/error.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"

using namespace remeshd;

namespace {

void print(const char* what, const Report& r) {
  const Counts& c = r.counts;
  const PhaseSeconds& s = r.seconds;
  std::printf(
      "%-8s nodes %6u tets %6u kept %5.1f%% tets kept %5.1f%% free %5.1f%% | setup %.3f diff %.3f "
      "copy %.3f loop %.3f extract %.3f (verify %.4f, %.1f%%; %u proved, chord %.3g) total %.3f | "
      "vl %.3f p01 %.3f min %.3f dih %.1f %.1f "
      "(before "
      "%.3f) away dih %.1f %.1f, sharp tets %u | vol %+.4f%% it %u samples %u active %u\n",
      what, c.nodes, c.tets, 100.0 * c.nodes_kept / c.nodes, 100.0 * c.tets_kept / c.tets,
      100 * r.free_share, s.setup, s.difference, s.copy, s.optimise, s.extract, s.verify,
      100 * s.verify / s.total, r.verification.tets_proved, r.verification.chord_error, s.total,
      r.quality.volume_length_mean, r.quality.volume_length_p01, r.quality.volume_length_min,
      r.quality.dihedral_min, r.quality.dihedral_max, r.quality_before.volume_length_mean,
      r.quality_away.dihedral_min, r.quality_away.dihedral_max, r.sharp_tets,
      100 * (r.volume / r.exact_volume - 1), c.iterations, c.samples, c.active_samples);
  for (const std::string& w : r.warnings) std::printf("         warning: %s\n", w.c_str());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 5) return 2;
  const std::string edit = argv[1];
  MeshOptions options{.nodes = static_cast<std::uint32_t>(std::atoi(argv[2])),
                      .iterations = static_cast<std::uint32_t>(std::atoi(argv[3])),
                      .seed = static_cast<std::uint64_t>(std::atoi(argv[4]))};
  // `tool1-ac` is the edit of the model `tool1-a`.
  const ModelSource source = test::case_model(edit.substr(0, edit.size() - 1));
  const Run run;
  for (int k = 0; k < (argc > 5 ? std::atoi(argv[5]) : 1); ++k) {
    const Revision original = make_revision(nullptr, source, options, run);
    print("original", original.report);
    MeshOptions inherit = options;
    inherit.nodes.reset();
    const ModelSource edited = apply(source, test::case_edit(edit));
    const Revision remesh = make_revision(&original, edited, inherit, run);
    print("remesh", remesh.report);
    MeshOptions same = options;
    same.nodes = remesh.report.counts.nodes;
    const Revision regular = make_revision(nullptr, edited, same, run);
    print("regular", regular.report);
    std::printf("         remesh / regular %.1f %%\n",
                100 * remesh.report.seconds.total / regular.report.seconds.total);
  }
  return 0;
} catch (const Error& e) {
  std::printf("error %s: %s (%s %s)\n", e.info().reason.c_str(), e.what(), e.info().feature.c_str(),
              e.info().parameter.c_str());
  return 1;
}

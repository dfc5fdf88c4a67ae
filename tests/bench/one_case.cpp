#include "tests/bench/one_case.h"

#include <cstdio>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"

namespace remeshd::bench {
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
  for (const Warning& w : r.warnings)
    std::printf("         warning: %s: %s\n", std::string(name_of(w.code)).c_str(),
                w.message.c_str());
}

}  // namespace

void run_one_case(const std::string& edit, std::uint32_t nodes, std::uint32_t iterations,
                  std::uint64_t seed, int repeats) {
  const MeshOptions options{.nodes = nodes, .iterations = iterations, .seed = seed};
  // `tool1-ac` is the edit of the model `tool1-a`.
  const ModelSource source = test::case_model(edit.substr(0, edit.size() - 1));
  const Run run;
  for (int k = 0; k < repeats; ++k) {
    const Revision original = make_revision(Revision::none(), source, options, run);
    print("original", original.report);
    MeshOptions inherit = options;
    inherit.nodes.reset();
    const ModelSource edited = apply(source, test::case_edit(edit));
    const Revision remesh = make_revision(original, edited, inherit, run);
    print("remesh", remesh.report);
    MeshOptions same = options;
    same.nodes = remesh.report.counts.nodes;
    const Revision regular = make_revision(Revision::none(), edited, same, run);
    print("regular", regular.report);
    std::printf("         remesh / regular %.1f %%\n",
                100 * remesh.report.seconds.total / regular.report.seconds.total);
  }
}

}  // namespace remeshd::bench

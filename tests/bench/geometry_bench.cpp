// Times the geometry side of an edit, evaluation, membership and cells, a line an edit:
//   geometry_bench [REPEATS] [ONLY]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/local_fuse/local_fuse.h"
#include "engine/model/solid.h"
#include "tests/support/cases.h"
#include "tests/support/large_models.h"

using namespace remeshd;

namespace {

double median_ms(int repeats, const std::function<void()>& work) {
  std::vector<double> times;
  for (int k = 0; k < repeats; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
            .count());
  }
  std::ranges::sort(times);
  return times[times.size() / 2];
}

void bench(const std::string& name, const ModelSource& base, const ModelSource& edited,
           int repeats) {
  const Run run;
  const FeatureModel original = evaluate(base);
  const CellularModel cells = build_cells(original, run);
  const double fresh =
      getenv("EDITONLY") ? 0 : median_ms(repeats, [&] { build_cells(evaluate(edited), run); });
  const double membership = median_ms(repeats, [&] { Membership{evaluate(edited)}; });
  const double edit =
      median_ms(repeats, [&] { build_cells(evaluate(edited), original, cells, run); });
  std::printf(
      "%-22s features %3zu faces %4zu  evaluate+membership %6.2f  fresh %8.2f  edit %8.2f ms\n",
      name.c_str(), edited.features.size(), cells.boundary.faces.size(), membership, fresh, edit);
}

}  // namespace

int main(int argc, char** argv) try {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 5;
  const std::string only = argc > 2 ? argv[2] : "";
  const auto wanted = [&](const std::string& name) { return name.find(only) != std::string::npos; };
  for (const test::EditCase& c : test::seven_cases())
    if (wanted(c.edit))
      bench(c.edit, test::case_model(c.original),
            apply(test::case_model(c.original), test::case_edit(c.edit)), repeats);
  const ModelSource plate = test::plate_with_grid(256), row = test::row_of_blocks(256),
                    mixed = test::mixed_model(256);
  const std::vector<std::tuple<std::string, ModelSource, ModelSource>> large{
      {"plate256 hole moved", plate, test::with_moved(plate, "f121", 3, 2, 0)},
      {"plate256 pin radius", plate, test::with_parameter(plate, "f120", "radius", 5.5)},
      {"plate256 thicker", plate, test::with_parameter(plate, "plate", "dz", 10.5)},
      {"row256 moved", row, test::with_moved(row, "f100", 1, 0.3, 0.1)},
      {"mixed256 boss", mixed, test::with_parameter(mixed, "p3boss1", "radius", 9.5)},
      {"mixed256 hole", mixed, test::with_parameter(mixed, "p3hole2", "radius", 4.5)},
      {"mixed256 slot", mixed, test::with_moved(mixed, "p9slot1", 1, 0.5, 0)},
  };
  for (const auto& [name, base, edited] : large)
    if (wanted(name)) bench(name, base, edited, repeats);
} catch (const Error& e) {
  std::fprintf(stderr, "%s\n", e.info().message.c_str());
  return 1;
}

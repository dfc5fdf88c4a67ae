#include "tests/bench/paper_figures.h"

#include <array>

namespace remeshd::bench {
namespace {

struct Row {
  std::string_view edit;
  std::array<double, 4> percent;  ///< 15k with 5 and 10 iterations, 30k with 5 and 10
};

constexpr std::array<Row, 6> kTable3{{{"simple-ab", {10.62, 10.02, 7.51, 7.18}},
                                      {"tool1-ab", {19.25, 12.18, 11.56, 8.38}},
                                      {"tool1-ac", {23.02, 17.98, 15.95, 13.30}},
                                      {"tool2-ab", {39.54, 29.48, 31.95, 23.11}},
                                      {"tool2-bc", {42.77, 31.75, 29.93, 21.37}},
                                      {"tool3-ab", {43.26, 43.80, 30.55, 27.59}}}};

}  // namespace

std::optional<double> paper_ratio(std::string_view edit, std::uint32_t nodes,
                                  std::uint32_t iterations) {
  if ((nodes != 15000 && nodes != 30000) || (iterations != 5 && iterations != 10)) return {};
  for (const Row& row : kTable3)
    if (row.edit == edit)
      return row.percent[(nodes == 30000 ? 2 : 0) + (iterations == 10 ? 1 : 0)] / 100;
  return {};
}

}  // namespace remeshd::bench

#include "tests/campaign/parts/drawn_part.h"

#include <array>

#include "engine/cellular/cellular_model.h"
#include "engine/nodes/density.h"
#include "tests/campaign/parts/details.h"
#include "tests/support/cases.h"

namespace remeshd::campaign {
namespace {

std::vector<Sheet> add_plate(PartDraft& d) {
  const double dy = d.random.uniform(50, 90), dz = d.random.uniform(5, 12);
  d.model.features = {test::block("plate", 100, dy, dz)};
  return {{.frame = Transform::translation({0, 0, dz}),
           .half_x = 50,
           .half_y = 0.5 * dy,
           .depth = dz,
           .through = true}};
}

/// Details on top reach less deep than those that enter from the front below them.
std::vector<Sheet> add_block(PartDraft& d) {
  const double dx = d.random.uniform(50, 80), dy = d.random.uniform(40, 60),
               dz = d.random.uniform(30, 50);
  d.model.features = {test::block("block", dx, dy, dz)};
  const double low = 0.5 * dz;
  return {{.frame = Transform::translation({0, 0, dz}),
           .half_x = 0.5 * dx,
           .half_y = 0.5 * dy,
           .depth = 0.45 * dz},
          {.frame = Transform::frame({1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, -0.5 * dy, 0.5 * low}),
           .half_x = 0.5 * dx,
           .half_y = 0.5 * low,
           .depth = dy,
           .through = true}};
}

std::vector<Sheet> add_disc(PartDraft& d) {
  const double radius = d.random.uniform(40, 60), height = d.random.uniform(8, 16);
  d.model.features = {test::cylinder("disc", radius, height)};
  return {{.frame = Transform::translation({0, 0, height}),
           .radius = radius,
           .depth = height,
           .through = true}};
}

std::vector<Sheet> add_flange(PartDraft& d) {
  std::vector<Sheet> sheets = add_disc(d);
  Sheet& sheet = sheets.front();
  sheet.inner = sheet.radius * d.random.uniform(0.25, 0.45);
  const double top = sheet.depth + d.random.uniform(15, 40);
  d.model.features.push_back(test::cylinder("hub", sheet.inner, top));
  d.model.features.push_back(
      test::placed(test::cylinder("bore", sheet.inner * d.random.uniform(0.5, 0.75), top + 4), 0, 0,
                   -2, Nature::Subtractive));
  return sheets;
}

void add_some(PartDraft& d, std::vector<Sheet>& sheets, Scale scale, std::uint64_t most) {
  for (std::uint64_t n = 1 + d.random.below(most); n > 0; --n)
    add_detail(d, sheets[d.random.below(sheets.size())], scale);
}

}  // namespace

DrawnPart draw_part(std::uint64_t seed, double nodes) {
  struct Body {
    const char* name;
    std::vector<Sheet> (*add)(PartDraft&);
  };
  static constexpr std::array<Body, 4> kBodies{
      {{"plate", add_plate}, {"block", add_block}, {"disc", add_disc}, {"flange", add_flange}}};
  PartDraft d(seed);
  const Body& body = kBodies[d.random.below(kBodies.size())];
  d.model.name = body.name;
  d.model.unit = "mm";
  std::vector<Sheet> sheets = body.add(d);
  const CellularModel cells = build_cells(evaluate(d.model), Run{});
  d.length = edge_length_for(cells.volume, cells.area, nodes);
  // The larger find no room among the smaller.
  add_some(d, sheets, Scale::Part, 4);
  add_some(d, sheets, Scale::Edge, 4);
  add_some(d, sheets, Scale::Fine, 4);
  return {body.name, std::move(d.model)};
}

}  // namespace remeshd::campaign

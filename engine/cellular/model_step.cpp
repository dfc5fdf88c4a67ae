#include "engine/cellular/model_step.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/tolerance.h"
#include "engine/cellular/boundary_model/build_boundary.h"
#include "engine/cellular/boundary_model/group_rims.h"
#include "engine/cellular/fuse_features.h"
#include "engine/kernel/step/step_file.h"
#include "engine/model/solid.h"

namespace remeshd {
namespace {

kernel::LengthUnit length_unit(std::string_view label) {
  struct Known {
    std::string_view label;
    kernel::LengthUnit unit;
  };
  static constexpr std::array kKnown{
      Known{"mm", {"MM", 1}},     Known{"cm", {"CM", 10}},     Known{"m", {"M", 1000}},
      Known{"um", {"UM", 0.001}}, Known{"in", {"INCH", 25.4}}, Known{"inch", {"INCH", 25.4}},
      Known{"ft", {"FT", 304.8}},
  };
  for (const Known& known : kKnown)
    if (label == known.label) return known.unit;
  return {};
}

std::string joined_name(const FeatureModel& model, const std::vector<FaceName>& names) {
  std::string out;
  for (const FaceName& name : names)
    out += (out.empty() ? "" : "+") + model.features[name.feature].id + "." + name.face;
  return out;
}

kernel::Skin skin_of(const FeatureModel& model, const FusedFeatures& fused) {
  const std::vector<BoundaryPiece>& pieces = fused.pieces;
  const UnifiedEdges unified = unified_edges_of(*fused.cells.brep, pieces, model);
  kernel::Skin skin;
  std::vector<std::vector<const BoundaryPiece*>> wholes(unified.groups);
  for (std::size_t f = 0; f < pieces.size(); ++f) {
    if (!pieces[f].boundary) continue;
    skin.faces.push_back({static_cast<int>(f), pieces[f].outward, unified.face_group[f]});
    wholes[unified.face_group[f]].push_back(&pieces[f]);
  }
  for (const auto& whole : wholes) skin.names.push_back(joined_name(model, ordered_names(whole)));
  for (std::size_t e = 0; e < unified.edge.size(); ++e)
    if (unified.edge[e]) skin.edges.push_back(static_cast<int>(e));
  for (std::size_t v = 0; v < unified.vertex.size(); ++v)
    if (unified.vertex[v]) skin.vertices.push_back(static_cast<int>(v));
  return skin;
}

bool same(double a, double b) { return std::fabs(a - b) <= tolerance::kSameMeasure * std::fabs(b); }

/// Throws Error(KERNEL_FAILURE).
void check_content(const kernel::StepContent& content, const CellularModel& cells) {
  const auto refuse = [](const char* what, double got, double expected) {
    std::array<char, 100> text{};
    std::snprintf(text.data(), text.size(), "%s %.9g, not %.9g", what, got, expected);
    return error::kernel_failure("the STEP file reads back with " + std::string(text.data()));
  };
  if (content.solids != 1) throw refuse("solids", content.solids, 1);
  if (!same(content.volume, cells.volume)) throw refuse("volume", content.volume, cells.volume);
  if (!same(content.area, cells.area)) throw refuse("area", content.area, cells.area);
}

}  // namespace

std::string model_step(const FeatureModel& model, const CellularModel& cells,
                       const ModelLabels& labels, const Run& run) {
  const Membership membership(model);
  const kernel::StepLabels told{.file = labels.file,
                                .description = labels.description,
                                .origin = labels.origin,
                                .solid = labels.name,
                                .unit = length_unit(labels.unit)};
  std::string out;
  fuse_features(model, membership, fuse_frame(membership), run, [&](const FusedFeatures& fused) {
    const kernel::Brep& brep = *fused.cells.brep;
    std::string text = kernel::write_step(brep, skin_of(model, fused), told, run);
    check_content(kernel::read_step(text, told.unit, brep.scale, run), cells);
    out = std::move(text);
  });
  return out;
}

}  // namespace remeshd

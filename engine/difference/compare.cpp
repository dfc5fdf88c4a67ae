#include "engine/difference/compare.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/tolerance.h"
#include "engine/difference/combined_model.h"
#include "engine/difference/feature_difference.h"
#include "engine/difference/line_volumes.h"
#include "engine/difference/point_areas.h"

namespace remeshd {
namespace {

struct ComparisonLimits {
  double brep_motion = 1e-2;  ///< kernel units; measured: right at 1e-2, wrong at 1e-4
  double brep_error = 1e-7;   ///< of the larger model's volume
  int check_lines = 1024;     ///< a lost or doubled cell shows in a few hundred
  int measure_lines = 65536, area_samples = 20000;
};
constexpr ComparisonLimits kComparisonLimits;

using NameOf = std::string_view (*)(DifferenceClass);

/// Classes above `least`; Artefact is no class.
std::map<std::string, double> named(const ClassTotals& totals, NameOf name_of, double least) {
  std::map<std::string, double> out;
  for (const DifferenceClass c : kAllClasses)
    if (totals[c] > least && c != DifferenceClass::Artefact) out.emplace(name_of(c), totals[c]);
  return out;
}

struct Volumes {
  std::vector<ClassTotals> features;
  double copycells = 0, newcells = 0;
};

/// Whether every volume of the overlay lies within twice the error bound of the membership
/// estimate.
bool agree(const Volumes& brep, const VolumeEstimate& estimate, double rounding) {
  const auto near = [&](double a, double b, double error) {
    return std::fabs(a - b) <= 2 * error + rounding;
  };
  for (std::size_t f = 0; f < brep.features.size(); ++f)
    for (const DifferenceClass c : kAllClasses)
      if (c != DifferenceClass::Artefact &&
          !near(brep.features[f][c], estimate.features[f][c], estimate.feature_errors[f][c]))
        return false;
  return near(brep.copycells, estimate.copycells, estimate.copycells_error) &&
         near(brep.newcells, estimate.newcells, estimate.newcells_error);
}

/// The comparison by B-rep overlay; none, with the reason in `remark`, where the kernel fails or
/// its volumes disagree with membership.
std::optional<ModelComparison> by_brep(const PointClasses& classes, const ModelView& original,
                                       const ModelView& modified, const Run& run,
                                       std::string& remark) {
  const double volume = std::max(original.cells->volume, modified.cells->volume);
  ModelComparison out;
  Volumes volumes;
  try {
    for (const FeatureDifference& difference : difference_model(original, modified, run)) {
      volumes.features.push_back(difference.cell_volumes);
      const double rounding = tolerance::kRounding * volume;
      out.features.push_back({difference.id,
                              named(difference.cell_volumes, cell_class_name, rounding),
                              named(difference.face_areas, geometry_class_name, 0),
                              named(difference.edge_lengths, geometry_class_name, 0),
                              named(difference.vertex_counts, geometry_class_name, 0)});
    }
    const CombinedModel combined = combined_modified_model(original, modified, run);
    out.copycells = volumes.copycells = combined.copycell_volume;
    out.newcells = volumes.newcells = combined.newcell_volume;
  } catch (const Error& failure) {
    if (failure.info().kind == ErrorKind::Cancelled) throw;
    remark = failure.info().message;
    return std::nullopt;
  }
  if (!agree(volumes, estimate_volumes(classes, {kComparisonLimits.check_lines, 1}, run),
             kComparisonLimits.brep_error * volume)) {
    remark = "the overlay's volumes disagree with membership";
    return std::nullopt;
  }
  out.method = "brep";
  out.error_bound = kComparisonLimits.brep_error * volume;
  return out;
}

/// Volume of a feature's cells of one nature in one model, exact.
double owned_volume(const CellComplex& cells, int feature, bool positive) {
  double volume = 0;
  for (const Cell& cell : cells.cells)
    if (cell.positive == positive && std::ranges::binary_search(cell.owners, feature))
      volume += cell.volume;
  return volume;
}

/// Replaces estimates by what follows from the cells' exact volumes: all of a feature that only one
/// model has; of others what stayed the same, as the whole less what changed. So the error is as
/// small as the change.
void balance(ClassTotals& totals, ClassTotals& errors, const FeaturePair& pair,
             const CellComplex& original, const CellComplex& modified) {
  using enum DifferenceClass;
  if (pair.original < 0) {
    totals[NewYes] = owned_volume(modified, pair.modified, true);
    totals[NewNo] = owned_volume(modified, pair.modified, false);
    errors = {};
  } else if (pair.modified < 0) {
    totals[OldYes] = owned_volume(original, pair.original, true);
    totals[OldNo] = owned_volume(original, pair.original, false);
    errors = {};
  } else {
    totals[IdenticalYes] =
        owned_volume(original, pair.original, true) - totals[ToNo] - totals[OldYes];
    totals[IdenticalNo] =
        owned_volume(original, pair.original, false) - totals[ToYes] - totals[OldNo];
  }
}

ModelComparison by_membership(const PointClasses& classes, const ModelView& original,
                              const ModelView& modified, const Run& run) {
  using enum DifferenceClass;
  VolumeEstimate estimate = estimate_volumes(classes, {kComparisonLimits.measure_lines, 1}, run);
  const std::vector<ClassTotals> areas =
      estimate_areas(classes, original, modified, kComparisonLimits.area_samples, run);
  const double diagonal = classes.modified().bounds().diagonal();
  const double rounding = tolerance::kRounding * diagonal * diagonal * diagonal;

  ModelComparison out;
  out.method = "membership";
  out.newcells = estimate.newcells > rounding ? estimate.newcells : 0;
  out.copycells = modified.cells->volume - out.newcells;
  out.error_bound = estimate.newcells_error + rounding;
  for (std::size_t f = 0; f < classes.features().size(); ++f) {
    const FeaturePair& pair = classes.features()[f];
    ClassTotals& totals = estimate.features[f];
    ClassTotals& errors = estimate.feature_errors[f];
    balance(totals, errors, pair, original.cells->complex(run), modified.cells->complex(run));
    double changed = 0;
    for (const DifferenceClass c : {ToNo, ToYes, NewYes, NewNo, OldYes, OldNo})
      changed += errors[c];
    out.error_bound = std::max(out.error_bound, changed + rounding);
    out.features.push_back({pair.id,
                            named(totals, cell_class_name, rounding),
                            named(areas[f], geometry_class_name, 0),
                            {},
                            {}});
  }
  return out;
}

}  // namespace

ModelComparison compare(const FeatureModel& original, const FeatureModel& modified,
                        const CellularModel* original_cells, const CellularModel* modified_cells,
                        const Run& run) {
  std::optional<CellularModel> built_original, built_modified;
  if (original_cells == nullptr)
    original_cells = &built_original.emplace(build_cells(original, run));
  if (modified_cells == nullptr)
    modified_cells = &built_modified.emplace(build_cells(modified, run));
  const ModelView original_view{&original, original_cells};
  const ModelView modified_view{&modified, modified_cells};
  const PointClasses classes(original, modified);

  std::string remark;
  const double motion = smallest_motion(original, modified) * modified_cells->scale;
  if (motion < kComparisonLimits.brep_motion) {
    remark = "features moved by less than the overlay resolves";
  } else if (auto answer = by_brep(classes, original_view, modified_view, run, remark)) {
    return *std::move(answer);
  }
  ModelComparison out = by_membership(classes, original_view, modified_view, run);
  out.remark = remark;
  return out;
}

}  // namespace remeshd

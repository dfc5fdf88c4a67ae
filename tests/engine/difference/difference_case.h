#pragma once

#include <ostream>
#include <string>

#include "engine/difference/combined_model.h"
#include "engine/difference/feature_difference.h"
#include "tests/support/cases.h"

namespace remeshd::test {

/// The two models of an edit case with their cells: `fig6-ab`, `tool1-ac`.
struct DifferenceCase {
  FeatureModel original, modified;
  CellularModel original_cells, modified_cells;

  explicit DifferenceCase(const std::string& edit)
      : DifferenceCase(case_model(edit.substr(0, edit.size() - 1)), case_edit(edit)) {}
  DifferenceCase(const ModelSource& source, const ModelEdit& edit)
      : original(evaluate(source)),
        modified(evaluate(apply(source, edit))),
        original_cells(build_cells(original, {})),
        modified_cells(build_cells(modified, {})) {}

  [[nodiscard]] ModelView before() const { return {&original, &original_cells}; }
  [[nodiscard]] ModelView after() const { return {&modified, &modified_cells}; }
  [[nodiscard]] FeatureDifference of(const std::string& feature) const {
    return feature_difference(feature, before(), after(), {});
  }
};

/// `++ 32000 +- 8000`, rounded to 1e-2: what a README of cases says and a failure shows.
inline std::string text(const ClassTotals& totals, std::string_view (*name)(DifferenceClass)) {
  std::string out;
  for (const DifferenceClass c : kAllClasses) {
    const double value = std::round(totals[c] * 100) / 100;
    if (value == 0) continue;
    std::string number = std::to_string(value);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    out += (out.empty() ? "" : " ") + std::string(name(c)) + " " + number;
  }
  return out;
}
inline std::string cells(const FeatureDifference& d) {
  return text(d.cell_volumes, cell_class_name);
}
inline std::string faces(const FeatureDifference& d) {
  return text(d.face_areas, geometry_class_name);
}
inline std::string edges(const FeatureDifference& d) {
  return text(d.edge_lengths, geometry_class_name);
}
inline std::string vertices(const FeatureDifference& d) {
  return text(d.vertex_counts, geometry_class_name);
}

}  // namespace remeshd::test

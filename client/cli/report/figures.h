#pragma once

#include <array>
#include <nlohmann/json.hpp>

#include "client/cli/report/content.h"
#include "client/cli/report/correspondence.h"
#include "client/cli/report/tet_figures.h"

namespace remeshd::cli {

/// The middle of the box round both meshes: the page's coordinates, single floats, count from
/// there.
std::array<double, 3> centre_of(const ReportContent& content);

/// All of the report but the arrays: `changes` in words, `descent`, counts of nodes and tets by
/// state, and `base` (null where there is none) and `modified` with name, Report, groups, cells,
/// histograms and the worst tets of each.
nlohmann::ordered_json report_figures(const ReportContent& content,
                                      const Correspondence& correspondence, const MeshFigures* base,
                                      const MeshFigures& modified);

}  // namespace remeshd::cli

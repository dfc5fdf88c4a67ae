#include "client/cli/report/figures.h"

#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <limits>

#include "client/cli/model_changes.h"
#include "client/cli/reply.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* descent_name(Descent descent) {
  switch (descent) {
    case Descent::Parent:
      return "parent";
    case Descent::Ancestor:
      return "ancestor";
    case Descent::None:
      return "none";
  }
  return "none";
}

Json counts_of(const StateCounts& counts) {
  return {
      {"kept", counts.kept}, {"moved", counts.moved}, {"new", counts.added}, {"gone", counts.gone}};
}

Json worst_of(const client::Mesh& mesh, const std::vector<TetState>& states,
              const TetFigures& figures) {
  const auto tet = static_cast<std::size_t>(figures.tet);
  Json corners = Json::array();
  for (const std::int32_t node : mesh.tets[tet])
    corners.push_back(mesh.nodes[static_cast<std::size_t>(node)]);
  return {{"tet", figures.tet},
          {"id", mesh.tet_ids[tet]},
          {"quality", figures.volume_length},
          {"least_angle", figures.least_angle},
          {"largest_angle", figures.largest_angle},
          {"cell", mesh.tet_cell[tet]},
          {"state", static_cast<int>(states[tet])},
          {"corners", std::move(corners)}};
}

Json mesh_json(const ReportSide& side, const MeshFigures& figures,
               const std::vector<TetState>& states) {
  Json worst = Json::array();
  for (const TetFigures& tet : figures.worst) worst.push_back(worst_of(side.mesh, states, tet));
  return {{"nodes", side.mesh.nodes.size()},
          {"tets", side.mesh.tets.size()},
          {"facets", side.mesh.facets.size()},
          {"qualities", figures.qualities},
          {"angles", figures.angles},
          {"face_groups", side.mesh.facet_groups},
          {"cell_owners", side.mesh.cell_owners},
          {"worst", std::move(worst)}};
}

Json side_json(const ReportSide& side, const MeshFigures& figures,
               const std::vector<TetState>& states) {
  const auto& revision = side.about.revision();
  Json features = Json::array();
  for (const auto& feature : side.about.model().features()) features.push_back(feature.id());
  Json json{{"name", short_name(revision)},
            {"id", revision.id()},
            {"parent", revision.parent()},
            {"model", side.about.model().name()},
            {"unit", side.about.model().unit()},
            {"created", google::protobuf::util::TimeUtil::ToString(revision.created())},
            {"features", std::move(features)},
            {"mesh", mesh_json(side, figures, states)}};
  // There is no Report where the mesh had gone when the revision was looked up.
  json["report"] =
      side.about.has_report() ? Json::parse(write_json(side.about.report())) : Json(nullptr);
  if (side.about.has_report()) json["way"] = way_name(side.about.report().way());
  return json;
}

}  // namespace

std::array<double, 3> centre_of(const ReportContent& content) {
  constexpr double kHuge = std::numeric_limits<double>::max();
  std::array<double, 3> low{kHuge, kHuge, kHuge}, high{-kHuge, -kHuge, -kHuge}, centre{};
  const auto enclose = [&](const client::Mesh& mesh) {
    for (const auto& node : mesh.nodes)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], node[k]);
        high[k] = std::max(high[k], node[k]);
      }
  };
  if (content.base) enclose(content.base->mesh);
  enclose(content.modified.mesh);
  for (std::size_t k = 0; k < 3; ++k) centre[k] = low[k] <= high[k] ? (low[k] + high[k]) / 2 : 0;
  return centre;
}

nlohmann::ordered_json report_figures(const ReportContent& content,
                                      const Correspondence& correspondence, const MeshFigures* base,
                                      const MeshFigures& modified) {
  Json json{
      {"descent", descent_name(content.descent)},
      {"surfaces_only", has_surfaces_only(content)},
      {"most_tets_inside", kMostTetsInside},
      {"centre", centre_of(content)},
      {"counts",
       {{"nodes", counts_of(correspondence.nodes)}, {"tets", counts_of(correspondence.tets)}}},
      {"changes", nullptr},
      {"base", nullptr}};
  if (content.base) {
    json["changes"] = model_changes(content.base->about.model(), content.modified.about.model());
    json["base"] = side_json(*content.base, *base, correspondence.base);
  }
  json["modified"] = side_json(content.modified, modified, correspondence.modified);
  return json;
}

}  // namespace remeshd::cli

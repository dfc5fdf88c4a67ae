#pragma once

#include <optional>

#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"

namespace remeshd::cli {

/// A revision, all that the daemon tells of it and its mesh.
struct ReportSide {
  remesh::v1::GetRevisionResponse about;
  client::Mesh mesh;
};

/// How one revision came from another.
enum class Descent {
  None,      ///< not along one chain of edits: nodes and tets cannot be compared
  Parent,    ///< by one edit: the mesh has the maps
  Ancestor,  ///< by several: permanent ids tell what is the same
};

/// What a report is about.
struct ReportContent {
  std::optional<ReportSide> base;  ///< none: the page is about one mesh
  ReportSide modified;
  Descent descent = Descent::None;
  bool surfaces_only = false;  ///< leaves the interior of the meshes out
};

/// Tets of one mesh up to which its interior goes into the page.
inline constexpr std::size_t kMostTetsInside = 300'000;

/// Whether the page has boundary facets and the worst tets alone: where that is asked for, or one
/// of the meshes is too large for a browser.
bool has_surfaces_only(const ReportContent& content);

}  // namespace remeshd::cli

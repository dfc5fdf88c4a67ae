#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/remesh/remesh.h"
#include "server/session/mesh_arrays.h"
#include "server/store/records.h"

namespace remeshd {

/// A revision in memory with what is known of it. In its report `revision` is its id, `cached`
/// false.
struct HeldRevision {
  RevisionRecord record;
  Revision revision;
  /// The document of the edit that made it of its parent; empty for a first mesh, and where it was
  /// stored without one.
  std::string edit;
  /// The options that it was made with, for its recipe; nothing where it was read from the store,
  /// which has the recipe.
  std::optional<MeshOptions> asked;

  MeshDigests digests;  ///< worked out when first asked for, and kept
};
using HeldRevisionPtr = std::shared_ptr<const HeldRevision>;

}  // namespace remeshd

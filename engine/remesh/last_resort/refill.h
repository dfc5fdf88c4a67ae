#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/patch/reuse_improved_tets.h"
#include "engine/patch/stitch.h"
#include "engine/sizing/size_field.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// A mesh that is wrong at some places. Keeps references.
struct FaultyMesh {
  const StitchedMesh& whole;
  const Verification& verification;
  const TetMesh& patch;          ///< what of it may be made anew
  std::span<const Vec3> places;  ///< where it is wrong
  /// Where earlier refills were wrong: the boundary gets smaller facets there.
  std::span<const Vec3> wrong_again;
};

/// The patch with the tets round the faulty places replaced.
struct RefilledMesh {
  TetMesh mesh;                   ///< the patch's nodes, then new ones
  std::vector<Support> supports;  ///< of the new nodes
  std::vector<std::int32_t> was;  ///< by tet: that of the patch, -1 for new ones
};

/// The local last resort: takes out the tets within `margin` (x edge length) of what is wrong,
/// covers the faces of the model that lie open then (`cover_open_faces`) and has TetGen fill what
/// the cover and the tets that stay enclose, without points added on this shell.
///
/// Returns why that could not be done where it could not: a tet that would have to go is not the
/// patch's, a face could not be covered, TetGen refused the shell or crashed. Throws what else
/// run_tetgen throws: Cancelled, Error(TETGEN_MISSING, TETGEN_TOO_SLOW, TETGEN_OUT_OF_MEMORY).
std::variant<RefilledMesh, std::string> refill(const FaultyMesh& faulty,
                                               const BoundaryModel& boundary,
                                               const SizeField& sizes, double margin,
                                               const Run& run);

/// Whether nothing is wrong but some tets, which clean-up may do away with.
bool only_tets_are_wrong(const Verification& verification);

/// By tet of a valid mesh that was refilled: 1 where it is new, or was dirty before, and does not
/// lie across a film, where every tet is flat.
/// @param was           by tet: that of the mesh before, -1 for new ones
/// @param thinner_than  length: a wall below this is a film
std::vector<std::uint8_t> worth_improving(const TetMesh& made, std::span<const std::int32_t> was,
                                          const ReusedMesh& before,
                                          std::span<const Support> supports,
                                          const BoundaryModel& boundary, double thinner_than);

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/motion/feature_surfaces.h"
#include "engine/motion/mesh_spread.h"
#include "engine/motion/parameter_change.h"
#include "engine/motion/velocities.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// The faces of a model's features at both ends of a change.
class ChangingFaces;

/// Design velocities of a mesh: d x / d p at its nodes, at fixed connectivity. On the boundary they
/// follow from the closed forms of the features: a node stays on its faces and edges to first
/// order. From there they are spread as the motion of a held mesh is (`MeshSpread`), for the
/// connectivity is that which a `hold` keeps.
class DesignVelocities {
 public:
  /// Keeps a reference.
  DesignVelocities(const Revision& revision, const Run& run);

  /// Forward. `parameter`: as `parameter_value`; throws what `change_of` throws.
  [[nodiscard]] NodalVelocities of(const std::string& parameter, const Run& run) const;

  /// Reverse mode: d J / d p of a function J of the nodes, in the order of `parameters`. Successive
  /// parameters for which all nodes have the same freedoms share one linear solve.
  /// `seed`: d J / d x, by corner node, then by mid-node. Pre: it has one for each.
  /// Throws what `change_of` throws.
  [[nodiscard]] std::vector<DesignDerivative> gradient(std::span<const Vec3> seed,
                                                       std::span<const std::string> parameters,
                                                       const Run& run) const;

 private:
  struct Motions {
    std::vector<NodeMotion> nodes;        ///< corner nodes
    std::vector<FollowingMotion> mids;    ///< as `mids_`; each follows the middle of its edge
    std::vector<std::uint8_t> undefined;  ///< as NodalVelocities::undefined

    /// Whether all nodes have the same freedoms as in `other`.
    [[nodiscard]] bool is_free_as(const Motions& other) const;
  };
  /// A mid-node off the middle of its edge, and the surfaces that it is on.
  struct CurvedMid {
    std::int32_t mid;
    std::vector<FeatureSurfaces::Ref> on;
  };

  [[nodiscard]] Motions motions(const ParameterChange& change) const;
  /// d J / d required, by corner node, with the freedoms of the motions. `seed`: d J / d place.
  [[nodiscard]] std::vector<Vec3> of_required(const Motions& motions, std::span<const Vec3> seed,
                                              const Run& run) const;
  [[nodiscard]] FollowingMotion mid_motion(const CurvedMid& mid, const NodeMotion& on_faces,
                                           const ChangingFaces& faces) const;
  [[nodiscard]] CommonMotion apex_motion(const Vec3& p, const ChangingFaces& faces) const;
  void find_curved_mids();

  const Revision& revision_;
  FeatureSurfaces surfaces_;
  FacesOfModel faces_;
  MeshSpread spread_;
  std::vector<CurvedMid> mids_;
};

}  // namespace remeshd

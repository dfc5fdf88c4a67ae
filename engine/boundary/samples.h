#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/region.h"
#include "engine/base/run.h"
#include "engine/cellular/boundary_model/support.h"
#include "engine/model/solid.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// A quadrature sample (Sect. 3.1): a point of the boundary that pulls its nearest node with the
/// area or length that it stands for.
struct Sample {
  Vec3 position;
  double weight = 0;  ///< area on faces, length on edges, 1 at vertices
  Support support;    ///< the face, edge or vertex it lies on
};

struct SampleOptions {
  double face_spacing = 0.36;  ///< of the target edge length: about seven samples a boundary node
  double edge_spacing = 0.18;  ///< of the target edge length
  double jitter =
      0.2;  ///< of the spacing; lattice-aligned samples lock nodes into cocircular places
  /// Only samples in one of these are wanted; nothing: all.
  std::optional<std::vector<Region>> where;
};

/// The samples of all faces, then of all edges, then of all vertices.
struct Samples {
  std::vector<Sample> points;
  std::size_t edges_begin = 0;
  std::size_t vertices_begin = 0;

  [[nodiscard]] std::vector<Vec3> positions() const;
};

/// Covers the boundary with samples: a jittered lattice on every face, evenly spaced jittered
/// points along every edge, every vertex. The lattice of a face is trimmed by point membership, so
/// it is as exact as the features are.
///
/// Post: the weights of a face's samples add up to its area, those of an edge's to its length,
/// where the whole boundary is covered. Source: Sect. 3.1 and 3.3.
Samples sample_boundary(const BoundaryModel& boundary, const Membership& membership,
                        const SizeField& sizes, std::uint64_t seed, const SampleOptions& options,
                        const Run& run);

}  // namespace remeshd

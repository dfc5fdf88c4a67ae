#pragma once

namespace remeshd {

/// Nodes that a mesh of regular tets of this edge length has: sqrt(2) V / l^3 in the volume and
/// A / (sqrt(3) l^2) for the half cells at the boundary.
double expected_nodes(double volume, double area, double edge_length);

/// What there is to be meshed.
struct Extent {
  double volume = 0;
  double area = 0;    ///< of the boundary
  double length = 0;  ///< sum over the boundary's edges, or of its faces' diagonals if greater
};

/// Nodes that a mesh of this edge length cannot do without: the greater of `expected_nodes` and
/// `Extent::length` over the edge length, which counts where a model is so thin that its volume and
/// area come to nothing. A limit on this number limits all that is made for the mesh: nodes,
/// samples, tets.
double nodes_needed(const Extent& extent, double edge_length);

/// The edge length for which `expected_nodes` is `nodes`, to 12 digits.
double edge_length_for(double volume, double area, double nodes);

}  // namespace remeshd

#pragma once

namespace remeshd {

/// Nodes that a mesh of regular tets of this edge length has: sqrt(2) V / l^3 in the volume and
/// A / (sqrt(3) l^2) for the half cells at the boundary.
double expected_nodes(double volume, double area, double edge_length);

/// The edge length for which `expected_nodes` is `nodes`, to 12 digits.
double edge_length_for(double volume, double area, double nodes);

}  // namespace remeshd

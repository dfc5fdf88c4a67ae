#pragma once

#include <array>
#include <span>

#include "engine/kernel/brep.h"

namespace remeshd::kernel {

/// One side of a closed profile: a segment or a circular arc.
struct ProfileCurve {
  std::array<double, 2> from{}, to{};
  bool arc = false;
  std::array<double, 2> centre{};
  double radius = 0;
  bool counter_clockwise = true;
  std::string label;  ///< of the face that it sweeps
};

// Solids of one cell in their local frames, with labelled faces; lengths in the model's unit,
// `scale` from unit_scale. Each throws Error(KERNEL_FAILURE) where the CAD kernel cannot build it.

/// Profile in xy, extruded along z; faces by the sides' labels, `bottom`, `top`.
Brep make_prism(std::span<const ProfileCurve> profile, double height, double scale);
/// Profile in the xz half-plane (its second coordinate is z), turned about z by `angle` rad from
/// the half-plane on; faces by the sides' labels, `start`, `end` (where angle < 2 pi). A side on
/// the axis sweeps no face.
Brep make_revolution(std::span<const ProfileCurve> profile, double angle, double scale);
/// Length up to which the kernel makes no edge.
double shortest_edge(double scale);
/// Along +z from 0; faces `wall`, `bottom`, `top`. Equal radii give a cylinder, one may be 0.
Brep make_cone(double radius_bottom, double radius_top, double height, double scale);
/// Face `surface`.
Brep make_sphere(double radius, double scale);
/// Axis z, face `surface`.
Brep make_torus(double major_radius, double minor_radius, double scale);

}  // namespace remeshd::kernel

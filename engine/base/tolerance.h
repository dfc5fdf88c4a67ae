#pragma once

/// How near is the same, by what is asked. The CAD kernel's own is `kernel_tolerance`.
namespace remeshd::tolerance {

/// A node this near to a surface stands on it, x the model's diagonal: far more than projections
/// are off, far less than anything meshed is wide.
inline constexpr double kOnSurface = 1e-7;
/// From a surface to where one looks on which side there is material, x the model's diagonal.
inline constexpr double kProbe = 1e-9;
/// The same where the CAD kernel made the surface, or several meet in a curve.
inline constexpr double kWideProbe = 1e-7;
/// Directions that differ by no more are the same: rad, or the sine.
inline constexpr double kSameDirection = 1e-9;
/// Exact areas and volumes of the same shape differ by no more, relative.
inline constexpr double kSameMeasure = 1e-6;
/// An edge that bends by less is straight, x its length.
inline constexpr double kStraight = 1e-10;
/// A motion by less need not be in a mesh that is made anew beside it, x the model's diagonal: steps
/// and slits that narrow hold no tets of any shape.
inline constexpr double kTinyMotion = 5e-7;
/// What rounding alone may do to a number, relative.
inline constexpr double kRounding = 1e-12;

}  // namespace remeshd::tolerance

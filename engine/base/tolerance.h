#pragma once

/// Tolerances, each for one question. `kernel_tolerance` is that for results of the CAD kernel.
namespace remeshd::tolerance {

/// A node this near to a surface stands on it, x the model's diagonal: far above the error of
/// projections, far below the width of anything that is meshed.
inline constexpr double kOnSurface = 1e-7;
/// How far from a surface points are tested to find on which side the material is, x the model's
/// diagonal.
inline constexpr double kProbe = 1e-9;
/// The same where the CAD kernel made the surface, or several surfaces meet in a curve.
inline constexpr double kWideProbe = 1e-7;
/// Directions that differ by no more are the same: rad, or the sine.
inline constexpr double kSameDirection = 1e-9;
/// Exact areas and volumes of the same shape differ by no more, relative.
inline constexpr double kSameMeasure = 1e-6;
/// An edge whose middle is off its chord by less is straight, x the length of the chord.
inline constexpr double kStraight = 1e-10;
/// A feature that moved by no more may be meshed at its old place, x the model's diagonal. Such a
/// motion leaves steps and slits beside other features, and these are too narrow for usable tets.
inline constexpr double kTinyMotion = 5e-7;
/// What rounding alone may do to a number, relative.
inline constexpr double kRounding = 1e-12;

}  // namespace remeshd::tolerance

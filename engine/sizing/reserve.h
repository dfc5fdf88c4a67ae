#pragma once

namespace remeshd {

/// Edges come out longer than the field, most of all on a face from which it grows, for the fewer
/// nodes behind are pulled onto that; and they come out unevenly long. So the field has lengths
/// that are by these factors shorter than what is wanted.
inline constexpr double kReserve = 1.2;  ///< circles: none has fewer edges than asked for
/// The model's sizes: its edges are as long as asked for on average.
inline constexpr double kReserveOnFaces = 1.3, kReserveInside = 1.1;

}  // namespace remeshd

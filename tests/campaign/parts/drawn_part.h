#pragma once

#include <string>

#include "engine/model/source.h"

namespace remeshd::campaign {

/// A part made at random: a plate, block, disc or flange with details at three scales, drawn so
/// that they stand apart from each other and from the body's rim.
struct DrawnPart {
  std::string body;  ///< `plate`, `block`, `disc` or `flange`
  ModelSource model;
};

/// `nodes`: of the first mesh, whose edge length the smaller details go by. The same for the same
/// seed. The CAD kernel has not seen it yet.
///
/// Throws what `build_cells` throws of the body.
DrawnPart draw_part(std::uint64_t seed, double nodes);

}  // namespace remeshd::campaign

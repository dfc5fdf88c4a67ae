#pragma once

namespace remeshd::cli {

/// Whether a line can be drawn again in place: on a terminal whose kind is known and not `dumb`.
///
/// `kind`: what the environment says as TERM; null where it says nothing.
bool can_draw(int descriptor, const char* kind);

}  // namespace remeshd::cli

#pragma once

#include "tests/campaign/draft.h"

namespace remeshd::campaign {

/// Gives an empty draft one to three features that hang together, and the sites on them. All eight
/// feature types serve as a body.
void add_body(Draft& draft);

}  // namespace remeshd::campaign

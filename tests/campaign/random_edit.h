#pragma once

#include <string>

#include "tests/campaign/draft.h"

namespace remeshd::campaign {

struct RandomEdit {
  ModelEdit edit;
  std::string kind;  ///< as in documents: `setParameter`, ...
  double size = 0;   ///< of the change, by the model's diagonal
};

/// An edit of one of the five kinds, of a size from 1e-9 of the model to all of it, applied to the
/// draft. `gentle`: features move along their face and whole sites come and go, which keeps most
/// models good-natured; else troubles come too.
///
/// Throws Error where the result is not valid as a document.
RandomEdit random_edit(Draft& draft, bool gentle);

}  // namespace remeshd::campaign

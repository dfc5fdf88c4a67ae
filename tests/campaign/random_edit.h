#pragma once

#include <array>
#include <string>

#include "tests/campaign/draft.h"

namespace remeshd::campaign {

/// The five kinds of edits, by their names in documents.
inline constexpr std::array<const char*, 5> kEditKinds{
    "setParameter", "setFeatureParameter", "setPlacement", "addFeature", "removeFeature"};

inline constexpr std::size_t kAddFeature = 3;

struct RandomEdit {
  ModelEdit edit;
  std::string kind;  ///< as in documents: `setParameter`, ...
  double size = 0;   ///< of the change, by the model's diagonal
};

/// An edit of the kind, an index into kEditKinds, of a size from 1e-9 of the model to all of it,
/// applied to the draft. `gentle`: features move along their face and whole sites come and go,
/// which keeps most models good-natured; else troubles come too.
///
/// Throws Error where the result is not valid as a document.
RandomEdit random_edit(Draft& draft, std::size_t kind, bool gentle);

}  // namespace remeshd::campaign

#pragma once

#include <string>

#include "engine/base/random.h"
#include "engine/model/source.h"
#include "tests/campaign/parts/sheet.h"

namespace remeshd::campaign {

/// How large a detail is.
enum class Scale {
  Part,  ///< about the part's size: ribs, bosses, pockets, big bores
  Edge,  ///< about an edge length
  Fine,  ///< well below an edge length: pins, drills, chamfers
};

/// A part in the making.
struct PartDraft {
  Random random;
  ModelSource model;
  double length = 0;  ///< the edge length l that the body would have
  int serial = 0;     ///< for ids

  explicit PartDraft(std::uint64_t seed) : random(seed) {}
  bool chance(double probability) { return random.uniform() < probability; }
};

/// Adds a boss, rib, pad, pocket, bore, slot, groove or dimple, some drilled or chamfered, or a row
/// or circle of holes or pins, where the sheet has room for it, and notes what it covers.
///
/// Returns whether it found room.
bool add_detail(PartDraft& draft, Sheet& sheet, Scale scale);

}  // namespace remeshd::campaign

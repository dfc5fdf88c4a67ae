#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "engine/base/error.h"
#include "engine/base/run.h"
#include "engine/model/source.h"
#include "server/session/held_revisions.h"
#include "server/store/records.h"

namespace remeshd {

/// Options as a request gives them: what is left out is taken from the default or the base.
struct OptionsPatch {
  std::optional<std::uint32_t> nodes;
  std::optional<double> size;  ///< model's unit
  std::optional<std::uint32_t> iterations;
  std::optional<std::uint64_t> seed;
  std::optional<MeshOptions::Inside> inside;
  std::optional<MeshOptions::Start> start;
  std::optional<double> threshold;
  std::optional<bool> clean_up;
};

/// Whether the revision made is to become the head of its design.
struct HeadRule {
  bool advance = true;
  /// Id that the head must have for it to move; empty: any, but then only a revision that is new to
  /// the design becomes the head.
  std::string expected;
};

struct CreateCommand {
  ModelSource source;
  OptionsPatch options;
  std::string design;  ///< empty: the model's name, or `model`
  HeadRule head;
  int threads = 1;
};

struct EditCommand {
  std::string base;  ///< as `resolve` takes it
  ModelEdit edit;
  OptionsPatch options;
  std::string design;  ///< empty: the base's
  HeadRule head;       ///< expected: empty means the base
  int threads = 1;
};

/// How a revision was entered in a design.
struct Filed {
  RevisionRecord record;
  PlaceRecord place;
  bool head_moved = false;  ///< the head was another one than expected, and stayed
  std::string head;         ///< id after the request
  std::uint32_t head_number = 0;
};

/// The answer to a command.
struct Made {
  HeldRevisionPtr revision;
  Filed filed;
  bool cached = false;  ///< nothing was computed for this answer
};

/// Hears of a command: any number of progress calls, then exactly one of the others. Called by any
/// thread; must not block.
struct Listener {
  std::function<void(const Progress&)> progress;  ///< may be empty
  std::function<void(const Made&)> made;
  std::function<void(const Error&)> failed;
};

/// A side of a comparison; an edit is one of the other side's model.
using ComparisonSide = std::variant<std::string, ModelSource, ModelEdit>;

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/run.h"
#include "engine/model/source.h"
#include "server/session/held_revisions.h"
#include "server/store/records.h"

namespace remeshd {

/// Rules of a size field as a request gives them.
struct SizingPatch {
  std::optional<bool> even;
  std::optional<std::uint32_t> edges_per_circle, layers;
  std::optional<double> min_size;  ///< model's unit
  std::optional<double> growth;
};

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
  std::optional<std::uint32_t> order;  ///< of the tets
  std::optional<double> hold;          ///< x edge length
  SizingPatch sizing;
};

/// Whether the revision made is filed in a design, and becomes its head.
struct HeadRule {
  /// Whether it becomes the head, if that still is `expected`. Left out: yes, but for two kinds of
  /// first mesh: one that the design has already, and one whose model is not that of the design's
  /// first revision (warning HeadKept). A design without a head gets one, but for `never`.
  std::optional<bool> advance;
  std::string expected;  ///< id that the head must have for it to move; empty: any
  bool require = false;  ///< where it has another one, the command fails and files nothing
  bool never = false;    ///< it does not become the head of a design without one either
  /// Whether it is filed in a design. Left out: yes, but for an edit that names none and whose base
  /// is in none. What is in no design moves no head, and a rule that wants both is an error.
  std::optional<bool> file;
};

/// Adds line and column to an error about a value in the document that a command came as. Empty
/// where it did not come as a document.
using Locate = std::function<void(ErrorInfo&)>;

struct CreateCommand {
  ModelSource source;
  OptionsPatch options;
  std::string design;  ///< empty: the model's name, or `model`
  HeadRule head;
  std::vector<WarningCode> fail_on;  ///< warnings that are errors; then nothing is filed
  int threads = 1;
  Locate locate{};
};

struct EditCommand {
  std::string base;  ///< as `resolve` takes it
  ModelEdit edit;
  std::string document;  ///< of the edit, as it is kept with the revision
  OptionsPatch options;
  std::string design;       ///< empty: the base's; where that has none, none
  std::string last_design;  ///< that of a base named by its id, where it stands in this and others
  HeadRule head;            ///< expected: empty means the base
  std::vector<WarningCode> fail_on;
  int threads = 1;
  Locate locate{};
};

using Command = std::variant<CreateCommand, EditCommand>;

/// How a revision was entered in a design.
struct Filed {
  RevisionRecord record;
  PlaceRecord place;
  bool head_conflict = false;  ///< the head was to move, was not the expected one, and stayed
  std::string head;            ///< id after the request
  std::uint32_t head_number = 0;
  bool durable = false;           ///< it survives the end of the daemon
  std::vector<Warning> warnings;  ///< HeadKept; NotDurable, where there is a store
};

/// The answer to a command.
struct Made {
  HeldRevisionPtr revision;
  Filed filed;
  bool cached = false;            ///< nothing was computed for this answer
  std::vector<Warning> warnings;  ///< of this answer, beside those of the report
};

/// Callbacks of a command: any number of progress calls, then exactly one of the others. Called by
/// any thread; must not block.
struct Listener {
  std::function<void(const Progress&)> progress;  ///< may be empty
  std::function<void(const Made&)> made;
  std::function<void(const Error&)> failed;
};

/// A side of a comparison: a reference to a revision, a model, or an edit of the original's model.
using ComparisonSide = std::variant<std::string, ModelSource, ModelEdit>;

}  // namespace remeshd

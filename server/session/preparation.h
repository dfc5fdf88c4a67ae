#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/session/archive.h"
#include "server/session/commands.h"
#include "server/session/engine.h"

namespace remeshd {

/// A command with all that its revision depends on resolved.
struct Prepared {
  std::string id;      ///< of the revision it asks for
  std::string design;  ///< empty: it is filed in none
  HeadRule head;
  std::vector<WarningCode> fail_on;
  HeldRevisionPtr base;  ///< null for a first mesh
  std::string edit;      ///< its document
  ModelSource source;
  MeshOptions options;
  int threads = 1;
  double nodes = 0;  ///< at least, as far as can be told before anything is computed
};

/// The base of an edit, and the design that the edit's revision is filed in.
struct EditBase {
  std::string id;
  std::string design;  ///< empty: in none
};

/// Prepares commands: finds the base, applies the edit, checks options and node limit, computes the
/// id.
class Preparation {
 public:
  /// `threads`: at most, for one computation; `max_nodes`: as Run::max_nodes. The references must
  /// outlive it.
  Preparation(const Engine& engine, Archive& archive, int threads, std::uint32_t max_nodes)
      : engine_(engine), archive_(archive), threads_(threads), max_nodes_(max_nodes) {}

  /// Resolves the base of an edit, for `prepare`; nothing for a first mesh. Throws Error where
  /// there is no such revision, the design's name cannot be one, or it is missing.
  [[nodiscard]] std::optional<EditBase> base_of(const Command& command) const;
  /// `revision`: that of the base, null for a first mesh. Throws Error where something is wrong
  /// with the command, with the place in the document that it came as.
  [[nodiscard]] Prepared prepare(const Command& command, const std::optional<EditBase>& base,
                                 const HeldRevisionPtr& revision, std::stop_token stop) const;
  /// What can be told of the revision before it is made.
  [[nodiscard]] RevisionRecord record_of(const Prepared& prepared) const;

 private:
  [[nodiscard]] Prepared prepare_create(const CreateCommand& command, const Run& run) const;
  [[nodiscard]] Prepared prepare_edit(const EditCommand& command, const EditBase& base,
                                      const HeldRevisionPtr& revision, const Run& run) const;

  const Engine& engine_;
  Archive& archive_;
  const int threads_;
  const std::uint32_t max_nodes_;
};

}  // namespace remeshd

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/session/archive.h"
#include "server/session/commands.h"
#include "server/session/engine.h"

namespace remeshd {

/// A command made definite.
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

/// What an edit is of, and where it is filed.
struct EditBase {
  std::string id;
  std::string design;  ///< empty: in none
};

/// Makes commands definite: finds the base, applies the edit, checks options and node limit, finds
/// the id.
class Preparation {
 public:
  /// `threads`: at most, for one computation; `max_nodes`: as Run::max_nodes. The references must
  /// outlive it.
  Preparation(const Engine& engine, Archive& archive, int threads, std::uint32_t max_nodes)
      : engine_(engine), archive_(archive), threads_(threads), max_nodes_(max_nodes) {}

  /// What `prepare` has to be given of an edit; nothing for a first mesh.
  /// Throws Error where there is no such revision, or no such design can be.
  [[nodiscard]] std::optional<EditBase> base_of(const Command& command) const;
  /// `revision`: that of the base. Throws what is wrong with the command, with its place in the
  /// document that it came as.
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

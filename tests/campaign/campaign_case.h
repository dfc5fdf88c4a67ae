#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/remesh/remesh.h"

namespace remeshd::campaign {

struct Step {
  ModelEdit edit;
  std::string kind;  ///< of the edit, as in documents; of a part's: `drift`, `sweep`, ...
  double size = 0;   ///< by the model's diagonal
  /// The CAD kernel fails at its model, which is therefore no base: later edits do without it.
  bool undone = false;
};

/// A model, its first mesh's options, and edits that follow each other: each is meshed from the
/// last revision that could be made, and applied to the document before it in any case.
struct CampaignCase {
  std::uint64_t seed = 0, number = 0;
  std::string part;  ///< of a detailed part its name or the kind of its body, else empty
  std::string note;  ///< what was found, for readers of a stored case
  ModelSource model;
  MeshOptions options;
  std::vector<Step> steps;
};

/// What tells a case from all others.
struct CaseRequest {
  std::uint64_t seed = 1, number = 0;
  /// Of the first mesh of a detailed part; nothing: the case is good-natured or another.
  std::optional<std::uint32_t> part_nodes{};
  bool even = false;  ///< one edge length everywhere, not sized by the rules

  /// As arguments of a command.
  [[nodiscard]] std::vector<std::string> arguments() const;
};

/// The document after k steps.
ModelSource model_after(const CampaignCase& c, std::size_t k);

nlohmann::json write_case(const CampaignCase& c);
/// Throws nlohmann's exceptions where the text is not a case.
CampaignCase read_case(const nlohmann::json& document);

}  // namespace remeshd::campaign

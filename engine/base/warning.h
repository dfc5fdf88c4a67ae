#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd {

/// Kinds of warnings: those of Warning.Code in proto/remesh/v1/error.proto, which tells what each
/// means.
enum class WarningCode : std::uint8_t {
  GroupEmptied,
  FaceLost,
  FeatureWithoutEffect,
  ChordsCoarse,
  DetailNotResolved,
  Fallback,
  NodesFarFromTarget,
  QualityLow,
  Renewed,
  HeadKept,
  NodesInserted,
  NotDurable,
  EdgesStraight,
  HoldEnded,
};

/// Their names in the protocol, in the order of the enumerators.
inline constexpr std::array<std::string_view, 14> kWarningNames{"GROUP_EMPTIED",
                                                                "FACE_LOST",
                                                                "FEATURE_WITHOUT_EFFECT",
                                                                "CHORDS_COARSE",
                                                                "DETAIL_NOT_RESOLVED",
                                                                "FALLBACK",
                                                                "NODES_FAR_FROM_TARGET",
                                                                "QUALITY_LOW",
                                                                "RENEWED",
                                                                "HEAD_KEPT",
                                                                "NODES_INSERTED",
                                                                "NOT_DURABLE",
                                                                "EDGES_STRAIGHT",
                                                                "HOLD_ENDED"};

constexpr std::string_view name_of(WarningCode code) {
  return kWarningNames[static_cast<std::size_t>(code)];
}

/// What the reader of a valid result should know of it.
struct Warning {
  WarningCode code{};
  std::string message;                ///< one sentence
  std::vector<std::string> features;  ///< ids, the main one first
  std::vector<std::string> groups;    ///< `hole.wall`
  std::optional<Vec3> point;          ///< model's unit
  std::uint32_t nodes_needed = 0;  ///< with DetailNotResolved: to resolve all details; 0: unknown
};

/// `pin`, `pin and 1 more feature`, `pin and 3 more features`. Pre: there is one.
inline std::string first_and_more(const std::vector<std::string>& features) {
  const std::size_t more = features.size() - 1;
  if (more == 0) return features.front();
  return features.front() + " and " + std::to_string(more) +
         (more == 1 ? " more feature" : " more features");
}

}  // namespace remeshd

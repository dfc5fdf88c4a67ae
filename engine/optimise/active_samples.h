#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/boundary/samples.h"
#include "engine/nodes/nearest_to_points.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// Which samples take part in the boundary procedure of a remesh (Sect. 8): the active ones have a
/// free node nearest; their neighbours are border-active, since a free node may become nearest to
/// them as nodes move; the others rest. Samples never fall back to a lesser state.
class ActiveSamples {
 public:
  /// All samples are active (a first mesh).
  explicit ActiveSamples(const Samples& samples);
  /// Samples whose nearest node is free are active; samples within .6 edge lengths of an
  /// active one are its neighbours. `nearest`: of the samples' positions; kept by reference.
  ActiveSamples(const NodeSet& nodes, const SizeField& sizes, NearestToPoints& nearest,
                const Run& run);

  /// Active and border-active samples, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& participants() const { return participants_; }
  [[nodiscard]] std::uint32_t active_count() const { return active_count_; }

  /// `pulling`: samples that had a free node nearest. Border-active ones among them become active,
  /// and their resting neighbours border-active.
  void promote(std::span<const std::uint32_t> pulling);

  /// To be called when more nodes are free: samples whose nearest node is free become active.
  void refresh(const NodeSet& nodes, const Run& run);

 private:
  enum class State : std::uint8_t { Resting, Border, Active };
  void activate(std::uint32_t sample);
  void collect();

  SizeField sizes_{0};
  std::vector<State> states_;
  NearestToPoints* nearest_ = nullptr;  ///< null where all are active
  std::vector<std::uint32_t> participants_;
  std::uint32_t active_count_ = 0;
};

}  // namespace remeshd

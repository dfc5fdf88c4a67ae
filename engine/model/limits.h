#pragma once

#include <string_view>

namespace remeshd {

/// Most features of one model.
inline constexpr std::size_t kMaxFeatures = 10000;
/// Most size controls of one model, and most groups.
inline constexpr std::size_t kMaxSelections = 1000;
/// Sizes and coordinates are at most this, in the model's unit.
inline constexpr double kMaxLength = 1e9;
/// Sizes are at least this, in the model's unit.
inline constexpr double kMinSize = 1e-9;

/// The value itself. Throws Error(VALUE_OUT_OF_RANGE) unless |value| <= kMaxLength.
double checked_coordinate(double value, std::string_view feature, std::string_view parameter);

/// The value itself. Throws Error(DEGENERATE_FEATURE) unless positive, or zero where `may_be_zero`;
/// Error(VALUE_OUT_OF_RANGE) unless in [kMinSize, kMaxLength] or zero.
double checked_size(double value, bool may_be_zero, std::string_view feature,
                    std::string_view parameter);

}  // namespace remeshd

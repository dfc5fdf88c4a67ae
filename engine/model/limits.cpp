#include "engine/model/limits.h"

#include <cmath>

#include "engine/base/error.h"

namespace remeshd {

double checked_coordinate(double value, std::string_view feature, std::string_view parameter) {
  if (std::fabs(value) > kMaxLength)
    throw error::value_out_of_range(feature, parameter, value, "between -1e9 and 1e9");
  return value;
}

double checked_size(double value, bool may_be_zero, std::string_view feature,
                    std::string_view parameter) {
  if (value == 0 && may_be_zero) return 0;
  if (value <= 0)
    throw error::degenerate_feature(feature, parameter, value,
                                    may_be_zero ? "must not be negative" : "must be positive");
  if (value < kMinSize || value > kMaxLength)
    throw error::value_out_of_range(feature, parameter, value, "between 1e-9 and 1e9");
  return value;
}

}  // namespace remeshd

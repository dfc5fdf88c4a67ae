#pragma once

#include <optional>
#include <span>
#include <vector>

namespace remeshd::bench {

/// The middle value, or the mean of the two in the middle; nothing where there are none.
std::optional<double> median(std::vector<double> values);

/// A value of each round; nothing where that run failed.
using Rounds = std::vector<std::optional<double>>;

/// The values there are.
std::vector<double> present(const Rounds& rounds);

/// The median of a over b round by round: what disturbs the machine for a while meets both. Rounds
/// that lack either do not count.
std::optional<double> pairwise_ratio(const Rounds& a, const Rounds& b);

}  // namespace remeshd::bench

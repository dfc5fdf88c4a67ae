// SPDX-License-Identifier: Apache-2.0
#include "proto/rendezvous.h"

#include <algorithm>
#include <numeric>

#include "proto/checksum.h"

namespace remeshd {

std::vector<std::size_t> rank_by_rendezvous(const std::vector<std::string>& addresses,
                                            const std::string& route) {
  std::vector<std::string> hashes;
  for (std::string text : addresses) hashes.push_back(sha256_hex(text.append("\n").append(route)));
  std::vector<std::size_t> ranked(addresses.size());
  std::iota(ranked.begin(), ranked.end(), std::size_t{0});
  std::ranges::stable_sort(ranked, std::ranges::greater(),
                           [&](std::size_t i) { return hashes[i]; });
  return ranked;
}

std::size_t first_by_rendezvous(const std::vector<std::string>& addresses,
                                const std::string& route) {
  return rank_by_rendezvous(addresses, route).front();
}

}  // namespace remeshd

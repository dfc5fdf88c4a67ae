// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace remeshd {

/// Indices of the addresses, those first that are to be asked first for `route`: by rendezvous
/// hashing, so that where one address goes only its routes move. As every client does it: by the
/// SHA-256 of `ADDRESS\nROUTE`, the greatest first.
std::vector<std::size_t> rank_by_rendezvous(const std::vector<std::string>& addresses,
                                            const std::string& route);
/// The first of them. Pre: there is an address.
std::size_t first_by_rendezvous(const std::vector<std::string>& addresses,
                                const std::string& route);

}  // namespace remeshd

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace remeshd::client {

/// Begins the comment by which an `.inp` of ours tells how many nodes and tets follow: "12, 6".
inline constexpr std::string_view kInpHead = "** as many nodes and tets were written: ";

}  // namespace remeshd::client

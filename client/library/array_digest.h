// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace remeshd::client {

/// The digest of an array as `MeshHeader.Array.digest` has it: 64 hexadecimal digits of the SHA-256
/// over the SHA-256s of its blocks of 16 KiB.
std::string array_digest(std::string_view bytes);

}  // namespace remeshd::client

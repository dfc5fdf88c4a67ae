// SPDX-License-Identifier: Apache-2.0
#include "client/library/array_digest.h"

#include <cstddef>

#include "proto/checksum.h"

namespace remeshd::client {
namespace {

constexpr std::size_t kBlock = std::size_t{16} << 10;

}  // namespace

std::string array_digest(std::string_view bytes) {
  Sha256 all;
  for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
    Sha256 block;
    block.update(bytes.substr(at, kBlock));
    all.update(block.finish());
  }
  return to_hex(all.finish());
}

}  // namespace remeshd::client

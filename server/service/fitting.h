#pragma once

#include <cstddef>
#include <string>

namespace remeshd {

/// The text in at most `limit` bytes: where it has more, its beginning, cut between characters, and
/// "...". What is no UTF-8 becomes `?`. Pre: limit >= 3.
std::string fitting(const std::string& text, std::size_t limit);

}  // namespace remeshd

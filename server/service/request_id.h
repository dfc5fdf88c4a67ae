#pragma once

#include <string>

namespace remeshd {

/// Throws Error(InvalidArgument) `REQUEST_ID_TOO_LONG` for an id of more than 128 bytes.
void check_request_id(const std::string& id);

/// The id as an answer carries it: as it came, or the beginning of one that is too long, in UTF-8.
std::string echoed_request_id(const std::string& id);

}  // namespace remeshd

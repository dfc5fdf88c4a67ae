#pragma once

#include <string>

namespace remeshd::test {

/// Calls a method over a connection of its own, with these bytes as the one message, marked as
/// compressed by gzip; so the caller spends no time on gRPC's own compression. At most 60,000
/// bytes, which is what a peer takes before it has said anything. Returns the time in s from
/// sending to the answer's status; throws std::runtime_error where none comes within 10 s.
double raw_call(const std::string& address, const std::string& method, const std::string& message);

/// `bytes` of blanks, as gzip makes them small.
std::string gzip_bomb(std::size_t bytes);

}  // namespace remeshd::test

#pragma once

#include <string>
#include <string_view>

namespace remeshd {

/// What has to be known of a message of EditStream before its turn: which request it is, and the id
/// that it can be cancelled by.
struct StreamRequestHead {
  bool is_cancel = false;
  std::string request_id;
};

/// Finds the head in a message's bytes, without decoding the rest and without memory for more than
/// the id. Of a message that protobuf can read, the head is what protobuf reads. Of any other it is
/// what was found up to the damage; an id may then be no UTF-8.
StreamRequestHead read_head(std::string_view message);

}  // namespace remeshd

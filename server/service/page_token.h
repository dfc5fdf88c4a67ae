#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <string>

namespace remeshd {

/// Identifies a list by its kind, filter and order, so that a token of one list is not valid for
/// another.
class ListIdentity {
 public:
  ListIdentity(const char* kind, const google::protobuf::Message& filter, int order,
               bool descending);

  /// The token of the page that begins after the row with this key.
  [[nodiscard]] std::string token(std::int64_t value, const std::string& id, std::uint32_t number,
                                  const std::string& name) const;

  /// What a token says of its row.
  struct Row {
    std::int64_t value = 0;
    std::string id;
    std::uint32_t number = 0;
    std::string name;
  };
  /// Throws Error(InvalidArgument, `PAGE_TOKEN_INVALID`) for a text that is no token of this list.
  [[nodiscard]] Row read(const std::string& token) const;

 private:
  std::string digest_;
};

}  // namespace remeshd

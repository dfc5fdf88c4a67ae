#include "server/service/stream_request.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

#include "remesh/v1/remesh.pb.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;
using Message = v1::EditStreamRequest;

constexpr std::uint32_t tag_of(int field) {
  return WireFormatLite::MakeTag(field, WireFormatLite::WIRETYPE_LENGTH_DELIMITED);
}

/// Number of the id's field in the request that a field of the message holds; 0 for other fields.
int id_field(std::uint32_t tag) {
  switch (tag) {
    case tag_of(Message::kEditFieldNumber):
      return v1::EditRevisionRequest::kRequestIdFieldNumber;
    case tag_of(Message::kCreateFieldNumber):
      return v1::CreateRevisionRequest::kRequestIdFieldNumber;
    case tag_of(Message::kCancelFieldNumber):
      return v1::CancelRequest::kRequestIdFieldNumber;
    default:
      return 0;
  }
}

/// Reads the id of the request whose bytes come next; false where they are damaged.
bool read_id(CodedInputStream& in, int field, std::string& id) {
  std::uint32_t length = 0;
  if (!in.ReadVarint32(&length)) return false;
  const auto limit = in.PushLimit(static_cast<int>(length));
  while (const std::uint32_t tag = in.ReadTag()) {
    if (tag == tag_of(field)) {
      if (!WireFormatLite::ReadString(&in, &id)) return false;
    } else if (!WireFormatLite::SkipField(&in, tag)) {
      return false;
    }
  }
  if (!in.ConsumedEntireMessage()) return false;
  in.PopLimit(limit);
  return true;
}

}  // namespace

StreamRequestHead read_head(std::string_view message) {
  StreamRequestHead head;
  CodedInputStream in(reinterpret_cast<const std::uint8_t*>(message.data()),
                      static_cast<int>(message.size()));
  std::uint32_t request = 0;
  while (const std::uint32_t tag = in.ReadTag()) {
    const int field = id_field(tag);
    if (field == 0) {
      if (!WireFormatLite::SkipField(&in, tag)) break;
      continue;
    }
    // Of several requests the last counts; several of a kind are merged.
    if (tag != request) head = {.is_cancel = tag == tag_of(Message::kCancelFieldNumber)};
    request = tag;
    if (!read_id(in, field, head.request_id)) break;
  }
  return head;
}

}  // namespace remeshd

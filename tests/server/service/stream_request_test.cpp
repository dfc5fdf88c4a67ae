#include "server/service/stream_request.h"

#include <google/protobuf/stubs/logging.h>
#include <gtest/gtest.h>

#include "engine/base/random.h"
#include "remesh/v1/remesh.pb.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

v1::EditStreamRequest edit(const std::string& id) {
  v1::EditStreamRequest message;
  message.mutable_edit()->set_base("plate");
  message.mutable_edit()->set_request_id(id);
  message.mutable_edit()->mutable_edit()->add_edits()->mutable_remove_feature()->set_feature("rib");
  return message;
}
v1::EditStreamRequest create(const std::string& id) {
  v1::EditStreamRequest message;
  message.mutable_create()->mutable_model()->set_name("plate");
  message.mutable_create()->set_request_id(id);
  return message;
}
v1::EditStreamRequest cancel(const std::string& id) {
  v1::EditStreamRequest message;
  message.mutable_cancel()->set_request_id(id);
  return message;
}

std::string id_of(const v1::EditStreamRequest& message) {
  if (message.has_edit()) return message.edit().request_id();
  if (message.has_create()) return message.create().request_id();
  return message.cancel().request_id();
}

void expect_same(const std::string& bytes, const v1::EditStreamRequest& message) {
  const StreamRequestHead head = read_head(bytes);
  EXPECT_EQ(head.is_cancel, message.has_cancel()) << message.ShortDebugString();
  EXPECT_EQ(head.request_id, id_of(message)) << message.ShortDebugString();
}

TEST(StreamRequestHead, IsFoundInEveryKindOfRequest) {
  for (const auto& message : {edit("e"), create("c"), cancel("x"), edit(""), {}})
    expect_same(message.SerializeAsString(), message);
}

TEST(StreamRequestHead, OfSeveralRequestsInOneMessageIsThatOfTheLast) {
  const std::string bytes[] = {edit("one").SerializeAsString(), create("two").SerializeAsString(),
                               cancel("three").SerializeAsString(), edit("").SerializeAsString()};
  for (const std::string& first : bytes)
    for (const std::string& second : bytes) {
      v1::EditStreamRequest message;
      ASSERT_TRUE(message.ParseFromString(first + second));
      expect_same(first + second, message);
    }
}

TEST(StreamRequestHead, OfDamagedBytesThatCanBeReadIsWhatProtobufReads) {
  const google::protobuf::LogSilencer silence;
  Random random(7);
  int readable = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = (i % 3 == 0   ? edit("some id")
                         : i % 3 == 1 ? create("other")
                                      : cancel("third"))
                            .SerializeAsString();
    for (std::uint64_t n = 1 + random.below(3); n > 0; --n)
      bytes[random.below(bytes.size())] = static_cast<char>(random.next());
    const StreamRequestHead head = read_head(bytes);
    v1::EditStreamRequest message;
    if (!message.ParseFromString(bytes)) continue;
    ++readable;
    EXPECT_EQ(head.is_cancel, message.has_cancel());
    EXPECT_EQ(head.request_id, id_of(message));
  }
  EXPECT_GT(readable, 1000);
}

}  // namespace
}  // namespace remeshd

#include "server/service/call.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace remeshd::test {
namespace {

TEST(UnaryCalls, KeepNoActionOnceTheyAreDone) {
  grpc::CallbackServerContext context;
  grpc::ByteBuffer reply;
  const auto record = std::make_shared<CallRecord>(std::make_shared<FrontDesk>(), "M", context);
  const auto call = UnaryCall::start(&context, &reply, record);
  const auto before = std::make_shared<int>(), after = std::make_shared<int>();
  call->on_cancel([before] {});
  call->OnDone();
  call->on_cancel([after] {});
  EXPECT_EQ(before.use_count(), 1);
  EXPECT_EQ(after.use_count(), 1);
}

TEST(UnaryCalls, DoAllThatTheyWereToldToDoWhenTheirClientCancels) {
  grpc::CallbackServerContext context;
  grpc::ByteBuffer reply;
  const auto call = std::make_shared<UnaryCall>(
      &context, &reply,
      std::make_shared<CallRecord>(std::make_shared<FrontDesk>(), "Method", context));
  std::string done;
  call->on_cancel([&] { done += "work stopped, "; });
  call->on_cancel([&] { done += "work withdrawn, "; });
  call->OnCancel();
  call->on_cancel([&] { done += "told too late"; });
  EXPECT_EQ(done, "work stopped, work withdrawn, told too late");
}

}  // namespace
}  // namespace remeshd::test

#include <thread>

#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using grpc::StatusCode;

class Cancel : public DaemonTest {
 protected:
  void SetUp() override {
    start();
    engine_.close_gate();
  }
};

TEST_F(Cancel, OfTheCallStopsTheComputation) {
  grpc::ClientContext context;
  v1::CreateRevisionResponse reply;
  grpc::Status status;
  std::thread client(
      [&] { status = stub().CreateRevision(&context, create_request(plate()), &reply); });
  ASSERT_TRUE(engine_.wait_at_gate(1));
  context.TryCancel();
  client.join();
  EXPECT_EQ(status.error_code(), StatusCode::CANCELLED);
  // The gate stays closed: only the stop request can have ended it.
  EXPECT_TRUE(engine_.wait_stopped(1));
  EXPECT_EQ(engine_.made(), 0);
  EXPECT_EQ(info().load().revisions(), 0U);
}

TEST_F(Cancel, ByDeadlineStopsTheComputation) {
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(1));
  v1::CreateRevisionResponse reply;
  const auto status = stub().CreateRevision(&context, create_request(plate()), &reply);
  EXPECT_EQ(status.error_code(), StatusCode::DEADLINE_EXCEEDED);
  EXPECT_TRUE(engine_.wait_stopped(1));
}

TEST_F(Cancel, OfOneOfTwoWhoWaitLeavesTheOtherItsRevision) {
  grpc::ClientContext impatient;
  v1::CreateRevisionResponse first;
  v1::RevisionResult second;
  std::thread one([&] {
    EXPECT_EQ(stub().CreateRevision(&impatient, create_request(plate()), &first).error_code(),
              StatusCode::CANCELLED);
  });
  ASSERT_TRUE(engine_.wait_at_gate(1));
  std::thread two([&] { EXPECT_TRUE(try_create(create_request(plate()), &second).ok()); });
  impatient.TryCancel();
  one.join();
  engine_.open_gate();
  two.join();
  EXPECT_EQ(second.revision().number(), 1U);
}

TEST_F(Cancel, OfAWaitingRequestTakesItOutOfTheQueue) {
  options_.workers = 1;
  start();
  v1::RevisionResult reply;
  std::thread busy([&] { EXPECT_TRUE(try_create(create_request(plate()), &reply).ok()); });
  ASSERT_TRUE(engine_.wait_at_gate(1));
  grpc::ClientContext context;
  v1::CreateRevisionResponse none;
  std::thread waiting([&] {
    EXPECT_EQ(stub().CreateRevision(&context, create_request(plate(6)), &none).error_code(),
              StatusCode::CANCELLED);
  });
  while (info().load().queued() == 0) std::this_thread::yield();
  context.TryCancel();
  waiting.join();
  while (info().load().queued() != 0) std::this_thread::yield();
  engine_.open_gate();
  busy.join();
  EXPECT_EQ(engine_.started(), 1);
}

TEST_F(Cancel, LeavesTheSameRequestFreeToComeAgain) {
  grpc::ClientContext context;
  v1::CreateRevisionResponse reply;
  std::thread client(
      [&] { EXPECT_FALSE(stub().CreateRevision(&context, create_request(plate()), &reply).ok()); });
  ASSERT_TRUE(engine_.wait_at_gate(1));
  context.TryCancel();
  client.join();
  ASSERT_TRUE(engine_.wait_stopped(1));
  engine_.open_gate();
  EXPECT_FALSE(create(plate()).report().cached());
}

TEST_F(Cancel, ShutdownAnswersWithUnavailableAndStopsComputations) {
  v1::RevisionResult reply;
  grpc::Status status;
  std::thread client([&] { status = try_create(create_request(plate()), &reply); });
  ASSERT_TRUE(engine_.wait_at_gate(1));
  daemon_->shutdown();
  client.join();
  EXPECT_EQ(status.error_code(), StatusCode::UNAVAILABLE);
  EXPECT_EQ(engine_.stopped(), 1);
}

}  // namespace
}  // namespace remeshd::test

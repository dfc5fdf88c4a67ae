#include <future>
#include <thread>

#include "server/process/health_probe.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using namespace std::chrono_literals;
constexpr double kLong = 600;  // s, that no test waits for

/// A daemon that is told to end while a computation stands at the gate.
class EndingDaemons : public DaemonTest {
 protected:
  void TearDown() override {
    engine_.open_gate();
    if (ending_.valid()) ending_.wait();
  }
  std::future<grpc::Status> create_soon() {
    return std::async(std::launch::async, [this] {
      v1::RevisionResult result;
      return try_create(create_request(plate()), &result);
    });
  }
  void end_soon(double grace) {
    ending_ = std::async(std::launch::async, [this, grace] { daemon_->shutdown(grace); });
    while (health("remesh.v1.RemeshService") != Health::NotServing) std::this_thread::yield();
  }
  Health health(const std::string& service) {
    return probe_health(daemon_->address(), service, 10s);
  }

  std::future<void> ending_;
};

TEST_F(EndingDaemons, LetWhatIsUnderWayFinish) {
  start();
  engine_.close_gate();
  auto under_way = create_soon();
  ASSERT_TRUE(engine_.wait_at_gate(1));
  end_soon(kLong);
  engine_.open_gate();
  EXPECT_TRUE(under_way.get().ok());
  EXPECT_EQ(ending_.wait_for(10s), std::future_status::ready);
}

TEST_F(EndingDaemons, RefuseNewRequestsWithADelayAndAreAliveButNotReady) {
  start();
  engine_.close_gate();
  auto under_way = create_soon();
  ASSERT_TRUE(engine_.wait_at_gate(1));
  end_soon(kLong);
  EXPECT_EQ(health("liveness"), Health::Serving);
  EXPECT_EQ(health(""), Health::Serving);
  grpc::ClientContext context;
  v1::GetServerInfoResponse reply;
  const grpc::Status status = stub().GetServerInfo(&context, {}, &reply);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(detail(status).reason(), v1::Error::SHUTTING_DOWN);
  EXPECT_EQ(detail(status).retry_after(), 1);
  EXPECT_EQ(context.GetServerTrailingMetadata().count("grpc-retry-pushback-ms"), 1U);
  grpc::ClientContext stream_context;
  const auto stream = stub().EditStream(&stream_context);
  v1::EditStreamResponse none;
  EXPECT_FALSE(stream->Read(&none));
  EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::UNAVAILABLE);
  grpc::ClientContext mesh_context;
  v1::GetMeshResponse part;
  const auto mesh = stub().GetMesh(&mesh_context, {});
  EXPECT_FALSE(mesh->Read(&part));
  EXPECT_EQ(mesh->Finish().error_code(), grpc::StatusCode::UNAVAILABLE);
  engine_.open_gate();
  EXPECT_TRUE(under_way.get().ok());
}

TEST_F(EndingDaemons, FinishTheRequestOfAStreamAndHandBackTheNext) {
  start();
  engine_.close_gate();
  grpc::ClientContext context;
  const auto stream = stub().EditStream(&context);
  v1::EditStreamRequest request;
  for (const double radius : {3.0, 4.0}) {
    *request.mutable_create() = create_request(plate(radius));
    ASSERT_TRUE(stream->Write(request));
  }
  ASSERT_TRUE(engine_.wait_at_gate(1));
  end_soon(kLong);
  engine_.open_gate();
  v1::EditStreamResponse first, second;
  do ASSERT_TRUE(stream->Read(&first));
  while (first.has_progress());
  EXPECT_TRUE(first.has_result()) << first.ShortDebugString();
  do ASSERT_TRUE(stream->Read(&second));
  while (second.has_progress());
  EXPECT_EQ(second.error().reason(), v1::Error::SHUTTING_DOWN);
  EXPECT_EQ(ending_.wait_for(10s), std::future_status::ready);
}

TEST_F(EndingDaemons, DoNotWaitForStreamsOnWhichNothingIsUnderWay) {
  start();
  grpc::ClientContext context;
  const auto stream = stub().EditStream(&context);
  v1::EditStreamRequest request;
  *request.mutable_create() = create_request(plate());
  ASSERT_TRUE(stream->Write(request));
  v1::EditStreamResponse reply;
  do ASSERT_TRUE(stream->Read(&reply));
  while (reply.has_progress());
  daemon_->shutdown(kLong);
}

TEST_F(EndingDaemons, HandBackWhatOutlastsTheGraceTime) {
  start();
  engine_.close_gate();
  auto under_way = create_soon();
  ASSERT_TRUE(engine_.wait_at_gate(1));
  daemon_->shutdown(0.001);
  const grpc::Status status = under_way.get();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(detail(status).reason(), v1::Error::SHUTTING_DOWN);
}

TEST_F(EndingDaemons, AreUnreachableAfterwards) {
  start();
  const std::string address = daemon_->address();
  daemon_->shutdown();
  EXPECT_EQ(probe_health(address, "liveness", 10s), Health::Unreachable);
}

TEST_F(EndingDaemons, AnswerForNoOtherName) {
  start();
  EXPECT_EQ(health("remesh.v1.RemeshService"), Health::Serving);
  EXPECT_EQ(health("remesh.v1.Nothing"), Health::NotServing);
}

}  // namespace
}  // namespace remeshd::test

#include <cstring>
#include <string>
#include <vector>

#include "proto/checksum.h"
#include "server/limits.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

class MotionCalls : public DaemonTest {
 protected:
  struct Received {
    v1::DesignVelocityHeader header;
    std::vector<std::string> data;
    grpc::Status status;
  };
  /// All of a transfer, its parts checked on the way.
  Received velocities(const v1::GetDesignVelocitiesRequest& request) {
    Received received;
    grpc::ClientContext context;
    const auto reader = stub().GetDesignVelocities(&context, request);
    for (v1::GetDesignVelocitiesResponse message; reader->Read(&message);) {
      EXPECT_LE(message.ByteSizeLong(), 1U << 20U);
      if (message.has_header()) {
        received.header = message.header();
        received.data.resize(received.header.parameters_size());
      }
      if (!message.has_part()) continue;
      std::string& data = received.data.at(message.part().parameter());
      EXPECT_EQ(message.part().offset(), data.size());
      EXPECT_EQ(message.part().crc32c(), crc32c(message.part().data()));
      data += message.part().data();
    }
    received.status = reader->Finish();
    return received;
  }
  static v1::GetDesignVelocitiesRequest of(const std::string& revision,
                                           std::vector<std::string> parameters) {
    v1::GetDesignVelocitiesRequest request;
    request.set_revision(revision);
    request.mutable_parameters()->Add(parameters.begin(), parameters.end());
    return request;
  }
  grpc::Status gradient(const v1::GetDesignGradientRequest& request,
                        v1::GetDesignGradientResponse& reply) {
    grpc::ClientContext context;
    return stub().GetDesignGradient(&context, request, &reply);
  }
};

TEST_F(MotionCalls, VelocitiesComeParameterByParameterInParts) {
  v1::CreateRevisionRequest request = create_request(plate());
  request.mutable_options()->set_nodes(60000);  // more than one part
  const v1::RevisionInfo made = create(request).revision();
  const Received got = velocities(of("plate", {"one", "two"}));
  ASSERT_TRUE(got.status.ok()) << got.status.error_message();
  EXPECT_EQ(got.header.revision(), made.id());
  EXPECT_EQ(got.header.nodes(), made.nodes());
  ASSERT_EQ(got.header.parameters_size(), 2);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(got.header.parameters(k).name(), k == 0 ? "one" : "two");
    EXPECT_EQ(got.header.parameters(k).value(), 10 * (k + 1));
    EXPECT_EQ(got.header.parameters(k).undefined(), 1U);
    ASSERT_EQ(got.data[k].size(), 25 * made.nodes());
    double last[3];
    std::memcpy(last, got.data[k].data() + 24 * (made.nodes() - 1), sizeof last);
    EXPECT_EQ(last[0], k + 1);
    EXPECT_EQ(last[2], -(k + 1));
    EXPECT_EQ(got.data[k][24 * made.nodes()], 1);
    EXPECT_EQ(got.data[k].back(), 0);
  }
}

TEST_F(MotionCalls, AreOfTheModelsParametersWhereNoneIsNamed) {
  create(plate());
  const Received got = velocities(of("plate", {}));
  ASSERT_TRUE(got.status.ok());
  ASSERT_EQ(got.header.parameters_size(), 2);
  EXPECT_EQ(got.header.parameters(0).name(), "r");
  EXPECT_EQ(got.header.parameters(1).name(), "at");
}

TEST_F(MotionCalls, AGradientTakesThreeNumbersANode) {
  const v1::RevisionInfo made = create(plate()).revision();
  v1::GetDesignGradientRequest request;
  request.set_revision("plate");
  std::vector<double> seed(3 * made.nodes(), 0);
  seed[0] = 1;
  seed[4] = 2;
  seed[8] = 3;
  request.mutable_seed()->assign(reinterpret_cast<const char*>(seed.data()), 8 * seed.size());
  v1::GetDesignGradientResponse reply;
  ASSERT_TRUE(gradient(request, reply).ok());
  EXPECT_EQ(reply.revision(), made.id());
  ASSERT_EQ(reply.derivatives_size(), 2);
  EXPECT_EQ(reply.derivatives(1).parameter(), "at");
  EXPECT_EQ(reply.derivatives(1).value(), 321);
  EXPECT_EQ(reply.derivatives(1).undefined(), 3U);

  seed[5] = HUGE_VAL;
  request.mutable_seed()->assign(reinterpret_cast<const char*>(seed.data()), 8 * seed.size());
  EXPECT_EQ(gradient(request, reply).error_code(), grpc::INVALID_ARGUMENT);
  request.mutable_seed()->pop_back();
  const grpc::Status status = gradient(request, reply);
  EXPECT_EQ(status.error_code(), grpc::INVALID_ARGUMENT);
  EXPECT_NE(status.error_message().find("seed"), std::string::npos);
}

TEST_F(MotionCalls, AHorizonCountsByTheHoldAskedForOrTheRevisions) {
  v1::CreateRevisionRequest create_held = create_request(plate());
  create_held.mutable_options()->set_hold(2);
  create(create_held);
  v1::GetConnectivityHorizonRequest request;
  request.set_revision("plate");
  request.add_parameters("at");
  const auto ask = [&] {
    grpc::ClientContext context;
    v1::GetConnectivityHorizonResponse reply;
    const auto status = stub().GetConnectivityHorizon(&context, request, &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    EXPECT_EQ(reply.horizons_size(), 1);
    return reply.horizons(0);
  };
  EXPECT_EQ(ask().parameter(), "at");
  EXPECT_EQ(ask().lower(), 5);
  EXPECT_EQ(ask().upper(), 9);
  EXPECT_EQ(ask().upper_reason(), "above at");
  request.set_hold(0.5);
  EXPECT_EQ(ask().upper(), 7.5);
  request.set_hold(11);
  grpc::ClientContext context;
  v1::GetConnectivityHorizonResponse reply;
  EXPECT_EQ(stub().GetConnectivityHorizon(&context, request, &reply).error_code(),
            grpc::INVALID_ARGUMENT);
}

TEST_F(MotionCalls, TooManyParametersAreRefused) {
  create(plate());
  const auto request = of("plate", std::vector<std::string>(101, "at"));
  EXPECT_EQ(velocities(request).status.error_code(), grpc::INVALID_ARGUMENT);
  EXPECT_TRUE(velocities(of("plate", std::vector<std::string>(100, "at"))).status.ok());
}

TEST_F(MotionCalls, OptionsOutOfRangeAreRefused) {
  for (const double hold : {-1.0, 10.5, HUGE_VAL}) {
    v1::CreateRevisionRequest request = create_request(plate());
    request.mutable_options()->set_hold(hold);
    v1::RevisionResult reply;
    const auto status = try_create(request, &reply);
    EXPECT_EQ(status.error_code(), grpc::INVALID_ARGUMENT);
    EXPECT_NE(status.error_message().find("hold"), std::string::npos);
  }
}

}  // namespace
}  // namespace remeshd::test

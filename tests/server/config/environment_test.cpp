#include "server/config/environment.h"

#include "tests/server/config/read.h"

namespace remeshd::test {
namespace {

using testing::IsEmpty;

TEST(EnvironmentVariables, GiveOptionsByTheirNames) {
  const auto environment = read_environment({"HOME=/h", "REMESHD_QUEUE_WAIT=2.5"});
  ASSERT_EQ(environment.given.size(), 1U);
  EXPECT_EQ(environment.given[0].option->name, "queue-wait");
  EXPECT_EQ(environment.given[0].value, OptionValue(2.5));
}

TEST(EnvironmentVariables, WithAWrongValueAreRefusedByName) {
  for (const char* value : {"many", "5x", "0x10", " 5", "5.5", "99999999999999999999"})
    EXPECT_EQ(complaint([&] { read_environment({std::string("REMESHD_WORKERS=") + value}); }),
              std::string("REMESHD_WORKERS: `") + value + "` is not a whole number");
  EXPECT_EQ(complaint([] { read_configuration({}, {"REMESHD_WORKERS=-1"}); }),
            "REMESHD_WORKERS: -1 is less than 0");
}

TEST(EnvironmentVariables, ThatAreUnknownAreRefusedWithTheNearestOne) {
  EXPECT_EQ(complaint([] { read_environment({"REMESHD_MAX_NODE=5"}); }),
            "environment: REMESHD_MAX_NODE is unknown; did you mean `REMESHD_MAX_NODES`?");
  EXPECT_EQ(complaint([] { read_environment({"REMESHD_ZEBRA=1"}); }),
            "environment: REMESHD_ZEBRA is unknown");
  EXPECT_NE(complaint([] { read_environment({"REMESHD_PORT_FIL=/x"}); }), "");
}

TEST(EnvironmentVariables, WithoutAValueCountAsNotSet) {
  const auto environment = read_environment({"REMESHD_STORE=", "REMESHD_WORKERS="});
  EXPECT_THAT(environment.given, IsEmpty());
}

TEST(EnvironmentVariables, OfTheHelperAndOfServicesArePassedOver) {
  EXPECT_THAT(
      read_environment({"REMESHD_TETGEN=/x", "REMESHD_PORT=tcp://10.0.0.1:50051",
                        "REMESHD_PORT_50051_TCP=tcp://10.0.0.1:50051",
                        "REMESHD_PORT_50051_TCP_ADDR=10.0.0.1", "REMESHD_SERVICE_HOST=10.0.0.1",
                        "REMESHD_SERVICE_PORT_GRPC=50051", "REMESHD_BLUE_SERVICE_HOST=10.0.0.2",
                        "REMESHD_BLUE_PORT=tcp://10.0.0.2:50051"})
          .given,
      IsEmpty());
}

}  // namespace
}  // namespace remeshd::test

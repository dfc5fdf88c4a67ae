#include "tests/server/config/read.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;

TEST(AddressesThatOthersReach, AreRefusedWithoutMutualTls) {
  Settings settings;
  for (const char* address : {"0.0.0.0:0", "[::]:0", "192.0.2.1:50051"}) {
    settings.daemon.listen = {"127.0.0.1:0", address};
    EXPECT_THAT(complaint([&] { check_settings(settings); }),
                testing::AllOf(HasSubstr(address), HasSubstr("tls-client-ca")));
  }
  settings.behind_proxy = true;
  EXPECT_NO_THROW(check_settings(settings));
}

TEST(AddressesThatOthersReach, AreNotOpenedByTokensAlone) {
  Settings settings;
  settings.daemon.listen = {"0.0.0.0:0"};
  settings.token_file = "/tokens";
  settings.daemon.tls = {.certificate = "/cert", .key = "/key"};
  EXPECT_THAT(complaint([&] { check_settings(settings); }), HasSubstr("tls-client-ca"));
}

TEST(AddressesThatOthersReach, AreNeitherLoopbackNorUnixSockets) {
  Settings settings;
  settings.daemon.listen = {"127.0.0.1:0", "[::1]:0", "localhost:0", "unix:/socket"};
  EXPECT_NO_THROW(check_settings(settings));
}

TEST(AddressesThatOthersReach, ServeMetricsByAFlagOfTheirOwnOnly) {
  Settings settings;
  settings.metrics = "127.0.0.1:0";
  EXPECT_NO_THROW(check_settings(settings));
  settings.metrics = "0.0.0.0:9100";
  settings.behind_proxy = true;
  EXPECT_THAT(complaint([&] { check_settings(settings); }), HasSubstr("insecure-metrics"));
  settings.insecure_metrics = true;
  EXPECT_NO_THROW(check_settings(settings));
  settings.metrics = "unix:/socket";
  EXPECT_THAT(complaint([&] { check_settings(settings); }), HasSubstr("HOST:PORT"));
}

}  // namespace
}  // namespace remeshd::test

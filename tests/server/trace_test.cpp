#include <spdlog/logger.h>
#include <spdlog/sinks/ostream_sink.h>

#include <sstream>

#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class TracedCalls : public DaemonTest {
 protected:
  /// The log of a call with this metadata.
  std::string log_of(const std::string& trace_parent) {
    std::ostringstream text;
    options_.log = std::make_shared<spdlog::logger>(
        "test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text));
    start();
    grpc::ClientContext context;
    context.AddMetadata("traceparent", trace_parent);
    v1::GetServerInfoResponse reply;
    EXPECT_TRUE(stub().GetServerInfo(&context, {}, &reply).ok());
    stop();
    return text.str();
  }
};

TEST_F(TracedCalls, AreLoggedWithTheirTrace) {
  const std::string trace = "00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01";
  EXPECT_THAT(log_of(trace), HasSubstr(" traceparent=" + trace));
}

TEST_F(TracedCalls, AreLoggedWithoutATraceThatIsNone) {
  EXPECT_THAT(log_of("00-forged status=OK"), Not(HasSubstr("traceparent")));
}

}  // namespace
}  // namespace remeshd::test

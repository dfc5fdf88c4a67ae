#include "remesh/v1/cache.grpc.pb.h"
#include "server/observe/metrics.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class CountedCalls : public DaemonTest {
 protected:
  CountedCalls() { options_.metrics = std::make_shared<Metrics>("1.2.3", 13); }
  [[nodiscard]] bool tells(const std::string& text) const {
    return options_.metrics->text().find(text) != std::string::npos;
  }
  /// The metrics once they have this line: a call is counted after its client has the answer.
  std::string text_with(const std::string& line) const {
    std::string text;
    for (int i = 0; i < 1000; ++i) {
      text = options_.metrics->text();
      if (text.find(line + '\n') != std::string::npos) return text;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ADD_FAILURE() << "no " << line << " in:\n" << text;
    return text;
  }
};

TEST_F(CountedCalls, AreTheMeshesThatWereMade) {
  create(plate());
  create(plate());
  edit("plate", set("r", 7));
  text_with("remeshd_calls_total{code=\"OK\",method=\"EditRevision\"} 1");
  // The worker lets go of its work after the client has the answer.
  const std::string text = text_with("remeshd_computations_running 0");
  for (const char* line : {"remeshd_calls_total{code=\"OK\",method=\"CreateRevision\"} 2",
                           "remeshd_cache_requests_total{result=\"computed\"} 2",
                           "remeshd_phase_seconds_count{phase=\"total\"} 2",
                           "remeshd_reuse_ratio_count 1", "remeshd_revisions 2", "remeshd_ready 1",
                           "remeshd_queue_depth{lane=\"computation\"} 0", "remeshd_connections 1"})
    EXPECT_THAT(text, HasSubstr(std::string(line) + '\n'));
  EXPECT_THAT(text, Not(HasSubstr("remeshd_disk_bytes")));
}

TEST_F(CountedCalls, TellHowLongWorkWaitedInEachLane) {
  create(plate());
  list();
  for (const char* lane : {"metadata", "preparation", "computation"})
    text_with("remeshd_queue_wait_seconds_count{lane=\"" + std::string(lane) + "\"} 1");
  for (const char* lane : {"metadata", "preparation", "computation"})
    text_with("remeshd_queue_depth{lane=\"" + std::string(lane) + "\"} 0");
}

TEST_F(CountedCalls, TellWhereRevisionsCameFromAndWhichWentForWantOfRoom) {
  use_store();
  options_.cache = 1;  // that is one revision
  const std::string requests = "remeshd_cache_requests_total{result=",
                    gone = "remeshd_evictions_total{from=";
  create(plate());
  create(plate());
  text_with(requests + "\"memory\"} 1");
  // What answered a call may hold its revision for a moment longer, and then it does not go.
  int plates = 1;
  for (; plates < 6 || (plates < 100 && !tells(requests + "\"disk\"}")); ++plates) {
    create(plate(5 + plates));
    create(plate());
  }
  EXPECT_TRUE(tells(requests + "\"disk\"}"));
  EXPECT_TRUE(tells(gone + "\"memory\"}"));

  grpc::ClientContext context;
  v1::CollectGarbageRequest all;
  all.set_disk_bytes(0);
  v1::CollectGarbageResponse collected;
  EXPECT_TRUE(v1::CacheService::NewStub(channel_)->CollectGarbage(&context, all, &collected).ok());
  text_with(gone + "\"disk\"} " + std::to_string(collected.meshes()));
  for (int n = 1; n <= plates; ++n) mesh_bytes("plate@" + std::to_string(n));
  EXPECT_TRUE(tells(requests + "\"remade\"}"));
}

class CountedCrashes : public CountedCalls {
  [[nodiscard]] Engine make_engine() const override {
    Engine engine = CountedCalls::make_engine();
    engine.helper_crashes = [] { return std::uint64_t{3}; };
    return engine;
  }
};

TEST_F(CountedCrashes, OfTheHelperAreTold) {
  info();
  text_with("remeshd_helper_crashes_total 3");
}

TEST_F(CountedCalls, TellTheBudgetOfTheDisk) {
  use_store();
  options_.disk = 1 << 30;
  create(plate());
  text_with("remeshd_disk_budget_bytes 1073741824");
}

TEST_F(CountedCalls, AreThoseThatFailedByTheirCode) {
  v1::RevisionResult result;
  try_edit(edit_request("plank", set("r", 7)), &result);
  text_with("remeshd_calls_total{code=\"NOT_FOUND\",method=\"EditRevision\"} 1");
}

TEST_F(CountedCalls, AreTheRequestsOfAStreamAndTheStreamItself) {
  grpc::ClientContext context;
  const auto stream = stub().EditStream(&context);
  v1::EditStreamRequest request;
  v1::EditStreamResponse reply;
  *request.mutable_create() = create_request(plate());
  ASSERT_TRUE(stream->Write(request));
  do ASSERT_TRUE(stream->Read(&reply));
  while (reply.has_progress());
  text_with("remeshd_calls_total{code=\"OK\",method=\"EditStream.request\"} 1");
  text_with("remeshd_streams 1");
  EXPECT_EQ(info().load().streams(), 1U);
  EXPECT_EQ(info().load().connections(), 1U);
  request.Clear();
  ASSERT_TRUE(stream->Write(request));
  do ASSERT_TRUE(stream->Read(&reply));
  while (reply.has_progress());
  text_with("remeshd_calls_total{code=\"INVALID_ARGUMENT\",method=\"EditStream.request\"} 1");
  stream->WritesDone();
  EXPECT_FALSE(stream->Read(&reply));
  EXPECT_TRUE(stream->Finish().ok());
  text_with("remeshd_streams 0");
  EXPECT_EQ(info().load().streams(), 0U);
  text_with("remeshd_calls_total{code=\"OK\",method=\"EditStream\"} 1");
}

TEST_F(CountedCalls, AreRefusalsByTheirReason) {
  options_.workers = 1;
  options_.queue = 0;
  start();
  engine_.close_gate();
  grpc::ClientContext context;
  const auto stream = stub().EditStream(&context);
  v1::EditStreamRequest request;
  *request.mutable_create() = create_request(plate());
  ASSERT_TRUE(stream->Write(request));
  ASSERT_TRUE(engine_.wait_at_gate(1));
  v1::RevisionResult result;
  EXPECT_FALSE(try_create(create_request(plate(7)), &result).ok());
  const std::string text = text_with("remeshd_refusals_total{reason=\"BUSY\"} 1");
  EXPECT_THAT(text, HasSubstr("remeshd_computations_running 1\n"));
}

TEST_F(CountedCalls, AreReadNoMoreFromADaemonThatHasEnded) {
  start();
  text_with("remeshd_ready 1");
  daemon_->shutdown();
  EXPECT_THAT(options_.metrics->text(), Not(HasSubstr("remeshd_ready")));
}

}  // namespace
}  // namespace remeshd::test

#include "server/service/verify_call.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "server/limits.h"
#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

/// Keeps all threads of the lane of preparations until its end.
class BusyLane {
 public:
  explicit BusyLane(Session& session) {
    const std::shared_future<void> freed = free_.get_future();
    for (int i = 0; i < limits::kPreparationThreads; ++i)
      session.later(Lane::Preparation,
                    {.run = [freed] { freed.wait(); }, .refused = [](const Error&) {}});
  }
  ~BusyLane() { free_.set_value(); }
  BusyLane(const BusyLane&) = delete;
  BusyLane& operator=(const BusyLane&) = delete;

 private:
  std::promise<void> free_;
};

remesh::v1::VerifyCacheResponse large_message() {
  remesh::v1::VerifyCacheResponse out;
  out.mutable_finding()->set_what(std::string(limits::kUntakenBytes, 'x'));
  return out;
}

TEST(VerifyingTheCache, WaitsForAClientThatDoesNotReadAndKeepsNoThreadMeanwhile) {
  const FakeEngine fake;
  const StoreFolder folder;
  const auto session = only_session(fake.engine(), folder.open());
  const Answer made;
  session->make(CreateCommand{.source = model_of({block("plate", 80, 40, 10)}),
                              .options = {.nodes = 100},
                              .design = "plate"},
                made.listener());
  ASSERT_TRUE(made.came());

  grpc::CallbackServerContext context;
  const auto stream = MessageStream::start(
      &context, std::make_shared<CallRecord>(std::make_shared<FrontDesk>(), "M", context));
  {
    const BusyLane busy(*session);
    stream->send(large_message());  // which the client leaves where it is
    verify_cache(stream, *session, {});
    stream->OnWriteDone(true);  // now it has taken it
    EXPECT_TRUE(stream->all_taken()) << "nothing else was sent";
  }
  for (int k = 0; k < 10000 && stream->all_taken(); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_FALSE(stream->all_taken()) << "the result was sent";
  stream->OnWriteDone(true);
  stream->OnDone();
}

}  // namespace
}  // namespace remeshd::test

#include "remeshd/client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

#include "tests/client/fake_service.h"

namespace remeshd::client {
namespace {

using remesh::v1::Error;
using testing::SizeIs;

remesh::v1::EditRevisionRequest edit_of(const std::string& base, const std::string& id = "") {
  remesh::v1::EditRevisionRequest request;
  request.set_base(base);
  request.set_request_id(id);
  return request;
}

Error::Code code_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const CallError& e) {
    return e.code();
  }
  return Error::OK;
}

TEST(Client, FetchesTheMeshThatTheDaemonHas) {
  FakeDaemon daemon;
  daemon.service.mesh = sample_mesh(3);
  std::uint64_t last = 0;
  std::uint64_t all = 1;
  const Mesh mesh = Client::connect(daemon.address)
                        .get_mesh("d@1", {}, [&](std::uint64_t done, std::uint64_t total) {
                          EXPECT_GE(done, last);
                          last = done;
                          all = total;
                        });
  EXPECT_EQ(mesh, daemon.service.mesh);
  EXPECT_EQ(last, all);
}

TEST(Client, RefusesAMeshWithAWrongChecksum) {
  FakeDaemon daemon;
  daemon.service.damage = [](auto& messages) { messages[1].mutable_part()->set_crc32c(1); };
  EXPECT_EQ(code_of([&] { (void)Client::connect(daemon.address).get_mesh("d"); }),
            Error::DATA_LOSS);
}

TEST(Client, ThrowsTheErrorThatTheStatusCarriesInItsDetails) {
  FakeDaemon daemon;
  Error sent = make_error(Error::INVALID_ARGUMENT, "DegenerateFeature");
  sent.set_stage("model");
  sent.set_feature("hole1");
  sent.set_parameter("radius");
  sent.set_hint("make it larger");
  sent.set_edit_index(2);
  daemon.service.failure = sent;
  try {
    (void)Client::connect(daemon.address).types();
    FAIL() << "no error";
  } catch (const CallError& e) {
    EXPECT_EQ(e.detail().SerializeAsString(), sent.SerializeAsString());
    EXPECT_STREQ(e.what(),
                 "edit 2, feature hole1, parameter radius: told by the test (make it larger)");
  }
}

TEST(Client, SaysUnavailableWhereNobodyListens) {
  std::string address;
  { address = FakeDaemon().address; }
  const Client client = Client::connect(address);
  EXPECT_EQ(code_of([&] { (void)client.info(); }), Error::UNAVAILABLE);
  EXPECT_EQ(code_of([&] { client.stream().edit(edit_of("d")).get(); }), Error::UNAVAILABLE);
}

TEST(Client, ListsAllPages) {
  FakeDaemon daemon;
  daemon.service.page = 2;
  for (int k = 1; k <= 5; ++k) {
    auto& revision = daemon.service.revisions.emplace_back();
    revision.set_design("d");
    revision.set_number(static_cast<std::uint32_t>(k));
  }
  const auto revisions = Client::connect(daemon.address).list();
  ASSERT_THAT(revisions, SizeIs(5));
  EXPECT_EQ(revisions[4].number(), 5U);
}

TEST(EditStream, AnswersPipelinedRequestsEachByItsOwnFuture) {
  FakeDaemon daemon;
  daemon.service.stream_errors[1] = make_error(Error::FAILED_PRECONDITION, "EmptyModel");
  std::atomic<int> events = 0;
  EditStream stream = Client::connect(daemon.address)
                          .stream([&](const std::string& id, const remesh::v1::Progress& progress) {
                            EXPECT_FALSE(id.empty());
                            EXPECT_EQ(progress.stage(), "optimise");
                            ++events;
                          });
  auto first = stream.edit(edit_of("a"));
  auto second = stream.edit(edit_of("b"));
  auto third = stream.edit(edit_of("c"));
  stream.finish();
  EXPECT_EQ(first.get().revision().id(), "rev-1");
  EXPECT_EQ(code_of([&] { second.get(); }), Error::FAILED_PRECONDITION);
  EXPECT_EQ(third.get().revision().parent(), "c");
  EXPECT_EQ(events, 3);
}

TEST(EditStream, CancelsOneRequestByItsIdAndLivesOn) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  EditStream stream = Client::connect(daemon.address).stream();
  auto stuck = stream.edit(edit_of("a", "stuck"));
  auto next = stream.edit(edit_of("b"));
  stream.cancel("stuck");
  EXPECT_EQ(code_of([&] { stuck.get(); }), Error::CANCELLED);
  EXPECT_EQ(next.get().revision().id(), "rev-2");
}

TEST(EditStream, RefusesARequestIdThatIsUnderWay) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  EditStream stream = Client::connect(daemon.address).stream();
  auto stuck = stream.edit(edit_of("a", "same"));
  EXPECT_THROW((void)stream.edit(edit_of("a", "same")), std::invalid_argument);
}

TEST(EditStream, IsBrokenOffByAStopRequest) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  std::stop_source source;
  EditStream stream = Client::connect(daemon.address).stream({}, {.stop = source.get_token()});
  auto stuck = stream.edit(edit_of("a"));
  source.request_stop();
  EXPECT_EQ(code_of([&] { stuck.get(); }), Error::CANCELLED);
  EXPECT_EQ(code_of([&] { stream.finish(); }), Error::CANCELLED);
}

TEST(EditStream, GivesEveryOpenRequestTheErrorThatBrokeIt) {
  FakeDaemon daemon;
  daemon.service.stream_failure = make_error(Error::UNAUTHENTICATED, "NoCertificate");
  EditStream stream = Client::connect(daemon.address).stream();
  auto answer = stream.edit(edit_of("a"));
  EXPECT_EQ(code_of([&] { answer.get(); }), Error::UNAUTHENTICATED);
  EXPECT_EQ(code_of([&] { stream.edit(edit_of("b")).get(); }), Error::UNAUTHENTICATED);
  EXPECT_EQ(code_of([&] { stream.finish(); }), Error::UNAUTHENTICATED);
}

TEST(EditStream, CanBeLeftWithRequestsUnderWay) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  std::future<remesh::v1::RevisionReply> answer;
  {
    EditStream stream = Client::connect(daemon.address).stream();
    answer = stream.edit(edit_of("a"));
  }
  EXPECT_EQ(code_of([&] { answer.get(); }), Error::CANCELLED);
}

TEST(Client, GivesACallUpAfterItsTimeout) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  EditStream stream = Client::connect(daemon.address).stream({}, {.stop = {}, .timeout = 0.2});
  EXPECT_EQ(code_of([&] { stream.edit(edit_of("a")).get(); }), Error::DEADLINE_EXCEEDED);
}

}  // namespace
}  // namespace remeshd::client

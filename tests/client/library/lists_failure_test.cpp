#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "client/library/search.h"
#include "tests/client/library/lists_fixture.h"

namespace remeshd::client {
namespace {

using remesh::v1::Error;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using Clock = std::chrono::steady_clock;

class ListsBroken : public Lists, public testing::WithParamInterface<grpc::Status> {};

TEST_P(ListsBroken, WhereOneDoesNotAnswerTheNextInRankDoes) {
  const Client client = connect();
  EditStream stream = client.stream();
  stream.edit(edit()).get();
  stream.finish();
  first().gone = GetParam();
  first().file_messages = second().file_messages;
  stream = client.stream();
  EXPECT_EQ(stream.edit(edit("plate@2")).get().revision().parent(), "plate@2");
  stream.finish();
  EXPECT_EQ(client.get_mesh("plate"), second().mesh);
  EXPECT_EQ(client.get_revision("plate").revision().id(), "id-of-plate");
  EXPECT_EQ(client.edit_revision(edit("plate@2")).revision().id(), "rev-2");
  EXPECT_THAT(third().keys, IsEmpty());
  EXPECT_THAT(second().keys, SizeIs(4));
}

INSTANTIATE_TEST_SUITE_P(All, ListsBroken,
                         testing::Values(kReset,
                                         grpc::Status(grpc::StatusCode::UNAVAILABLE, "gone"),
                                         grpc::Status(grpc::StatusCode::CANCELLED, "ending"),
                                         grpc::Status(grpc::StatusCode::UNKNOWN, "Stream removed"),
                                         grpc::Status(grpc::StatusCode::UNKNOWN,
                                                      "Received http2 header with status: 500"),
                                         status_of(starting(0.4))));

TEST_F(Lists, WhatTheDaemonItselfFindsWrongIsAnError) {
  first().failure = make_error(Error::CODE_INTERNAL, Error::INTERNAL);
  EXPECT_EQ(error_told_by([&] { (void)connect().get_mesh("plate"); }).reason(), Error::INTERNAL);
  first().gone = grpc::Status(grpc::StatusCode::INTERNAL, "a fault of the daemon");
  EXPECT_EQ(error_told_by([&] { (void)connect().get_mesh("plate"); }).code(), Error::CODE_INTERNAL);
  EXPECT_THAT(calls(), ElementsAre(2, 0, 0));
}

TEST_F(Lists, WhatABalancerSaysIsAnAnswerThoughNoDaemonGaveOneYet) {
  first().gone = grpc::Status(grpc::StatusCode::UNAVAILABLE, "no replica is available");
  std::jthread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    first().gone.reset();
  });
  EXPECT_EQ(Client::connect(ranked_[0]->address).get_revision("plate").revision().number(), 7U);
  later.join();
}

TEST_F(Lists, ATransferGoesOnAtTheNextFromWhereItBroke) {
  first().mesh_break = 3;  // the header and two parts
  EXPECT_EQ(connect().get_mesh("plate"), first().mesh);
  ASSERT_THAT(second().mesh_requests, SizeIs(1));
  EXPECT_TRUE(second().mesh_requests[0].has_resume_from());
  EXPECT_THAT(calls(), ElementsAre(1, 1, 0));
}

TEST_F(Lists, AStreamGoesOnAtTheNextWithAllThatIsUnanswered) {
  first().stream_break = 1;
  EditStream stream = connect().stream();
  auto one = stream.edit(edit("plate@1"));
  auto two = stream.edit(edit("plate@2"), MeshWanted{});
  auto three = stream.edit(edit(""));
  EXPECT_EQ(one.get().revision().parent(), "plate@1");
  EXPECT_EQ(two.result.get().revision().parent(), "plate@2");
  EXPECT_EQ(*two.mesh.get(), second().mesh);
  EXPECT_EQ(three.get().revision().number(), 2U) << "the second of that stream";
  stream.finish();
  EXPECT_THAT(third().keys, IsEmpty());
}

TEST_F(Lists, AStreamWhoseDaemonIsNotAvailableMovesInOrder) {
  first().stream_error = starting(5);
  EditStream stream = connect().stream();
  std::vector<std::future<remesh::v1::RevisionResult>> answers;
  for (int k = 1; k < 6; ++k) answers.push_back(stream.edit(edit("plate@" + std::to_string(k))));
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const auto result = answers[k].get();
    EXPECT_EQ(result.revision().number(), k + 1);
    EXPECT_EQ(result.revision().parent(), "plate@" + std::to_string(k + 1));
  }
  stream.finish();
  EXPECT_THAT(second().requests, SizeIs(5));
  EXPECT_THAT(third().requests, IsEmpty());
}

TEST_F(Lists, OneThatWasAwayIsAskedAgainAfterAWhile) {
  const Client client = connect();
  first().gone = kReset;
  (void)client.get_revision("plate");
  first().gone.reset();
  (void)client.get_revision("plate");
  EXPECT_THAT(calls(), ElementsAre(1, 2, 0));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  (void)client.get_revision("plate");
  EXPECT_THAT(calls(), ElementsAre(2, 2, 0));
}

TEST_F(Lists, WhatChangesSomethingIsNotAskedTwiceWhereItMayHaveBeenDone) {
  const Client client = connect();
  remesh::v1::SetHeadRequest head;
  head.set_revision("plate@1");
  first().gone = kReset;
  EXPECT_EQ(error_told_by([&] { (void)client.set_head(head); }).code(), Error::CODE_INTERNAL);
  EXPECT_EQ(error_told_by([&] { (void)client.edit_revision(edit("plate")); }).code(),
            Error::CODE_INTERNAL);
  EXPECT_THAT(calls(), ElementsAre(2, 0, 0));
  first().gone.reset();
  first().failure = starting(5);  // it says that it has not
  EXPECT_EQ(client.set_head(head).design().head_number(), 2U);
  EXPECT_THAT(calls(), ElementsAre(3, 1, 0));
}

TEST(ListsWithOneThatIsNotThere, AskTheOthersOfWhatChangesSomethingToo) {
  FakeDaemon daemon;
  const Client client = Client::connect("127.0.0.1:1, " + daemon.address + ",unix:/nowhere");
  remesh::v1::SetHeadRequest head;
  for (int k = 0; k < 8; ++k) {
    head.set_revision("plate" + std::to_string(k));
    EXPECT_EQ(client.set_head(head).design().head_number(), 2U);
    EXPECT_EQ(client.get_revision(head.revision()).revision().number(), 7U);
  }
  EXPECT_THAT(daemon.service.heads, SizeIs(8));
}

TEST_F(Lists, PatienceBoundsItAll) {
  const Client client = connect();
  (void)client.get_revision("plate");
  for (FakeDaemon* daemon : ranked_) daemon->service.gone = kReset;
  CallOptions options;
  options.reconnect = 1.5;
  const auto begun = Clock::now();
  EXPECT_EQ(error_told_by([&] { (void)client.get_revision("plate", options); }).code(),
            Error::CODE_INTERNAL);
  EXPECT_GT(Clock::now() - begun, std::chrono::milliseconds(900));
  EXPECT_LT(Clock::now() - begun, std::chrono::seconds(4));
  EXPECT_THAT(calls(), ElementsAre(3, 2, 2));
}

TEST(Search, IsPatientAnewAfterWhatWasHeard) {
  CallOptions options;
  options.reconnect = 0.3;
  for (const bool heard : {false, true}) {
    Search search(farm_of({"a:1", "b:2", "c:3"}), "plate", options);
    const auto goes_on = [&] { return search.goes_on(search.replica(), starting(0.1)); };
    EXPECT_TRUE(goes_on());
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    if (heard) search.heard(search.replica());
    EXPECT_TRUE(goes_on());
    EXPECT_TRUE(goes_on());
    EXPECT_EQ(goes_on(), heard) << "all are away";
  }
}

TEST_F(Lists, ATimeoutBoundsTheWaitingToo) {
  const Client client = connect();
  for (FakeDaemon* daemon : ranked_) daemon->service.failure = starting(20);
  CallOptions options;
  options.timeout = 1;
  const auto begun = Clock::now();
  EXPECT_EQ(error_told_by([&] { (void)client.get_revision("plate", options); }).reason(),
            Error::STARTING);
  EXPECT_LT(Clock::now() - begun, std::chrono::seconds(2));
}

TEST_F(Lists, AStopRequestEndsTheWaiting) {
  const Client client = connect();
  (void)client.get_revision("plate");
  for (FakeDaemon* daemon : ranked_) daemon->service.gone = kReset;
  std::stop_source source;
  EditStream stream = client.stream({}, {.stop = source.get_token()});
  auto answer = stream.edit(edit());
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const auto begun = Clock::now();
  source.request_stop();
  EXPECT_THROW(answer.get(), CallError);
  EXPECT_LT(Clock::now() - begun, std::chrono::milliseconds(600));
}

TEST(ListsOfStrangers, AreNotWaitedFor) {
  CallOptions options;
  options.reconnect = 3600;
  const Client client = Client::connect("127.0.0.1:1,127.0.0.1:2");
  EXPECT_EQ(error_told_by([&] { (void)client.info(options); }).code(), Error::CODE_UNAVAILABLE);
}

TEST_F(Lists, AListComesFromOneDaemonWhole) {
  for (FakeDaemon* daemon : ranked_) {
    daemon->service.page = 2;
    for (std::uint32_t k = 1; k <= 5; ++k) {
      auto& revision = daemon->service.revisions.emplace_back();
      revision.set_design("plate");
      revision.set_number(k + (daemon == ranked_[1] ? 100 : 0));
    }
  }
  first().list_break = 2;
  const auto revisions = connect().log("plate");
  ASSERT_THAT(revisions, SizeIs(5));
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(revisions[k].number(), 101 + k);
}

}  // namespace
}  // namespace remeshd::client

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <thread>

#include "client/library/routes.h"
#include "client/library/search.h"
#include "proto/checksum.h"
#include "tests/client/library/lists_fixture.h"

namespace remeshd::client {
namespace {

using remesh::v1::Error;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

TEST(Rank, IsThatOfTheClientForPython) {  // whose test has the same lines
  const auto farm = farm_of({"a:1", "b:2", "unix:/c"});
  const std::map<std::string, std::string> expected{{"bracket", "a:1"},
                                                    {"valve", "b:2"},
                                                    {"", "a:1"},
                                                    {"r", "unix:/c"},
                                                    {std::string(64, '0'), "b:2"}};
  for (const auto& [route, address] : expected)
    EXPECT_EQ(Search(farm, route, {}).replica().address, address) << route;
}

TEST(Route, OfAFirstMeshIsTheDesignThatItJoinsElseItsOwn) {
  remesh::v1::CreateRevisionRequest request;
  request.mutable_model()->set_name("plate");
  EXPECT_EQ(route_of(request), "plate");
  request.set_design("mine");
  EXPECT_EQ(route_of(request), "mine");
  request.clear_design();
  request.set_document(R"({"features": [], "name": "valve"})");
  EXPECT_EQ(route_of(request), "valve");
  request.set_document(R"({"features": []})");
  EXPECT_EQ(route_of(request), "model");
  request.mutable_head()->set_file(false);
  const std::string own = route_of(request);
  EXPECT_THAT(own, SizeIs(64));
  request.set_request_id("another");
  EXPECT_EQ(route_of(request), own);
  request.mutable_options()->set_seed(7);
  EXPECT_NE(route_of(request), own);
}

TEST_F(Lists, AllRequestsOfALoopGoToOneDaemonWithTheKeyOfItsRoute) {
  const Client client = connect();
  remesh::v1::CreateRevisionRequest create;
  create.mutable_model()->set_name("plate");
  (void)client.create_revision(create);
  EditStream stream = client.stream();
  stream.edit(edit()).get();
  stream.edit(edit("")).get();
  stream.finish();
  (void)client.get_mesh("plate@2");
  (void)client.get_revision("plate");
  (void)client.log("plate");
  EXPECT_THAT(calls(), ElementsAre(5, 0, 0));
  EXPECT_THAT(first().keys, Each(sha256_hex("plate").substr(0, 16)));
}

TEST_F(Lists, TheKeyIsSentToOneDaemonAloneToo) {
  (void)Client::connect(ranked_[1]->address).get_revision("valve@2");
  EXPECT_THAT(second().keys, ElementsAre(sha256_hex("valve").substr(0, 16)));
}

TEST_F(Lists, ARouteOfTheCallersComesFirst) {
  CallOptions options;
  options.route = "mine";
  const Client client = Client::connect(ranked_[1]->address);
  (void)client.get_revision("plate", options);
  client.stream({}, options).edit(edit()).get();
  EXPECT_THAT(second().keys, AllOf(SizeIs(2), Each(sha256_hex("mine").substr(0, 16))));
}

TEST_F(Lists, ARevisionNamedByItsIdHasTheRouteOfItsDesignOrItsRoot) {
  for (const bool filed : {true, false}) {
    remesh::v1::RevisionInfo info;
    info.set_id(kId);
    info.set_root(std::string(64, 'b'));
    if (filed) info.set_design("plate");
    for (FakeDaemon* daemon : ranked_) daemon->service.infos[kId] = info;
    const Client client = connect();
    EditStream stream = client.stream();
    stream.edit(edit(kId)).get();
    stream.finish();
    (void)client.get_mesh(kId);  // known by now
    std::size_t looked_up = 0;
    for (FakeDaemon* daemon : ranked_) {
      looked_up += daemon->service.looked_up.size();
      daemon->service.looked_up.clear();
    }
    EXPECT_EQ(looked_up, 1U);
    const std::string key = sha256_hex(filed ? info.design() : info.root()).substr(0, 16);
    std::size_t found = 0;
    for (FakeDaemon* daemon : ranked_) {
      found += static_cast<std::size_t>(std::ranges::count(daemon->service.keys, key));
      daemon->service.keys.clear();
    }
    EXPECT_EQ(found, 2U);
  }
}

TEST_F(Lists, WhatOneDoesNotKnowTheOthersAreAsked) {
  const Error unknown = make_error(Error::CODE_NOT_FOUND, Error::REVISION_NOT_FOUND);
  first().failure = first().stream_error = second().failure = second().stream_error = unknown;
  const Client client = connect();
  (void)client.get_revision("plate");
  EditStream stream = client.stream();
  EXPECT_EQ(stream.edit(edit()).get().revision().parent(), "plate@1");
  EXPECT_EQ(stream.edit(edit("")).get().revision().number(), 2U) << "it stays there";
  stream.finish();
  EXPECT_THAT(calls(), ElementsAre(2, 2, 2));
  third().failure = third().stream_error = unknown;
  EXPECT_EQ(error_told_by([&] { (void)client.get_mesh("plate"); }).reason(),
            Error::REVISION_NOT_FOUND);
  EXPECT_EQ(error_told_by([&] { client.stream().edit(edit()).get(); }).reason(),
            Error::REVISION_NOT_FOUND);
  EXPECT_THAT(calls(), ElementsAre(4, 4, 4));
}

TEST_F(Lists, ADesignIsAskedForWhereItLives) {
  first().failure = first().stream_error = elsewhere(ranked_[2]->address);
  const Client client = connect();
  EditStream stream = client.stream();
  EXPECT_EQ(stream.edit(edit("plate")).get().revision().parent(), "plate");
  EXPECT_EQ(stream.edit(edit("")).get().revision().number(), 2U);
  stream.finish();
  EXPECT_THAT(streamed(), ElementsAre(1, 0, 2));
  (void)client.get_revision("plate");
  remesh::v1::SetHeadRequest head;
  head.set_revision("plate@1");
  (void)client.set_head(head);
  EXPECT_THAT(calls(), ElementsAre(1, 0, 3)) << "its home is remembered";
}

TEST_F(Lists, AChangeOfADesignIsSentToItsHome) {
  first().failure = elsewhere(ranked_[2]->address);
  remesh::v1::SetHeadRequest head;
  head.set_revision("plate@1");
  EXPECT_EQ(connect().set_head(head).design().head_number(), 2U);
  EXPECT_THAT(third().heads, SizeIs(1));
}

TEST_F(Lists, TheHomeOfADesignIsWaitedFor) {
  first().stream_error = elsewhere(ranked_[2]->address);
  third().stream_errors[0] = starting(0.1);
  EditStream stream = connect().stream();
  auto answer = stream.edit(edit("plate"));
  std::jthread opened([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    third().stream_errors.clear();
  });
  EXPECT_EQ(answer.get().revision().parent(), "plate");
  opened.join();
  EXPECT_THAT(streamed(), ElementsAre(1, 0, 2));
}

TEST_F(Lists, AHomeThatIsNotAmongThemIsTold) {
  first().failure = first().stream_error = elsewhere("10.0.0.9:50051");
  const Client client = connect();
  for (const auto& call : std::vector<std::function<void()>>{
           [&] { (void)client.get_revision("plate"); },
           [&] { client.stream().edit(edit("plate")).get(); },
           [&] { (void)Client::connect(ranked_[0]->address).get_revision("plate"); }}) {
    const Error told = error_told_by(call);
    EXPECT_EQ(told.reason(), Error::DESIGN_ELSEWHERE);
    EXPECT_THAT(describe(told), HasSubstr("daemon 10.0.0.9:50051"));
  }
  EXPECT_THAT(calls(), ElementsAre(3, 0, 0));
}

TEST_F(Lists, TwoThatNameEachOtherAsHomeAreAskedOnce) {
  first().failure = first().stream_error = elsewhere(ranked_[1]->address);
  second().failure = second().stream_error = elsewhere(ranked_[0]->address);
  EXPECT_EQ(error_told_by([&] { (void)connect().get_revision("plate"); }).home(),
            ranked_[0]->address);
  EXPECT_EQ(error_told_by([&] { connect().stream().edit(edit("plate")).get(); }).home(),
            ranked_[0]->address);
  EXPECT_THAT(calls(), ElementsAre(2, 2, 0));
}

TEST_F(Lists, TheCacheIsThatOfOneDaemon) {
  const Client client = connect();
  EXPECT_EQ(error_told_by([&] { (void)client.cache_stats(); }).code(),
            Error::CODE_INVALID_ARGUMENT);
  EXPECT_EQ(error_told_by([&] { (void)client.set_pin("plate", true); }).parameter(), "address");
}

TEST_F(Lists, AddressesAreTakenOnceAndOneIsNeeded) {
  const Client client = Client::connect(ranked_[0]->address + ", ," + ranked_[0]->address);
  const Error told = error_told_by([&] { (void)client.cache_stats(); });
  EXPECT_EQ(told.code(), Error::CODE_UNIMPLEMENTED) << "asked of the one that there is";
  EXPECT_EQ(error_told_by([] { (void)Client::connect(" , "); }).code(),
            Error::CODE_INVALID_ARGUMENT);
  EXPECT_EQ(error_told_by([] { (void)Client::connect_any({}); }).code(),
            Error::CODE_INVALID_ARGUMENT);
}

TEST_F(Lists, AStreamWithoutARequestEndsWell) {
  EditStream stream = connect().stream();
  stream.finish();
  EditStream other = connect().stream();
  other.cancel_all();
  EXPECT_EQ(error_told_by([&] { other.edit(edit()).get(); }).code(), Error::CODE_CANCELLED);
  EXPECT_THAT(calls(), ElementsAre(0, 0, 0));
}

}  // namespace
}  // namespace remeshd::client

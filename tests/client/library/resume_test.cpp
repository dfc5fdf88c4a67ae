#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/library/resend.h"
#include "remeshd/client.h"
#include "tests/client/fake_daemon.h"

namespace remeshd::client {
namespace {

using remesh::v1::EditStreamRequest;
using remesh::v1::Error;

EditStreamRequest streamed_edit_of(const std::string& base, const std::string& design = "") {
  EditStreamRequest request;
  request.mutable_edit()->set_base(base);
  request.mutable_edit()->set_design(design);
  return request;
}

remesh::v1::RevisionResult result_of(const std::string& id, const std::string& design) {
  remesh::v1::RevisionResult result;
  result.mutable_revision()->set_id(id);
  result.mutable_revision()->set_design(design);
  return result;
}

TEST(Resend, WhatSaysByItselfWhatItIsMadeOfIsSentAsItIs) {
  const auto last = result_of("0123456789abcdef", "plate");
  EditStreamRequest create;
  create.mutable_create();
  EXPECT_EQ(how_to_resend(create, &last), Resend::AsItIs);
  for (const char* base : {"plate@3", "0123456789", "other@1"})
    EXPECT_EQ(how_to_resend(streamed_edit_of(base), &last), Resend::AsItIs) << base;
}

TEST(Resend, AnEditOfTheHeadIsSentWithTheIdOfTheLastResultAndItsDesign) {
  const auto last = result_of("0123456789abcdef", "plate");
  for (const char* base : {"", "plate"}) {
    ASSERT_EQ(how_to_resend(streamed_edit_of(base), &last), Resend::OnLast) << base;
    const auto sent = on_last(streamed_edit_of(base), last);
    EXPECT_EQ(sent.edit().base(), "0123456789abcdef");
    EXPECT_EQ(sent.edit().design(), "plate");
  }
  EXPECT_EQ(on_last(streamed_edit_of("plate", "mine"), last).edit().design(), "mine");
}

TEST(Resend, WhereTheLastResultDidNotBecomeTheHeadAnEditOfTheHeadIsOfTheHead) {
  auto last = result_of("0123456789abcdef", "plate");
  last.set_head("fedcba9876543210");
  EXPECT_EQ(on_last(streamed_edit_of("plate"), last).edit().base(), "fedcba9876543210");
}

TEST(Resend, AnEditOfTheLastResultByItsIdIsInThatsDesign) {
  const auto last = result_of("0123456789abcdef", "plate");
  EXPECT_EQ(in_design_of_last(streamed_edit_of("0123456789abcdef"), last).edit().design(), "plate");
  EXPECT_EQ(in_design_of_last(streamed_edit_of("0123456789abcdef", "mine"), last).edit().design(),
            "mine");
  EXPECT_EQ(in_design_of_last(streamed_edit_of("fedcba9876543210"), last).edit().design(), "");
}

TEST(Resend, AnEditThatIsToBeInNoDesignStaysInNone) {
  const auto last = result_of("0123456789abcdef", "plate");
  auto edit = streamed_edit_of("0123456789abcdef");
  edit.mutable_edit()->mutable_head()->set_file(false);
  EXPECT_EQ(in_design_of_last(edit, last).edit().design(), "");
  edit.mutable_edit()->clear_base();
  EXPECT_EQ(on_last(edit, last).edit().design(), "");
}

TEST(Resend, AnEditOfAHeadThatTheStreamKnowsNothingOfIsNotSentAgain) {
  const auto last = result_of("0123456789abcdef", "plate");
  EXPECT_EQ(how_to_resend(streamed_edit_of("other"), &last), Resend::Impossible);
  EXPECT_EQ(how_to_resend(streamed_edit_of("", "other"), &last), Resend::Impossible);
  EXPECT_EQ(how_to_resend(streamed_edit_of("plate"), nullptr), Resend::Impossible);
  EXPECT_EQ(how_to_resend(streamed_edit_of("", "plate"), nullptr), Resend::Impossible);
  EXPECT_EQ(how_to_resend(streamed_edit_of(""), nullptr), Resend::AsItIs);
}

remesh::v1::EditRevisionRequest edit_request(const std::string& base,
                                             const std::string& design = "") {
  return streamed_edit_of(base, design).edit();
}

TEST(EditStream, SendsWhatABreakLeftUnansweredAgain) {
  FakeDaemon daemon;
  daemon.service.stream_break = 1;
  EditStream stream = Client::connect(daemon.address).stream();
  EXPECT_EQ(stream.edit(edit_request("a@1")).get().revision().id(), "rev-1");
  auto second = stream.edit(edit_request("a@2"));  // the stream breaks here
  auto third = stream.edit(edit_request("a@3"));
  EXPECT_EQ(second.get().revision().parent(), "a@2");
  EXPECT_EQ(third.get().revision().parent(), "a@3");
  stream.finish();
}

TEST(EditStream, ThatBreaksWhenAllIsAnsweredEndsWell) {
  FakeDaemon daemon;
  daemon.service.stream_break = 1;
  EditStream stream = Client::connect(daemon.address).stream();
  EXPECT_EQ(stream.edit(edit_request("a@1")).get().revision().id(), "rev-1");
  EXPECT_NO_THROW(stream.finish());  // the stream breaks here
  EXPECT_EQ(daemon.service.requests.size(), 1U);
}

TEST(EditStream, BehindABreakAnEditOfAHeadWaitsForTheResultsBeforeIt) {
  FakeDaemon daemon;
  daemon.service.stream_break = 1;
  daemon.service.broken_off = 3;
  EditStream stream = Client::connect(daemon.address).stream();
  EXPECT_EQ(stream.edit(edit_request("a@1")).get().revision().design(), "d");
  remesh::v1::CreateRevisionRequest create;
  create.mutable_model()->set_name("e");
  auto other = stream.create(create);
  auto of_the_first = stream.edit(edit_request("d"));
  auto of_the_other = stream.edit(edit_request("e"));  // the stream breaks here
  const remesh::v1::RevisionResult of_e = other.get();
  EXPECT_EQ(of_e.revision().design(), "e");
  EXPECT_THROW(of_the_first.get(), CallError) << "the last result is in another design by now";
  EXPECT_EQ(of_the_other.get().revision().parent(), of_e.revision().id());
}

TEST(EditStream, BehindABreakAnEditWithoutABaseIsOfTheLastResultUnlessItNamesADesign) {
  for (const std::string design : {"", "mine"}) {
    FakeDaemon daemon;
    daemon.service.stream_break = 1;
    EditStream stream = Client::connect(daemon.address).stream();
    EXPECT_EQ(stream.edit(edit_request("a@1")).get().revision().design(), "d");
    // Breaks the stream, and cannot be sent again: the new one has had no request yet.
    EXPECT_THROW(stream.edit(edit_request("other")).get(), CallError);
    stream.edit(edit_request("", design)).get();
    EXPECT_EQ(daemon.service.requests.back().edit().base(), design.empty() ? "d" : "");
    EXPECT_EQ(daemon.service.requests.back().edit().design(), design);
  }
}

TEST(EditStream, BehindABreakAnEditOfTheLastResultByItsIdNamesItsDesign) {
  FakeDaemon daemon;
  daemon.service.stream_break = 1;
  EditStream stream = Client::connect(daemon.address).stream();
  EXPECT_EQ(stream.edit(edit_request("a@1")).get().revision().design(), "d");
  EXPECT_THROW(stream.edit(edit_request("other")).get(), CallError);  // breaks the stream
  stream.edit(edit_request("rev-1")).get();
  EXPECT_EQ(daemon.service.requests.back().edit().design(), "d");
}

TEST(EditStream, ARequestThatWasCancelledBeforeABreakIsNotSentAgain) {
  FakeDaemon daemon;
  daemon.service.stream_break = 1;
  daemon.service.broken_off = 2;  // the request and its cancellation
  EditStream stream = Client::connect(daemon.address).stream();
  EXPECT_EQ(stream.edit(edit_request("a@1")).get().revision().id(), "rev-1");
  auto unwanted = edit_request("a@2");
  unwanted.set_request_id("unwanted");
  auto answer = stream.edit(unwanted);
  stream.cancel("unwanted");  // the stream breaks here
  try {
    static_cast<void>(answer.get());
    ADD_FAILURE() << "it was carried out";
  } catch (const CallError& e) {
    EXPECT_EQ(e.code(), Error::CODE_CANCELLED);
  }
  EXPECT_EQ(stream.edit(edit_request("a@3")).get().revision().parent(), "a@3");
  stream.finish();
  EXPECT_EQ(daemon.service.requests.size(), 4U) << "three edits and a cancellation";
}

TEST(GetMesh, GoesOnWhereItBroke) {
  FakeDaemon daemon;
  daemon.service.mesh_break = 3;  // the header and two parts
  std::uint64_t done = 0, total = 0;
  const auto note = [&](std::uint64_t d, std::uint64_t t) {
    done = d;
    total = t;
  };
  const Mesh mesh = Client::connect(daemon.address).get_mesh("a", {}, note);
  EXPECT_EQ(mesh, daemon.service.mesh);
  EXPECT_EQ(done, total);
  EXPECT_GT(daemon.service.mesh_requests.size(), 3U);
  EXPECT_TRUE(daemon.service.mesh_requests.back().has_resume_from());
}

TEST(GetMesh, IsThereWhereItBrokeAfterTheEndOfTheMesh) {
  FakeDaemon daemon;
  daemon.service.breaks_after_mesh = true;
  EXPECT_EQ(Client::connect(daemon.address).get_mesh("a"), daemon.service.mesh);
  EXPECT_EQ(daemon.service.mesh_requests.size(), 1U);
}

TEST(GetMesh, OfAnotherMeshThanBeforeItBrokeIsDamage) {
  FakeDaemon daemon;
  daemon.service.mesh_break = 2;
  int transfers = 0;
  daemon.service.damage = [&](std::vector<remesh::v1::MeshMessage>& messages) {
    if (++transfers > 1) messages.front().mutable_header()->set_model_name("another");
  };
  try {
    (void)Client::connect(daemon.address).get_mesh("a");
    FAIL() << "accepted";
  } catch (const CallError& e) {
    EXPECT_EQ(e.reason(), Error::MESH_DAMAGED);
  }
}

TEST(GetMesh, WaitsBetweenTries) {
  FakeDaemon daemon;
  const Client client = Client::connect(daemon.address);
  (void)client.get_mesh("a");  // one that never answered would not be asked again
  daemon.service.mesh_break = 0;
  CallOptions briefly;
  briefly.reconnect = 0.5;
  EXPECT_THROW((void)client.get_mesh("a", briefly), CallError);
  EXPECT_GT(daemon.service.mesh_requests.size(), 2U);
  EXPECT_LT(daemon.service.mesh_requests.size(), 7U);
}

TEST(GetMesh, ThatIsCutBehindItsHeaderEachTimeIsGivenUp) {
  FakeDaemon daemon;
  daemon.service.mesh_break = 1;
  CallOptions briefly;
  briefly.timeout = 5;  // else it might be tried for ever
  briefly.reconnect = 0.5;
  EXPECT_THROW((void)Client::connect(daemon.address).get_mesh("a", briefly), CallError);
  EXPECT_GT(daemon.service.mesh_requests.size(), 1U);
  EXPECT_LT(daemon.service.mesh_requests.size(), 7U);
}

TEST(GetMesh, IsGivenUpWhereItIsNotToBeTriedAgain) {
  FakeDaemon daemon;
  daemon.service.mesh_break = 2;
  CallOptions once;
  once.reconnect = 0;
  try {
    (void)Client::connect(daemon.address).get_mesh("a", once);
    FAIL() << "accepted";
  } catch (const CallError& e) {
    EXPECT_EQ(e.code(), Error::CODE_UNAVAILABLE);
  }
  EXPECT_EQ(daemon.service.mesh_requests.size(), 1U);
}

}  // namespace
}  // namespace remeshd::client

#include "remeshd/client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

#include "tests/client/fake_daemon.h"

namespace remeshd::client {
namespace {

using remesh::v1::Error;
using testing::SizeIs;

remesh::v1::EditRevisionRequest filed_edit_of(const std::string& base, const std::string& id = "") {
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
  return Error::CODE_UNSPECIFIED;
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
            Error::CODE_DATA_LOSS);
}

TEST(Client, ThrowsTheErrorThatTheStatusCarriesInItsDetails) {
  FakeDaemon daemon;
  Error sent = make_error(Error::CODE_INVALID_ARGUMENT, Error::DEGENERATE_FEATURE);
  sent.set_stage("model");
  sent.add_features("hole1");
  sent.set_parameter("radius");
  sent.set_hint("make it larger");
  sent.set_edit_index(2);
  for (const double c : {1.5, -2.0, 0.1 + 0.2}) sent.add_point(c);
  daemon.service.failure = sent;
  try {
    (void)Client::connect(daemon.address).types();
    FAIL() << "no error";
  } catch (const CallError& e) {
    EXPECT_EQ(e.detail().SerializeAsString(), sent.SerializeAsString());
    EXPECT_STREQ(e.what(),
                 "edit 2, feature hole1, parameter radius, at (1.5, -2, 0.3): told by the test "
                 "(make it larger)");
    EXPECT_EQ(e.reason(), Error::DEGENERATE_FEATURE);
  }
}

TEST(Client, SaysUnavailableWhereNobodyListens) {
  std::string address;
  { address = FakeDaemon().address; }
  const Client client = Client::connect(address);
  EXPECT_EQ(code_of([&] { (void)client.info(); }), Error::CODE_UNAVAILABLE);
  EXPECT_EQ(code_of([&] { client.stream().edit(filed_edit_of("d")).get(); }),
            Error::CODE_UNAVAILABLE);
}

TEST(Client, ListsAllPages) {
  FakeDaemon daemon;
  daemon.service.page = 2;
  for (int k = 1; k <= 5; ++k) {
    auto& revision = daemon.service.revisions.emplace_back();
    revision.set_design("d");
    revision.set_number(static_cast<std::uint32_t>(k));
  }
  const auto revisions = Client::connect(daemon.address).list_revisions();
  ASSERT_THAT(revisions, SizeIs(5));
  EXPECT_EQ(revisions[4].number(), 5U);
}

TEST(Client, AsksForTheArraysWantedOnly) {
  FakeDaemon daemon;
  const Mesh mesh = Client::connect(daemon.address)
                        .get_mesh("d", {}, {}, {.arrays = {remesh::v1::MESH_ARRAY_TETS}});
  EXPECT_EQ(mesh.tets, daemon.service.mesh.tets);
  EXPECT_THAT(mesh.nodes, SizeIs(0));
  ASSERT_THAT(daemon.service.mesh_requests, SizeIs(1));
  EXPECT_FALSE(daemon.service.mesh_requests[0].selection().delta());
}

TEST(Client, SendsDocumentsAsTheyAre) {
  FakeDaemon daemon;
  remesh::v1::ValidateEditRequest request;
  request.set_base_document("{ \"features\": []}");
  request.set_document("not looked at here");
  EXPECT_EQ(Client::connect(daemon.address).validate(request).volume(), 258000);
  EXPECT_EQ(daemon.service.edit_request.base_document(), request.base_document());
  EXPECT_EQ(daemon.service.edit_request.document(), request.document());
}

TEST(Client, SendsNoDocumentOfMoreThan4MiB) {
  FakeDaemon daemon;
  const Client client = Client::connect(daemon.address);
  const std::string large((std::size_t{4} << 20) + 1, ' ');
  remesh::v1::CreateRevisionRequest create;
  create.set_document(large);
  remesh::v1::EditRevisionRequest edit;
  edit.set_document(large);
  remesh::v1::CompareRequest compare;
  compare.mutable_modified()->set_document(large);
  remesh::v1::ValidateModelRequest model;
  model.set_document(large);
  remesh::v1::ValidateEditRequest validate;
  validate.set_base_document(large);
  const std::vector<std::function<void()>> calls{
      [&] { (void)client.create_revision(create); }, [&] { (void)client.edit_revision(edit); },
      [&] { (void)client.compare(compare); },        [&] { (void)client.validate(model); },
      [&] { (void)client.validate(validate); },      [&] { client.stream().create(create).get(); },
      [&] { client.stream().edit(edit).get(); }};
  for (const auto& call : calls) {
    try {
      call();
      ADD_FAILURE() << "sent";
    } catch (const CallError& e) {
      EXPECT_EQ(e.code(), Error::CODE_INVALID_ARGUMENT);
      EXPECT_EQ(e.reason(), Error::DOCUMENT_TOO_LARGE);
    }
  }
  EXPECT_THAT(daemon.service.requests, SizeIs(0));
  EXPECT_FALSE(daemon.service.compare_request.has_modified());
}

TEST(CallError, SaysWhereOnceAndNamesWhatItDoesNotKnow) {
  Error error = make_error(Error::CODE_INVALID_ARGUMENT, Error::UNKNOWN_FIELD);
  error.set_message("unknown field 'radios' of feature 'pin'");
  error.add_features("pin");
  error.add_features("rib");
  error.add_features("hub");
  error.set_line(7);
  error.set_column(12);
  EXPECT_EQ(describe(error),
            "line 7, column 12, features rib, hub: unknown field 'radios' of feature 'pin'");
  EXPECT_EQ(reason_name(error), "UNKNOWN_FIELD");
  error.clear_reason();
  EXPECT_EQ(reason_name(error), "INVALID_ARGUMENT");
  error.set_reason(static_cast<Error::Reason>(12345));
  EXPECT_EQ(reason_name(error), "INVALID_ARGUMENT");
}

TEST(EditStream, AnswersPipelinedRequestsEachByItsOwnFuture) {
  FakeDaemon daemon;
  daemon.service.stream_errors[1] = make_error(Error::CODE_FAILED_PRECONDITION, Error::EMPTY_MODEL);
  std::atomic<int> events = 0;
  EditStream stream = Client::connect(daemon.address)
                          .stream([&](const std::string& id, const remesh::v1::Progress& progress) {
                            EXPECT_FALSE(id.empty());
                            EXPECT_EQ(progress.stage(), "optimise");
                            ++events;
                          });
  auto first = stream.edit(filed_edit_of("a"));
  auto second = stream.edit(filed_edit_of("b"));
  auto third = stream.edit(filed_edit_of("c"));
  stream.finish();
  EXPECT_EQ(first.get().revision().id(), "rev-1");
  EXPECT_EQ(code_of([&] { second.get(); }), Error::CODE_FAILED_PRECONDITION);
  EXPECT_EQ(third.get().revision().parent(), "c");
  EXPECT_EQ(events, 3);
}

TEST(EditStream, CancelsOneRequestByItsIdAndLivesOn) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  EditStream stream = Client::connect(daemon.address).stream();
  auto stuck = stream.edit(filed_edit_of("a", "stuck"));
  auto next = stream.edit(filed_edit_of("b"));
  stream.cancel("stuck");
  EXPECT_EQ(code_of([&] { stuck.get(); }), Error::CODE_CANCELLED);
  EXPECT_EQ(next.get().revision().id(), "rev-2");
}

TEST(EditStream, RefusesARequestIdThatIsUnderWay) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  EditStream stream = Client::connect(daemon.address).stream();
  auto stuck = stream.edit(filed_edit_of("a", "same"));
  EXPECT_THROW((void)stream.edit(filed_edit_of("a", "same")), std::invalid_argument);
}

TEST(EditStream, IsBrokenOffByAStopRequest) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  std::stop_source source;
  EditStream stream = Client::connect(daemon.address).stream({}, {.stop = source.get_token()});
  auto stuck = stream.edit(filed_edit_of("a"));
  source.request_stop();
  EXPECT_EQ(code_of([&] { stuck.get(); }), Error::CODE_CANCELLED);
  EXPECT_EQ(code_of([&] { stream.finish(); }), Error::CODE_CANCELLED);
}

TEST(EditStream, GivesEveryOpenRequestTheErrorThatBrokeIt) {
  FakeDaemon daemon;
  daemon.service.stream_failure =
      make_error(Error::CODE_UNAUTHENTICATED, Error::CREDENTIALS_MISSING);
  EditStream stream = Client::connect(daemon.address).stream();
  auto answer = stream.edit(filed_edit_of("a"));
  EXPECT_EQ(code_of([&] { answer.get(); }), Error::CODE_UNAUTHENTICATED);
  EXPECT_EQ(code_of([&] { stream.edit(filed_edit_of("b")).get(); }), Error::CODE_UNAUTHENTICATED);
  EXPECT_EQ(code_of([&] { stream.finish(); }), Error::CODE_UNAUTHENTICATED);
}

TEST(EditStream, CanBeLeftWithRequestsUnderWay) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  std::future<remesh::v1::RevisionResult> answer;
  {
    EditStream stream = Client::connect(daemon.address).stream();
    answer = stream.edit(filed_edit_of("a"));
  }
  EXPECT_EQ(code_of([&] { answer.get(); }), Error::CODE_CANCELLED);
}

TEST(Client, GivesACallUpAfterItsTimeout) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  EditStream stream = Client::connect(daemon.address).stream({}, {.stop = {}, .timeout = 0.2});
  EXPECT_EQ(code_of([&] { stream.edit(filed_edit_of("a")).get(); }), Error::CODE_DEADLINE_EXCEEDED);
}

}  // namespace
}  // namespace remeshd::client

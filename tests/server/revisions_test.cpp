#include <google/protobuf/util/message_differencer.h>

#include <thread>

#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using google::protobuf::util::MessageDifferencer;
using grpc::StatusCode;
using testing::ElementsAre;

class Revisions : public DaemonTest {};

TEST_F(Revisions, AFirstMeshIsNumberOneAndHeadOfTheDesignNamedLikeTheModel) {
  const auto reply = create(plate());
  EXPECT_EQ(reply.revision().id().size(), 64U);
  EXPECT_EQ(reply.revision().design(), "plate");
  EXPECT_EQ(reply.revision().number(), 1U);
  EXPECT_EQ(reply.revision().parent(), "");
  EXPECT_TRUE(reply.revision().head());
  EXPECT_EQ(reply.head(), reply.revision().id());
  EXPECT_EQ(reply.revision().nodes(), 100U);
  EXPECT_EQ(reply.report().revision(), reply.revision().id());
  EXPECT_EQ(reply.report().nodes(), 100U);
  EXPECT_FALSE(reply.report().cached());
  EXPECT_FALSE(reply.head_conflict());
  EXPECT_GT(reply.revision().created().seconds(), 1600000000);
}

TEST_F(Revisions, AModelWithoutANameMakesTheDesignModel) {
  EXPECT_EQ(create(plate(5, 10, "")).revision().design(), "model");
}

TEST_F(Revisions, TheSameRequestAgainComputesNothingMakesNoNumberAndGivesTheSameBytes) {
  const auto first = create(plate());
  const auto second = create(plate());
  const auto third = create(plate());
  EXPECT_EQ(engine_.made(), 1);
  EXPECT_TRUE(second.report().cached());
  EXPECT_EQ(second.SerializeAsString(), third.SerializeAsString());
  // But for the mark it is the stored report, seconds included.
  auto unmarked = second;
  unmarked.mutable_report()->set_cached(false);
  EXPECT_TRUE(MessageDifferencer::Equals(unmarked, first));
  EXPECT_EQ(list().revisions_size(), 1);
}

// Some may join the computation and some find its mesh made; that those who wait for it are
// answered by it, SessionTest.EightRequestsThatWaitForOneComputationAreAnsweredByIt sees.
TEST_F(Revisions, IdenticalRequestsAtTheSameTimeComputeOnce) {
  start();
  engine_.close_gate();
  std::vector<v1::RevisionResult> replies(8);
  std::vector<std::thread> clients;
  for (auto& reply : replies)
    clients.emplace_back([&] { EXPECT_TRUE(try_create(create_request(plate()), &reply).ok()); });
  ASSERT_TRUE(engine_.wait_at_gate(1));
  engine_.open_gate();
  for (auto& client : clients) client.join();
  EXPECT_EQ(engine_.started(), 1);
  int computed = 0;
  for (const auto& reply : replies) {
    EXPECT_EQ(reply.revision().id(), replies[0].revision().id());
    EXPECT_EQ(reply.revision().number(), 1U);
    computed += reply.report().cached() ? 0 : 1;
  }
  EXPECT_EQ(computed, 1);
}

TEST_F(Revisions, OptionsSeedAndModelAsWrittenChangeTheIdThreadsDoNot) {
  const std::string id = create(plate()).revision().id();
  auto request = create_request(plate());
  request.set_threads(2);
  request.set_request_id("another");
  EXPECT_EQ(create(request).revision().id(), id);
  request.mutable_options()->set_seed(1);  // the default, spelled out
  EXPECT_EQ(create(request).revision().id(), id);
  request.mutable_options()->set_seed(2);
  EXPECT_NE(create(request).revision().id(), id);
  request = create_request(plate(), 101);
  EXPECT_NE(create(request).revision().id(), id);
  // The same shape written otherwise is another document to edit.
  auto written_otherwise = plate();
  parameter(*written_otherwise.mutable_features(1), "radius").set_number_value(5);
  EXPECT_NE(create(written_otherwise).revision().id(), id);
}

TEST_F(Revisions, ThreadsAreThoseAskedForUpToTheLimit) {
  auto request = create_request(plate());
  request.set_threads(2);
  create(request);
  EXPECT_EQ(engine_.threads(), 2);
  request.set_threads(4000000000U);
  request.mutable_options()->set_seed(9);
  create(request);
  EXPECT_EQ(engine_.threads(), 3);
}

TEST_F(Revisions, DumpsGoToAFolderOfTheirRevisionWhereTheyAreWanted) {
  create(plate());
  EXPECT_EQ(engine_.dumps(), "");
  options_.dumps = "/somewhere";
  start();
  const std::string id = create(plate()).revision().id();
  EXPECT_EQ(engine_.dumps(), std::filesystem::path("/somewhere") / id);
}

TEST_F(Revisions, AnEditIsTheChildOfItsBaseAndInheritsItsOptions) {
  auto request = create_request(plate());
  request.mutable_options()->set_iterations(5);
  request.mutable_options()->set_seed(42);
  request.mutable_options()->set_clean_up(false);
  request.mutable_options()->set_inside(v1::INSIDE_TEST_CONTROL_MESH);
  request.mutable_options()->set_start(v1::START_RANDOM);
  request.mutable_options()->set_threshold(0.4);
  request.mutable_options()->set_order(2);
  const auto base = create(request);
  const auto child = edit("plate", set("at", 12));
  EXPECT_EQ(child.revision().parent(), base.revision().id());
  EXPECT_EQ(child.revision().number(), 2U);
  EXPECT_EQ(child.head(), child.revision().id());
  EXPECT_EQ(child.report().nodes_kept(), 50U);

  const auto description = describe("plate@2");
  EXPECT_EQ(description.options().iterations(), 5U);
  EXPECT_EQ(description.options().seed(), 42U);
  EXPECT_FALSE(description.options().clean_up());
  EXPECT_EQ(description.options().inside(), v1::INSIDE_TEST_CONTROL_MESH);
  EXPECT_EQ(description.options().start(), v1::START_RANDOM);
  EXPECT_EQ(description.options().threshold(), 0.4);
  EXPECT_EQ(description.options().order(), 2U);
  // The density is inherited, not the count.
  EXPECT_EQ(description.options().target_case(), v1::MeshOptions::kSize);
  EXPECT_EQ(description.options().size(), 2.5);
  const auto at = [this](const std::string& revision) {
    auto model = describe(revision).model();
    return parameter(model, "at").number_value();
  };
  EXPECT_EQ(at("plate@2"), 12);
  EXPECT_EQ(at("plate@1"), 10);
  EXPECT_THAT(describe("plate@1").children(), ElementsAre(child.revision().id()));
}

TEST_F(Revisions, AMeshThatSaysNothingOfItsSizingIsDescribedWithTheDefaults) {
  create(plate());
  const v1::Sizing sizing = describe("plate").options().sizing();
  EXPECT_FALSE(sizing.even());
  EXPECT_EQ(sizing.edges_per_circle(), 12U);
  EXPECT_EQ(sizing.layers(), 1U);
  EXPECT_EQ(sizing.growth(), 1.3);
}

TEST_F(Revisions, AnEditMaySayOtherwise) {
  create(plate());
  auto request = edit_request("plate", set("at", 12));
  request.mutable_options()->set_nodes(60);
  request.mutable_options()->set_iterations(7);
  const auto reply = edit(request);
  EXPECT_EQ(reply.revision().nodes(), 60U);
  EXPECT_EQ(describe(reply.revision().id()).options().nodes(), 60U);
  EXPECT_EQ(describe(reply.revision().id()).options().iterations(), 7U);
}

TEST_F(Revisions, ABaseIsADesignANumberAnIdOrAPrefixOfEightDigits) {
  const std::string id = create(plate()).revision().id();
  for (const std::string& name :
       {std::string("plate"), std::string("plate@1"), id, id.substr(0, 8), id.substr(0, 20)})
    EXPECT_EQ(describe(name).revision().id(), id) << name;
  for (const auto& [name, code] :
       std::vector<std::pair<std::string, StatusCode>>{{"plank", StatusCode::NOT_FOUND},
                                                       {"plate@2", StatusCode::NOT_FOUND},
                                                       {"plank@1", StatusCode::NOT_FOUND},
                                                       {"plate@x", StatusCode::NOT_FOUND},
                                                       {"plate@", StatusCode::NOT_FOUND},
                                                       {id.substr(0, 7), StatusCode::NOT_FOUND},
                                                       {id + "0", StatusCode::NOT_FOUND},
                                                       {"", StatusCode::INVALID_ARGUMENT}}) {
    v1::RevisionResult reply;
    const auto status = try_edit(edit_request(name, set("at", 12)), &reply);
    EXPECT_EQ(status.error_code(), code) << name;
    EXPECT_FALSE(detail(status).hint().empty() && name != "plank@1") << name;
  }
}

TEST_F(Revisions, ALineSearchTriesEditsOnOneBaseAndKeepsOne) {
  const std::string base = create(plate()).revision().id();
  std::vector<v1::RevisionResult> tries;
  for (const double at : {11.0, 12.0, 13.0}) {
    auto request = edit_request(base, set("at", at));
    request.mutable_head()->set_advance(false);
    tries.push_back(edit(request));
    EXPECT_EQ(tries.back().head(), base);
    EXPECT_FALSE(tries.back().head_conflict());
    EXPECT_FALSE(tries.back().revision().head());
  }
  const auto kept = edit(base, set("at", 12));
  EXPECT_TRUE(kept.report().cached());
  EXPECT_EQ(kept.revision().number(), tries[1].revision().number());
  EXPECT_EQ(kept.head(), tries[1].revision().id());
  EXPECT_EQ(engine_.made(), 4);
}

TEST_F(Revisions, ALostCompareAndSetStillGivesTheRevisionAndTheHead) {
  const std::string base = create(plate()).revision().id();
  const auto winner = edit(base, set("at", 11));
  const auto loser = edit(base, set("at", 12));
  EXPECT_FALSE(winner.head_conflict());
  EXPECT_TRUE(loser.head_conflict());
  EXPECT_EQ(loser.head(), winner.revision().id());
  EXPECT_EQ(loser.head_number(), 2U);
  EXPECT_EQ(loser.revision().number(), 3U);
  // The winner asking again has what it wants.
  EXPECT_FALSE(edit(base, set("at", 11)).head_conflict());
}

TEST_F(Revisions, AFirstMeshSentAgainDoesNotTakeTheHeadBack) {
  create(plate());
  const auto child = edit("plate", set("at", 11));
  const auto again = create(plate());
  EXPECT_EQ(again.head(), child.revision().id());
  EXPECT_FALSE(again.head_conflict());
  // Unless it asks for it.
  auto request = create_request(plate());
  request.mutable_head()->set_expected(again.revision().id());
  request.mutable_head()->set_advance(true);
  const auto lost = create(request);
  EXPECT_EQ(lost.head(), child.revision().id());
  EXPECT_TRUE(lost.head_conflict());
  request.mutable_head()->set_expected(child.revision().id());
  EXPECT_EQ(create(request).head(), again.revision().id());
}

TEST_F(Revisions, OneRevisionMayStandInSeveralDesigns) {
  const auto first = create(plate());
  auto request = create_request(plate());
  request.set_design("other");
  const auto second = create(request);
  EXPECT_EQ(second.revision().id(), first.revision().id());
  EXPECT_EQ(second.revision().design(), "other");
  EXPECT_EQ(second.revision().number(), 1U);
  EXPECT_TRUE(second.report().cached());
  EXPECT_EQ(engine_.made(), 1);
  EXPECT_EQ(describe(first.revision().id()).places_size(), 2);
  EXPECT_EQ(edit("other", set("at", 11)).revision().design(), "other");
  EXPECT_EQ(edit("plate", set("at", 11)).revision().design(), "plate");
  EXPECT_EQ(engine_.made(), 2);
}

TEST_F(Revisions, NamesOfDesignsAreChecked) {
  for (const std::string& name :
       {std::string("a@b"), std::string("a\nb"), std::string(129, 'x'), std::string(64, 'a')}) {
    auto request = create_request(plate());
    request.set_design(name);
    v1::RevisionResult reply;
    const auto status = try_create(request, &reply);
    EXPECT_EQ(status.error_code(), StatusCode::INVALID_ARGUMENT);
    EXPECT_EQ(detail(status).reason(), v1::Error::DESIGN_NAME_INVALID);
  }
}

TEST_F(Revisions, AHeadIsDeletedOnlyIfThatIsAllowedAndTheGreatestNumberLeftFollows) {
  create(plate());
  edit("plate", set("at", 11));
  edit("plate", set("at", 12));
  const auto refused = remove("plate", false);
  EXPECT_EQ(refused.error_code(), StatusCode::FAILED_PRECONDITION);
  EXPECT_EQ(detail(refused).reason(), v1::Error::HEAD_PROTECTED);
  v1::DeleteRevisionResponse removed;
  ASSERT_TRUE(remove("plate", true, &removed).ok());
  EXPECT_TRUE(removed.mesh_deleted());
  EXPECT_EQ(removed.removed(0).number(), 3U);
  EXPECT_EQ(describe("plate").revision().number(), 2U);
}

TEST_F(Revisions, NumbersAreNeverReusedNotEvenInAnEmptiedDesign) {
  create(plate());
  ASSERT_TRUE(remove("plate", true).ok());
  EXPECT_EQ(list().revisions_size(), 0);
  v1::RevisionResult none;
  EXPECT_EQ(detail(try_edit(edit_request("plate", set("at", 1)), &none)).reason(),
            v1::Error::DESIGN_EMPTY);
  EXPECT_EQ(create(plate()).revision().number(), 2U);
  EXPECT_EQ(engine_.made(), 2);
}

TEST_F(Revisions, ChildrenSurviveTheirParent) {
  create(plate());
  const auto child = edit("plate", set("at", 11));
  ASSERT_TRUE(remove("plate@1", false).ok());
  EXPECT_EQ(describe(child.revision().id()).revision().parent(), child.revision().parent());
  EXPECT_EQ(edit(child.revision().id(), set("at", 12)).revision().number(), 3U);
}

TEST_F(Revisions, ANumberIsTakenOutOfItsDesignAloneAnIdOutOfAll) {
  create(plate());
  auto request = create_request(plate());
  request.set_design("other");
  const std::string id = create(request).revision().id();
  v1::DeleteRevisionResponse removed;
  ASSERT_TRUE(remove("plate@1", true, &removed).ok());
  EXPECT_FALSE(removed.mesh_deleted());
  EXPECT_EQ(describe(id).places_size(), 1);
  ASSERT_TRUE(remove(id, true, &removed).ok());
  EXPECT_TRUE(removed.mesh_deleted());
  grpc::ClientContext context;
  v1::GetRevisionRequest gone;
  gone.set_revision(id);
  v1::GetRevisionResponse reply;
  EXPECT_EQ(stub().GetRevision(&context, gone, &reply).error_code(), StatusCode::NOT_FOUND);
}

TEST_F(Revisions, ListsComeInPagesByDesignAndNumber) {
  create(plate(5, 10, "b"));
  create(plate(5, 10, "a"));
  for (const double at : {11.0, 12.0, 13.0}) edit("b", set("at", at));
  std::vector<std::string> seen;
  v1::ListRevisionsRequest request;
  request.set_page_size(2);
  do {
    grpc::ClientContext context;
    v1::ListRevisionsResponse reply;
    ASSERT_TRUE(stub().ListRevisions(&context, request, &reply).ok());
    EXPECT_LE(reply.revisions_size(), 2);
    for (const auto& row : reply.revisions())
      seen.push_back(row.design() + "@" + std::to_string(row.number()) + (row.head() ? "*" : ""));
    request.set_page_token(reply.next_page_token());
  } while (!request.page_token().empty());
  EXPECT_THAT(seen, ElementsAre("a@1*", "b@1", "b@2", "b@3", "b@4*"));

  grpc::ClientContext context;
  v1::ListRevisionsResponse reply;
  request.set_page_token("nonsense");
  EXPECT_EQ(stub().ListRevisions(&context, request, &reply).error_code(),
            StatusCode::INVALID_ARGUMENT);
}

TEST_F(Revisions, DesignsTellTheirHeadAndNextNumber) {
  create(plate(5, 10, "b"));
  const auto child = edit("b", set("at", 11));
  create(plate(5, 10, "a"));
  grpc::ClientContext context;
  v1::ListDesignsResponse reply;
  ASSERT_TRUE(stub().ListDesigns(&context, {}, &reply).ok());
  ASSERT_EQ(reply.designs_size(), 2);
  EXPECT_EQ(reply.designs(0).name(), "a");
  EXPECT_EQ(reply.designs(1).head(), child.revision().id());
  EXPECT_EQ(reply.designs(1).head_number(), 2U);
  EXPECT_EQ(reply.designs(1).revisions(), 2U);
  EXPECT_EQ(reply.designs(1).next_number(), 3U);
}

TEST_F(Revisions, ModelsComeBackAsTheyWereWritten) {
  auto model = plate();
  auto& feature = *model.mutable_features(1);
  feature.set_reference(v1::Feature::CENTRE);
  for (const double axis : {0.0, 0.0, 1.0})
    feature.mutable_placement()->add_z_axis()->set_number_value(axis);
  EXPECT_TRUE(MessageDifferencer::Equals(describe(create(model).revision().id()).model(), model));
}

}  // namespace
}  // namespace remeshd::test

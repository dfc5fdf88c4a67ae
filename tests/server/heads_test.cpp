#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using grpc::StatusCode;

/// Which revision is a design's head, and who may move it.
class Heads : public DaemonTest {
 protected:
  v1::SetHeadResponse set_head(const std::string& revision, const std::string& design = "",
                               const std::string& expected = "") {
    v1::SetHeadResponse reply;
    const auto status = try_set_head(revision, design, expected, &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return reply;
  }
  grpc::Status try_set_head(const std::string& revision, const std::string& design,
                            const std::string& expected, v1::SetHeadResponse* reply) {
    grpc::ClientContext context;
    v1::SetHeadRequest request;
    request.set_revision(revision);
    request.set_design(design);
    request.set_expected(expected);
    return stub().SetHead(&context, request, reply);
  }
  grpc::Status delete_design(const std::string& design, const std::string& expected = "",
                             v1::DeleteDesignResponse* reply = nullptr) {
    grpc::ClientContext context;
    v1::DeleteDesignRequest request;
    request.set_design(design);
    request.set_expected(expected);
    v1::DeleteDesignResponse unused;
    return stub().DeleteDesign(&context, request, reply != nullptr ? reply : &unused);
  }
  static bool has_warning(const v1::RevisionResult& result, v1::Warning::Code code) {
    for (const v1::Warning& warning : result.report().warnings())
      if (warning.code() == code) return true;
    return false;
  }
};

TEST_F(Heads, AreSetToAnyRevisionOfTheirDesign) {
  const std::string first = create(plate()).revision().id();
  const std::string second = edit("plate", set("at", 11)).revision().id();
  const auto back = set_head("plate@1");
  EXPECT_EQ(back.previous(), second);
  EXPECT_EQ(back.design().name(), "plate");
  EXPECT_EQ(back.design().head(), first);
  EXPECT_EQ(back.design().head_number(), 1U);
  EXPECT_EQ(describe("plate").revision().id(), first);
  EXPECT_EQ(set_head(second.substr(0, 10), "plate").design().head(), second);
  EXPECT_EQ(set_head("plate@1", "", second).design().head(), first);
}

TEST_F(Heads, AreNotSetToWhatTheirDesignHasNotNorAgainstExpectation) {
  const std::string first = create(plate()).revision().id();
  create(plate(6, 10, "other"));
  v1::SetHeadResponse reply;
  EXPECT_EQ(detail(try_set_head("other@1", "plate", "", &reply)).reason(),
            v1::Error::REVISION_NOT_FOUND);
  EXPECT_EQ(detail(try_set_head("plate@1", "plank", "", &reply)).reason(),
            v1::Error::DESIGN_NOT_FOUND);
  EXPECT_EQ(detail(try_set_head("", "plate", "", &reply)).reason(), v1::Error::REVISION_MISSING);
  EXPECT_EQ(try_set_head(first, "", "", &reply).error_code(), StatusCode::INVALID_ARGUMENT);
  const auto lost = try_set_head("plate@1", "", std::string(64, '0'), &reply);
  EXPECT_EQ(lost.error_code(), StatusCode::ABORTED);
  EXPECT_EQ(detail(lost).reason(), v1::Error::HEAD_CONFLICT);
}

TEST_F(Heads, AFirstMeshOfOtherContentLeavesThemUnlessItIsToldTo) {
  const std::string first = create(plate()).revision().id();
  auto request = create_request(plate(6));
  const auto kept = create(request);
  EXPECT_EQ(kept.revision().number(), 2U);
  EXPECT_EQ(kept.head(), first);
  EXPECT_FALSE(kept.head_conflict());
  EXPECT_TRUE(has_warning(kept, v1::Warning::HEAD_KEPT));
  EXPECT_FALSE(has_warning(create(plate()), v1::Warning::HEAD_KEPT));
  request.mutable_head()->set_advance(true);
  const auto taken = create(request);
  EXPECT_EQ(taken.head(), taken.revision().id());
  EXPECT_FALSE(has_warning(taken, v1::Warning::HEAD_KEPT));
  // The first revision's model at another density is the design's own.
  const auto finer = create(create_request(plate(), 200));
  EXPECT_EQ(finer.head(), finer.revision().id());
}

TEST_F(Heads, AreRequiredByThoseWhoWouldRatherFailThanFile) {
  const std::string base = create(plate()).revision().id();
  auto request = edit_request("plate@1", set("at", 11));
  request.mutable_head()->set_require(true);
  const auto winner = edit(request);
  EXPECT_EQ(winner.head(), winner.revision().id());
  EXPECT_EQ(edit(request).head(), winner.revision().id()) << "the same request, sent again";
  auto late = edit_request("plate@1", set("at", 12));
  late.mutable_head()->set_require(true);
  v1::RevisionResult result;
  const auto status = try_edit(late, &result);
  EXPECT_EQ(status.error_code(), StatusCode::ABORTED);
  EXPECT_EQ(detail(status).reason(), v1::Error::HEAD_CONFLICT);
  EXPECT_EQ(list().revisions_size(), 2);
}

TEST_F(Heads, AWarningThatIsAnErrorFilesNothing) {
  create(plate());
  auto request = create_request(plate(6));
  request.mutable_options()->add_fail_on(v1::Warning::HEAD_KEPT);
  v1::RevisionResult result;
  const auto status = try_create(request, &result);
  EXPECT_EQ(status.error_code(), StatusCode::FAILED_PRECONDITION);
  EXPECT_EQ(detail(status).reason(), v1::Error::WARNING_IS_ERROR);
  EXPECT_EQ(detail(status).warning().code(), v1::Warning::HEAD_KEPT);
  EXPECT_EQ(list().revisions_size(), 1);
  request.mutable_options()->add_fail_on(static_cast<v1::Warning::Code>(99));
  EXPECT_EQ(detail(try_create(request, &result)).parameter(), "fail_on");
}

TEST_F(Heads, GoWithTheirDesignOfWhichNumbersGoOn) {
  create(plate());
  edit("plate", set("at", 11));
  auto request = create_request(plate());
  request.set_design("other");
  const std::string shared = create(request).revision().id();
  EXPECT_EQ(detail(delete_design("plank")).reason(), v1::Error::DESIGN_NOT_FOUND);
  EXPECT_EQ(detail(delete_design("plate", shared)).reason(), v1::Error::HEAD_CONFLICT);
  v1::DeleteDesignResponse gone;
  ASSERT_TRUE(delete_design("plate", "", &gone).ok());
  EXPECT_EQ(gone.revisions(), 2U);
  EXPECT_EQ(gone.meshes_deleted(), 1U);
  EXPECT_EQ(describe(shared).places_size(), 1);
  v1::RevisionResult none;
  EXPECT_EQ(detail(try_edit(edit_request("plate", set("at", 1)), &none)).code(),
            v1::Error::CODE_NOT_FOUND);
  grpc::ClientContext context;
  v1::ListDesignsResponse designs;
  ASSERT_TRUE(stub().ListDesigns(&context, {}, &designs).ok());
  EXPECT_EQ(designs.designs_size(), 1);
  const auto again = create(plate());
  EXPECT_EQ(again.revision().number(), 3U);
  EXPECT_EQ(again.head(), again.revision().id());
}

TEST_F(Heads, AreNotOfDesignsWhoseNamesLookLikeIds) {
  for (const std::string name : {"deadbeef", "0123456789", "DEADBEEF00"}) {
    auto request = create_request(plate());
    request.set_design(name);
    v1::RevisionResult result;
    EXPECT_EQ(detail(try_create(request, &result)).reason(), v1::Error::DESIGN_NAME_INVALID);
  }
  auto request = create_request(plate());
  request.set_design("deadbee");
  EXPECT_EQ(create(request).revision().design(), "deadbee");
}

TEST_F(Heads, AndTheirRevisionsAreDurableInAStoreAlone) {
  EXPECT_FALSE(create(plate()).durable());
  EXPECT_FALSE(describe("plate").durable());
  use_store();
  start();
  EXPECT_TRUE(create(plate()).durable());
  EXPECT_TRUE(describe("plate").durable());
}

}  // namespace
}  // namespace remeshd::test

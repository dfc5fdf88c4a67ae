#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Lists : public DaemonTest {
 protected:
  /// Designs a and b; b has three edits of its first mesh.
  void SetUp() override {
    first_ = create(create_request(plate(5, 10, "b"), 300)).revision().id();
    create(create_request(plate(5, 10, "a"), 200));
    for (int i = 0; i < 3; ++i) {
      auto request = edit_request("b", set("at", 11 + i));
      request.mutable_options()->set_nodes(static_cast<std::uint32_t>(290 - 100 * i));
      edit(request);
    }
  }

  /// All rows, two a page, as `design@number`.
  std::vector<std::string> rows(v1::ListRevisionsRequest request) {
    std::vector<std::string> out;
    request.set_page_size(2);
    do {
      grpc::ClientContext context;
      v1::ListRevisionsResponse reply;
      const auto status = stub().ListRevisions(&context, request, &reply);
      EXPECT_TRUE(status.ok()) << status.error_message();
      EXPECT_THAT(reply.revisions(), testing::Not(IsEmpty()));
      EXPECT_LE(reply.revisions_size(), 2);
      for (const auto& row : reply.revisions())
        out.push_back(row.design() + "@" + std::to_string(row.number()));
      request.set_page_token(reply.next_page_token());
    } while (!request.page_token().empty());
    return out;
  }
  std::vector<std::string> names(v1::ListDesignsRequest request) {
    std::vector<std::string> out;
    request.set_page_size(1);
    do {
      grpc::ClientContext context;
      v1::ListDesignsResponse reply;
      EXPECT_TRUE(stub().ListDesigns(&context, request, &reply).ok());
      for (const auto& row : reply.designs()) out.push_back(row.name());
      request.set_page_token(reply.next_page_token());
    } while (!request.page_token().empty());
    return out;
  }

  std::string first_;
};

TEST_F(Lists, OfRevisionsComeInTheOrderAskedForPageByPage) {
  v1::ListRevisionsRequest request;
  EXPECT_THAT(rows(request), ElementsAre("a@1", "b@1", "b@2", "b@3", "b@4"));
  request.set_descending(true);
  EXPECT_THAT(rows(request), ElementsAre("b@4", "b@3", "b@2", "b@1", "a@1"));
  request.set_order(v1::REVISION_ORDER_NODES);
  EXPECT_THAT(rows(request), ElementsAre("b@1", "b@2", "a@1", "b@3", "b@4"));
  request.set_descending(false);
  EXPECT_THAT(rows(request), ElementsAre("b@4", "b@3", "a@1", "b@2", "b@1"));
  request.set_order(v1::REVISION_ORDER_CREATED);
  EXPECT_THAT(rows(request), ElementsAre("b@1", "a@1", "b@2", "b@3", "b@4"));
}

TEST_F(Lists, OfRevisionsHoldWhatTheFilterLetsThrough) {
  v1::ListRevisionsRequest request;
  v1::RevisionFilter& filter = *request.mutable_filter();
  filter.set_heads(true);
  EXPECT_THAT(rows(request), ElementsAre("a@1", "b@4"));
  filter.Clear();
  filter.set_design("b");
  filter.set_parent(first_);
  EXPECT_THAT(rows(request), ElementsAre("b@2"));
  filter.Clear();
  filter.set_root(first_);
  EXPECT_THAT(rows(request), ElementsAre("b@1", "b@2", "b@3", "b@4"));
  filter.Clear();
  filter.set_model_name("a");
  EXPECT_THAT(rows(request), ElementsAre("a@1"));
  filter.Clear();
  *filter.mutable_created_from() = describe("b@3").revision().created();
  EXPECT_THAT(rows(request), ElementsAre("b@3", "b@4"));
  *filter.mutable_created_before() = describe("b@4").revision().created();
  EXPECT_THAT(rows(request), ElementsAre("b@3"));
  filter.Clear();
  filter.set_algorithm_version(engine_.engine().algorithm_version);
  EXPECT_EQ(rows(request).size(), 5U);
}

TEST_F(Lists, TakeTimesBeyondAnyClockForTheFirstAndTheLast) {
  v1::ListRevisionsRequest request;
  auto& filter = *request.mutable_filter();
  filter.mutable_created_from()->set_seconds(std::numeric_limits<std::int64_t>::max());
  filter.mutable_created_from()->set_nanos(std::numeric_limits<std::int32_t>::max());
  grpc::ClientContext context;
  v1::ListRevisionsResponse reply;
  EXPECT_TRUE(stub().ListRevisions(&context, request, &reply).ok());
  EXPECT_THAT(reply.revisions(), IsEmpty());
  filter.mutable_created_from()->set_seconds(std::numeric_limits<std::int64_t>::min());
  filter.mutable_created_from()->set_nanos(std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(rows(request).size(), 5U);
}

TEST_F(Lists, ThatAreEmptyOrOfNoDesign) {
  grpc::ClientContext first, second;
  v1::ListRevisionsRequest request;
  request.mutable_filter()->set_unfiled(true);
  v1::ListRevisionsResponse reply;
  ASSERT_TRUE(stub().ListRevisions(&first, request, &reply).ok());
  EXPECT_EQ(reply.revisions_size(), 0);
  EXPECT_EQ(reply.next_page_token(), "");
  request.mutable_filter()->set_design("plank");
  EXPECT_EQ(detail(stub().ListRevisions(&second, request, &reply)).reason(),
            v1::Error::DESIGN_NOT_FOUND);
}

TEST_F(Lists, OfDesignsComeInTheOrderAskedForAndByPrefix) {
  create(create_request(plate(5, 10, "ab"), 100));
  v1::ListDesignsRequest request;
  EXPECT_THAT(names(request), ElementsAre("a", "ab", "b"));
  request.set_order(v1::DESIGN_ORDER_CHANGED);
  EXPECT_THAT(names(request), ElementsAre("a", "b", "ab"));
  request.set_order(v1::DESIGN_ORDER_REVISIONS);
  request.set_descending(true);
  EXPECT_EQ(names(request).front(), "b");
  request.mutable_filter()->set_prefix("a");
  EXPECT_EQ(names(request).size(), 2U);
}

TEST_F(Lists, TakeNoTokenOfAnotherListFilterOrOrder) {
  v1::ListRevisionsRequest request;
  request.set_page_size(1);
  v1::ListRevisionsResponse page;
  grpc::ClientContext context;
  ASSERT_TRUE(stub().ListRevisions(&context, request, &page).ok());
  request.set_page_token(page.next_page_token());
  const auto reason = [&](const v1::ListRevisionsRequest& changed) {
    grpc::ClientContext another;
    const auto status = stub().ListRevisions(&another, changed, &page);
    return status.ok() ? v1::Error::REASON_UNSPECIFIED : detail(status).reason();
  };
  EXPECT_EQ(reason(request), v1::Error::REASON_UNSPECIFIED);
  auto changed = request;
  changed.set_page_size(3);
  EXPECT_EQ(reason(changed), v1::Error::REASON_UNSPECIFIED);
  changed = request;
  changed.set_descending(true);
  EXPECT_EQ(reason(changed), v1::Error::PAGE_TOKEN_INVALID);
  changed = request;
  changed.set_order(v1::REVISION_ORDER_NODES);
  EXPECT_EQ(reason(changed), v1::Error::PAGE_TOKEN_INVALID);
  changed = request;
  changed.mutable_filter()->set_design("b");
  EXPECT_EQ(reason(changed), v1::Error::PAGE_TOKEN_INVALID);
  for (const std::string& token :
       {std::string("nonsense"), std::string("."), request.page_token().substr(0, 20),
        std::string(1000, '9'), request.page_token().substr(0, 17) + "x.y.1.b"}) {
    changed = request;
    changed.set_page_token(token);
    EXPECT_EQ(reason(changed), v1::Error::PAGE_TOKEN_INVALID) << token;
  }
  v1::ListDesignsRequest designs;
  designs.set_page_token(request.page_token());
  v1::ListDesignsResponse none;
  grpc::ClientContext another;
  EXPECT_EQ(detail(stub().ListDesigns(&another, designs, &none)).reason(),
            v1::Error::PAGE_TOKEN_INVALID);
}

TEST_F(Lists, InNoKnownOrderAreRefused) {
  v1::ListRevisionsRequest request;
  request.set_order(static_cast<v1::RevisionOrder>(9));
  v1::ListRevisionsResponse reply;
  grpc::ClientContext context;
  EXPECT_EQ(detail(stub().ListRevisions(&context, request, &reply)).parameter(), "order");
}

}  // namespace
}  // namespace remeshd::test

#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using grpc::StatusCode;
using testing::HasSubstr;

/// A model's size controls on their way through the daemon.
class SizesOfAModel : public DaemonTest {
 protected:
  static v1::SizeControl on(const std::string& id, const std::string& selector,
                            const std::string& size) {
    v1::SizeControl out;
    out.set_id(id);
    out.set_on(selector);
    out.mutable_size()->set_string_value(size);
    return out;
  }
  static v1::SizeControl in_ball(const std::string& id, double radius, double size) {
    v1::SizeControl out;
    out.set_id(id);
    for (const double value : {1.0, 2.0, 3.0, radius})
      out.mutable_region()->mutable_ball()->add_values()->set_number_value(value);
    out.mutable_size()->set_number_value(size);
    return out;
  }
  static v1::FeatureModel sized(const std::vector<v1::SizeControl>& sizes) {
    v1::FeatureModel model = plate();
    for (const v1::SizeControl& size : sizes) *model.add_sizes() = size;
    return model;
  }
  /// An edit of sizes alone: one of each set, or of that id removed.
  static v1::ModelEdit setting(const v1::SizeControl& size) {
    v1::ModelEdit edit;
    *edit.add_edits()->mutable_set_size() = size;
    return edit;
  }
  static v1::ModelEdit removing(const std::string& id) {
    v1::ModelEdit edit;
    edit.add_edits()->mutable_remove_size()->set_id(id);
    return edit;
  }
  v1::Error refused_model(const v1::FeatureModel& model) {
    v1::RevisionResult reply;
    const auto status = try_create(create_request(model), &reply);
    EXPECT_EQ(status.error_code(), StatusCode::INVALID_ARGUMENT);
    return detail(status);
  }
  v1::GetRevisionResponse documents_of(const std::string& revision) {
    v1::GetRevisionRequest request;
    request.set_revision(revision);
    request.set_documents(true);
    v1::GetRevisionResponse reply;
    grpc::ClientContext context;
    EXPECT_TRUE(stub().GetRevision(&context, request, &reply).ok());
    return reply;
  }
};

TEST_F(SizesOfAModel, ComeBackAsTheyWereSent) {
  use_store();
  const v1::FeatureModel model = sized({on("holes", "hole*.wall", "radius/4"), in_ball("b", 5, 1)});
  create(model);
  for (int k = 0; k < 2; ++k) {
    const v1::GetRevisionResponse known = documents_of("plate");
    ASSERT_EQ(known.model().sizes_size(), 2);
    for (int s = 0; s < 2; ++s)
      EXPECT_EQ(known.model().sizes(s).SerializeAsString(), model.sizes(s).SerializeAsString());
    EXPECT_THAT(known.model_document(), HasSubstr(R"("on": "hole*.wall")"));
    start();
  }
}

TEST_F(SizesOfAModel, AreSetChangedAndRemovedByEdits) {
  create(plate());
  edit("plate", setting(on("holes", "hole.wall", "radius/4")));
  v1::SizeControl coarser;
  coarser.set_id("holes");
  coarser.mutable_size()->set_number_value(2);
  edit("plate", setting(coarser));
  const v1::SizeControl changed = describe("plate@3").model().sizes(0);
  EXPECT_EQ(changed.on(), "hole.wall");
  EXPECT_EQ(changed.size().number_value(), 2);
  edit("plate", removing("holes"));
  EXPECT_EQ(describe("plate@4").model().sizes_size(), 0);
}

TEST_F(SizesOfAModel, MakeARevisionOfItsOwn) {
  const std::string plain = create(plate()).revision().id();
  const std::string finer = create(sized({in_ball("b", 5, 1)})).revision().id();
  EXPECT_NE(create(sized({in_ball("b", 5, 2)})).revision().id(), finer);
  EXPECT_NE(plain, finer);
}

TEST_F(SizesOfAModel, ThatAreNotThereAreNotFound) {
  create(plate());
  v1::RevisionResult reply;
  const auto status = try_edit(edit_request("plate", removing("holes")), &reply);
  EXPECT_EQ(status.error_code(), StatusCode::NOT_FOUND);
  EXPECT_EQ(detail(status).reason(), v1::Error::UNKNOWN_SIZE);
  EXPECT_EQ(detail(status).parameter(), "sizes.holes");
  EXPECT_EQ(detail(status).edit_index(), 0U);
}

TEST_F(SizesOfAModel, ThatLackAPartAreNamed) {
  v1::SizeControl nowhere = in_ball("b", 5, 1);
  nowhere.clear_region();
  EXPECT_EQ(refused_model(sized({nowhere})).reason(), v1::Error::MISSING_FIELD);
  v1::SizeControl empty = in_ball("b", 5, 1);
  empty.mutable_region()->clear_ball();
  EXPECT_EQ(refused_model(sized({empty})).parameter(), "sizes[0].in");
  v1::SizeControl short_ball = in_ball("b", 5, 1);
  short_ball.mutable_region()->mutable_ball()->mutable_values()->RemoveLast();
  EXPECT_EQ(refused_model(sized({short_ball})).parameter(), "sizes[0].in.ball");
  v1::SizeControl without = in_ball("b", 5, 1);
  without.clear_size();
  EXPECT_EQ(refused_model(sized({without})).parameter(), "sizes[0]");
}

TEST_F(SizesOfAModel, ThatAreWrongAreFoundInTheirDocument) {
  v1::CreateRevisionRequest request;
  request.set_document(R"({"features": [{"id": "plate", "nature": "ADDITIVE", "type": "block",
  "parameters": {"dx": 8, "dy": 4, "dz": 1}}],
 "sizes": [{"id": "top", "on": "plate.top", "size": "dx - 9"}]})");
  v1::RevisionResult reply;
  const v1::Error error = detail(try_create(request, &reply));
  EXPECT_EQ(error.reason(), v1::Error::VALUE_OUT_OF_RANGE);
  EXPECT_EQ(error.parameter(), "sizes.top.size");
  EXPECT_EQ(error.line(), 3U);
  EXPECT_EQ(error.column(), 53U);
}

}  // namespace
}  // namespace remeshd::test

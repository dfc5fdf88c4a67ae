// What meshing refuses of a model's groups, validation refuses too, in the same words.
#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

class ValidatedGroups : public DaemonTest {
 protected:
  [[nodiscard]] Engine make_engine() const override { return production_engine(); }

  static v1::FeatureModel with_group(const std::string& name, const std::string& selector) {
    v1::FeatureModel model = plate();
    v1::Group& group = *model.add_groups();
    group.set_name(name);
    group.set_on(selector);
    return model;
  }
  static v1::ModelEdit removing_hole() {
    v1::ModelEdit edit;
    edit.add_edits()->mutable_remove_feature()->set_feature("hole");
    return edit;
  }
  grpc::Status validate(const v1::FeatureModel& model) {
    grpc::ClientContext context;
    v1::ValidateModelRequest request;
    *request.mutable_model() = model;
    v1::ValidateModelResponse reply;
    return stub().ValidateModel(&context, request, &reply);
  }
  grpc::Status validate(const std::string& base, const v1::ModelEdit& edit,
                        v1::ModelCheck* check = nullptr) {
    grpc::ClientContext context;
    v1::ValidateEditRequest request;
    request.set_base(base);
    *request.mutable_edit() = edit;
    v1::ValidateEditResponse reply;
    const auto status = stub().ValidateEdit(&context, request, &reply);
    if (check != nullptr) *check = reply.check();
    return status;
  }
  /// Of an edit of a model that has no mesh.
  grpc::Status validate(const v1::FeatureModel& base, const v1::ModelEdit& edit,
                        v1::ModelCheck* check = nullptr) {
    grpc::ClientContext context;
    v1::ValidateEditRequest request;
    *request.mutable_base_model() = base;
    *request.mutable_edit() = edit;
    v1::ValidateEditResponse reply;
    const auto status = stub().ValidateEdit(&context, request, &reply);
    if (check != nullptr) *check = reply.check();
    return status;
  }
  static std::vector<std::string> codes_of(const v1::ModelCheck& check) {
    std::vector<std::string> codes;
    for (const v1::Warning& warning : check.warnings())
      codes.push_back(v1::Warning::Code_Name(warning.code()));
    return codes;
  }
  /// Expects that the edit of `plate` is refused by validation and meshing alike.
  void expect_broken(const v1::ModelEdit& edit, const std::string& parameter) {
    v1::RevisionResult made;
    const auto refused = try_edit(edit_request("plate", edit), &made);
    const auto status = validate("plate", edit);
    EXPECT_EQ(detail(status).reason(), v1::Error::POLICY_BROKEN);
    EXPECT_EQ(detail(status).parameter(), parameter);
    EXPECT_EQ(detail(status).reason(), detail(refused).reason());
    EXPECT_EQ(status.error_message(), refused.error_message());
  }
};

TEST_F(ValidatedGroups, OfAFirstMeshThatSelectNothingAreRefused) {
  EXPECT_TRUE(validate(with_group("load", "plate.top")).ok());
  const v1::FeatureModel wrong = with_group("load", "plates.top");
  const auto status = validate(wrong);
  EXPECT_EQ(detail(status).reason(), v1::Error::SELECTOR_EMPTY);
  EXPECT_EQ(detail(status).parameter(), "groups.load.on");
  v1::RevisionResult made;
  const auto refused = try_create(create_request(wrong, 600), &made);
  EXPECT_EQ(detail(refused).reason(), v1::Error::SELECTOR_EMPTY);
  EXPECT_EQ(status.error_message(), refused.error_message());
}

TEST_F(ValidatedGroups, ThatAnEditEmptiesAreAWarningWithoutAPolicy) {
  create(create_request(with_group("bore", "hole.wall"), 600));
  v1::ModelCheck check;
  ASSERT_TRUE(validate("plate", removing_hole(), &check).ok());
  EXPECT_THAT(codes_of(check), testing::Contains("GROUP_EMPTIED"));
}

TEST_F(ValidatedGroups, AndSizesOfAModelWithoutAMeshAreComparedWithItsOwn) {
  v1::FeatureModel model = with_group("bore", "hole.wall");
  v1::SizeControl& size = *model.add_sizes();
  size.set_id("rim");
  size.set_on("hole.wall");
  size.mutable_size()->set_number_value(1);
  v1::ModelCheck check;
  const auto status = validate(model, removing_hole(), &check);
  ASSERT_TRUE(status.ok()) << status.error_message();
  EXPECT_THAT(codes_of(check),
              testing::UnorderedElementsAre("FACE_LOST", "GROUP_EMPTIED", "GROUP_EMPTIED"));
  ASSERT_TRUE(validate(model, set("r", 5.5), &check).ok());
  EXPECT_EQ(check.warnings_size(), 0);

  model.mutable_groups(0)->mutable_policy()->set_max_area_change(0.05);
  EXPECT_EQ(detail(validate(model, set("r", 7))).parameter(), "groups.bore.policy.maxAreaChange");
  model.mutable_groups(0)->mutable_policy()->set_on_emptied("fail");
  EXPECT_EQ(detail(validate(model, removing_hole())).reason(), v1::Error::POLICY_BROKEN);
}

TEST_F(ValidatedGroups, AreHeldToTheirPoliciesInEditsOfARevisionAlsoOfALoadedOne) {
  use_store();
  v1::FeatureModel model = with_group("bore", "hole.wall");
  model.mutable_groups(0)->mutable_policy()->set_on_emptied("fail");
  v1::Group& load = *model.add_groups();
  load.set_name("load");
  load.set_on("plate.top");
  load.mutable_policy()->set_max_area_change(0.05);
  create(create_request(model, 600));
  for (int k = 0; k < 2; ++k) {
    EXPECT_TRUE(validate("plate", set("r", 5.5)).ok());
    expect_broken(set("r", 12), "groups.load.policy.maxAreaChange");
    expect_broken(removing_hole(), "groups.bore.policy.onEmptied");
    start();
  }
}

}  // namespace
}  // namespace remeshd::test

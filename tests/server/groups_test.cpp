#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using grpc::StatusCode;
using testing::HasSubstr;

/// A model's groups on their way through the daemon.
class GroupsInTheDaemon : public DaemonTest {
 protected:
  static v1::Group group(const std::string& name, const std::string& selector) {
    v1::Group out;
    out.set_name(name);
    out.set_on(selector);
    return out;
  }
  static v1::Group strict(v1::Group out, double most) {
    out.mutable_policy()->set_max_area_change(most);
    out.mutable_policy()->set_on_emptied("fail");
    return out;
  }
  static v1::FeatureModel grouped(const std::vector<v1::Group>& groups) {
    v1::FeatureModel model = plate();
    for (const v1::Group& each : groups) *model.add_groups() = each;
    return model;
  }
  static v1::ModelEdit setting(const v1::Group& group) {
    v1::ModelEdit edit;
    *edit.add_edits()->mutable_set_group() = group;
    return edit;
  }
  static v1::ModelEdit removing(const std::string& name) {
    v1::ModelEdit edit;
    edit.add_edits()->mutable_remove_group()->set_name(name);
    return edit;
  }
};

TEST_F(GroupsInTheDaemon, ComeBackAsTheyWereSent) {
  use_store();
  const v1::FeatureModel model =
      grouped({strict(group("load", "plate.top & z > 0.5"), 0.2), group("supports", "hole*.wall")});
  create(model);
  for (int k = 0; k < 2; ++k) {
    const v1::FeatureModel known = describe("plate").model();
    ASSERT_EQ(known.groups_size(), 2);
    for (int g = 0; g < 2; ++g)
      EXPECT_EQ(known.groups(g).SerializeAsString(), model.groups(g).SerializeAsString());
    start();
  }
}

TEST_F(GroupsInTheDaemon, AreSetChangedAndRemovedByEdits) {
  create(plate());
  edit("plate", setting(strict(group("load", "plate.top"), 0.5)));
  v1::Group elsewhere = group("load", "plate.bottom");
  edit("plate", setting(elsewhere));
  const v1::Group changed = describe("plate@3").model().groups(0);
  EXPECT_EQ(changed.on(), "plate.bottom");
  EXPECT_EQ(changed.policy().max_area_change(), 0.5) << "what is left out stays";
  edit("plate", removing("load"));
  EXPECT_EQ(describe("plate@4").model().groups_size(), 0);
}

TEST_F(GroupsInTheDaemon, MakeARevisionOfItsOwn) {
  const std::string plain = create(plate()).revision().id();
  const std::string top = create(grouped({group("a", "plate.top")})).revision().id();
  EXPECT_NE(plain, top);
  EXPECT_NE(create(grouped({group("b", "plate.top")})).revision().id(), top);
  EXPECT_NE(create(grouped({group("a", "plate.bottom")})).revision().id(), top);
  EXPECT_NE(create(grouped({strict(group("a", "plate.top"), 0.1)})).revision().id(), top);
}

TEST_F(GroupsInTheDaemon, ThatAreNotThereAreNotFound) {
  create(plate());
  v1::RevisionResult reply;
  const auto status = try_edit(edit_request("plate", removing("load")), &reply);
  EXPECT_EQ(status.error_code(), StatusCode::NOT_FOUND);
  EXPECT_EQ(detail(status).reason(), v1::Error::UNKNOWN_GROUP);
  EXPECT_EQ(detail(status).parameter(), "groups.load");
  EXPECT_EQ(detail(status).edit_index(), 0U);
}

TEST_F(GroupsInTheDaemon, ThatAreWrongAreRefused) {
  const auto refused = [&](const v1::Group& wrong) {
    v1::RevisionResult reply;
    const auto status = try_create(create_request(grouped({wrong})), &reply);
    EXPECT_EQ(status.error_code(), StatusCode::INVALID_ARGUMENT);
    return v1::Error::Reason_Name(detail(status).reason()) + " " + detail(status).parameter();
  };
  EXPECT_EQ(refused(group("load", "")), "MISSING_FIELD groups.load");
  EXPECT_EQ(refused(group("plate", "plate.top")), "DUPLICATE_NAME groups.plate");
  EXPECT_EQ(refused(strict(group("load", "plate"), -1)),
            "VALUE_OUT_OF_RANGE groups.load.policy.maxAreaChange");
  v1::Group other = group("load", "plate");
  other.mutable_policy()->set_on_emptied("perhaps");
  EXPECT_EQ(refused(other), "WRONG_KIND groups.load.policy.onEmptied");
}

TEST_F(GroupsInTheDaemon, ThatAreWrongAreFoundInTheirDocument) {
  v1::CreateRevisionRequest request;
  request.set_document(R"({"features": [{"id": "plate", "nature": "ADDITIVE", "type": "block",
  "parameters": {"dx": 8, "dy": 4, "dz": 1}}],
 "groups": {"side": "plate.x_min",
            "load": {"on": "plate.top & w > 2"}}})");
  v1::RevisionResult reply;
  const v1::Error error = detail(try_create(request, &reply));
  EXPECT_EQ(error.parameter(), "groups.load.on");
  EXPECT_EQ(error.line(), 4U);
  EXPECT_EQ(error.column(), 28U);
}

}  // namespace
}  // namespace remeshd::test

#include <google/protobuf/util/message_differencer.h>

#include "proto/json_writer.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using google::protobuf::util::MessageDifferencer;
using testing::HasSubstr;

/// Models and edits that come as the text of a document.
class Documents : public DaemonTest {
 protected:
  static v1::CreateRevisionRequest as_text(const std::string& text) {
    v1::CreateRevisionRequest request;
    request.set_document(text);
    request.mutable_options()->set_nodes(100);
    return request;
  }
  static v1::EditRevisionRequest edit_as_text(const std::string& base, const std::string& text) {
    v1::EditRevisionRequest request;
    request.set_base(base);
    request.set_document(text);
    return request;
  }
  v1::Error refused(const std::string& text) {
    v1::RevisionResult result;
    const auto status = try_create(as_text(text), &result);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_TRUE(serves());
    return detail(status);
  }
};

TEST_F(Documents, GiveTheRevisionThatTheirMessagesGive) {
  const auto base = create(plate());
  const auto same = create(as_text(write_document(plate())));
  EXPECT_EQ(same.revision().id(), base.revision().id());
  EXPECT_TRUE(same.report().cached());
  const auto child = edit("plate@1", set("at", 11));
  const auto again = edit(
      edit_as_text("plate@1", R"({"edits": [{"set_parameter": {"name": "at", "value": 11}}]})"));
  EXPECT_EQ(again.revision().id(), child.revision().id());
  EXPECT_EQ(engine_.made(), 2);
}

TEST_F(Documents, GiveTheRevisionThatTheirMessagesGiveWhereZeroHasASign) {
  create(plate());
  const auto child = edit("plate@1", set("at", -0.0));
  EXPECT_EQ(edit("plate@1", set("at", 0)).revision().id(), child.revision().id());
  const auto again = edit(edit_as_text("plate@1", write_document(set("at", -0.0))));
  EXPECT_EQ(again.revision().id(), child.revision().id());
}

TEST_F(Documents, AreComparedAndValidated) {
  create(plate());
  const std::string model = write_document(plate(6));
  const std::string change = write_document(set("at", 11));
  {
    grpc::ClientContext context;
    v1::CompareRequest request;
    request.mutable_original()->set_document(model);
    request.mutable_modified()->set_document(change);
    v1::CompareResponse reply;
    EXPECT_TRUE(stub().Compare(&context, request, &reply).ok());
    EXPECT_EQ(reply.comparison().features_size(), 2);
  }
  {
    grpc::ClientContext context;
    v1::CompareRequest request;
    request.mutable_original()->set_document(change);
    request.mutable_modified()->set_document(model);
    v1::CompareResponse reply;
    EXPECT_EQ(detail(stub().Compare(&context, request, &reply)).reason(), v1::Error::SIDE_INVALID);
  }
  {
    grpc::ClientContext context;
    v1::ValidateModelRequest request;
    request.set_document(model);
    v1::ValidateModelResponse reply;
    EXPECT_TRUE(stub().ValidateModel(&context, request, &reply).ok());
    EXPECT_EQ(reply.check().model().features_size(), 2);
  }
  grpc::ClientContext context;
  v1::ValidateEditRequest request;
  request.set_base_document(model);
  request.set_document(change);
  v1::ValidateEditResponse reply;
  EXPECT_TRUE(stub().ValidateEdit(&context, request, &reply).ok());
  EXPECT_EQ(reply.check().model().parameters(1).value().number_value(), 11);
}

TEST_F(Documents, AreRefusedWithLineAndColumn) {
  const auto malformed = refused("{\n  \"features\": [}");
  EXPECT_EQ(malformed.reason(), v1::Error::DOCUMENT_MALFORMED);
  EXPECT_EQ(malformed.stage(), "document");
  EXPECT_EQ(malformed.line(), 2U);
  EXPECT_EQ(malformed.column(), 16U);

  const auto unknown = refused(
      "{\"features\": [\n{\"id\": \"a\", \"nature\": \"ADDITIVE\", \"type\": \"block\",\n "
      "\"colour\": 1}]}");
  EXPECT_EQ(unknown.reason(), v1::Error::UNKNOWN_FIELD);
  EXPECT_THAT(unknown.features(), testing::ElementsAre("a"));
  EXPECT_EQ(unknown.line(), 3U);
  EXPECT_EQ(unknown.column(), 2U);

  EXPECT_EQ(refused("{\"name\": 1, \"name\": 2}").reason(), v1::Error::DUPLICATE_KEY);
  EXPECT_EQ(refused(std::string(100000, '[')).reason(), v1::Error::DOCUMENT_TOO_DEEP);
  EXPECT_EQ(refused("").reason(), v1::Error::DOCUMENT_MALFORMED);
}

TEST_F(Documents, OfMoreThanTheLimitAreRefusedInWords) {
  const auto limit = static_cast<std::size_t>(info().limits().document_bytes());
  EXPECT_EQ(limit, std::size_t{4} << 20);
  const auto error = refused(std::string(limit + 1, ' '));
  EXPECT_EQ(error.reason(), v1::Error::DOCUMENT_TOO_LARGE);
  EXPECT_THAT(error.message(), HasSubstr("4194304"));
  EXPECT_EQ(refused(std::string(limit, ' ')).reason(), v1::Error::DOCUMENT_MALFORMED);
}

TEST_F(Documents, OfAModelComeBackInTheirOrderWithBoundsAndUnits) {
  const std::string text = R"({
  "name": "plate",
  "unit": "mm",
  "parameters": {
    "z": {"value": 5, "lower": 1, "upper": 9, "unit": "mm", "description": "the hole's radius"},
    "a": "2 * z",
    "count": {"value": 2, "integer": true}
  },
  "features": [
    {
      "id": "plate",
      "nature": "ADDITIVE",
      "type": "block",
      "parameters": {"dz": 10, "dy": 40, "dx": 80}
    },
    {
      "id": "hole",
      "nature": "SUBTRACTIVE",
      "type": "cylinder",
      "parameters": {"height": 10, "radius": "z"},
      "placement": {"origin": ["a", 0, 0]}
    }
  ]
})";
  create(as_text(text));
  grpc::ClientContext context;
  v1::GetRevisionRequest request;
  request.set_revision("plate");
  request.set_documents(true);
  v1::GetRevisionResponse reply;
  ASSERT_TRUE(stub().GetRevision(&context, request, &reply).ok());
  EXPECT_THAT(reply.model_document(), HasSubstr(R"("a": "2 * z",)"));
  EXPECT_THAT(reply.model_document(), HasSubstr(R"("parameters": {"dx": 80, "dy": 40, "dz": 10})"));
  EXPECT_TRUE(MessageDifferencer::Equals(parse_model(reply.model_document()), reply.model()));
  EXPECT_EQ(reply.edit_document(), "");
  EXPECT_FALSE(reply.has_edit());
  const v1::FeatureModel written = parse_model(text);
  ASSERT_EQ(reply.model().parameters_size(), written.parameters_size());
  for (int i = 0; i < written.parameters_size(); ++i)
    EXPECT_TRUE(MessageDifferencer::Equals(reply.model().parameters(i), written.parameters(i)));
}

TEST_F(Documents, OfTheEditThatMadeARevisionComeBackAlsoFromTheStore) {
  use_store();
  create(plate());
  v1::ModelEdit changes = set("at", 11);
  auto& rename = *changes.add_edits()->mutable_set_feature_parameter();
  rename.set_feature("hole");
  rename.set_name("radius");
  rename.mutable_value()->set_string_value("r + 1");
  edit("plate", changes);
  for (int start_again = 0; start_again < 2; ++start_again) {
    grpc::ClientContext context;
    v1::GetRevisionRequest request;
    request.set_revision("plate@2");
    request.set_documents(true);
    v1::GetRevisionResponse reply;
    ASSERT_TRUE(stub().GetRevision(&context, request, &reply).ok());
    EXPECT_TRUE(MessageDifferencer::Equals(reply.edit(), changes));
    EXPECT_EQ(reply.edit_document(), write_document(changes));
    EXPECT_FALSE(describe("plate@1").has_edit());
    start();
  }
}

TEST_F(Documents, OfNoEditsAreRefusedAndSoAreMessages) {
  create(plate());
  v1::RevisionResult result;
  auto status = try_edit(edit_as_text("plate", R"({"edits": []})"), &result);
  EXPECT_EQ(detail(status).reason(), v1::Error::NO_EDITS);
  EXPECT_EQ(detail(status).line(), 1U);
  status = try_edit(edit_request("plate", {}), &result);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(detail(status).reason(), v1::Error::NO_EDITS);
}

TEST_F(Documents, AParameterGivenTwiceInAMessageIsRefused) {
  auto model = plate();
  model.add_parameters()->set_name("r");
  model.mutable_parameters(2)->mutable_value()->set_number_value(7);
  v1::RevisionResult result;
  EXPECT_EQ(detail(try_create(create_request(model), &result)).reason(),
            v1::Error::DUPLICATE_PARAMETER);
  model = plate();
  *model.mutable_features(1)->add_parameters() = model.features(1).parameters(0);
  const auto error = detail(try_create(create_request(model), &result));
  EXPECT_EQ(error.reason(), v1::Error::DUPLICATE_PARAMETER);
  EXPECT_EQ(error.features(0), "hole");
}

TEST_F(Documents, TellWhereAValueStandsThatCannotBe) {
  // What the reader of documents finds nothing wrong with.
  const v1::Error divided = refused(R"({"name": "p", "parameters": {"a": 0},
    "features": [{"id": "plate", "nature": "ADDITIVE", "type": "block",
      "parameters": {"dx": 80, "dy": "40 / a",
                     "dz": 10}}]})");
  EXPECT_EQ(divided.reason(), v1::Error::NON_FINITE_VALUE);
  EXPECT_EQ(divided.line(), 3U);
  EXPECT_EQ(divided.column(), 38U);
  const v1::Error outside = refused(R"({"name": "p",
    "parameters": {"a": {"value": 9, "upper": 8}},
    "features": [{"id": "plate", "nature": "ADDITIVE", "type": "block",
      "parameters": {"dx": 80, "dy": "a", "dz": 10}}]})");
  EXPECT_EQ(outside.reason(), v1::Error::VALUE_OUT_OF_RANGE);
  EXPECT_EQ(outside.line(), 2U);
  EXPECT_EQ(outside.column(), 25U);
}

TEST_F(Documents, OfEditsTellWhereTheyAreWrong) {
  create(plate());
  const auto refused_edit = [&](const std::string& text) {
    v1::RevisionResult result;
    return detail(try_edit(edit_as_text("plate@1", text), &result));
  };
  const v1::Error negative = refused_edit(R"({"edits": [
    {"setParameter": {"name": "at", "value": 3}},
    {"setFeatureParameter": {"feature": "plate", "name": "dz",
                             "value": -10}}]})");
  EXPECT_EQ(negative.parameter(), "dz");
  EXPECT_EQ(negative.line(), 4U);
  EXPECT_EQ(negative.column(), 39U);
  const v1::Error unknown = refused_edit(R"({"edits": [
    {"removeFeature": {"feature": "rib"}}]})");
  EXPECT_EQ(unknown.reason(), v1::Error::UNKNOWN_FEATURE);
  EXPECT_EQ(unknown.line(), 2U);
  // What a model has that came as a message has no line.
  v1::EditRevisionRequest message;
  message.set_base("plate@1");
  *message.mutable_edit() = set("r", -1);
  v1::RevisionResult result;
  EXPECT_FALSE(detail(try_edit(message, &result)).has_line());
}

TEST_F(Documents, ThatAreValidatedTellWhereTheyAreWrong) {
  grpc::ClientContext context;
  v1::ValidateModelRequest request;
  request.set_document(R"({"features": [{"id": "plate", "nature": "ADDITIVE", "type": "block",
      "parameters": {"dx": 80, "dy": 0, "dz": 10}}]})");
  v1::ValidateModelResponse reply;
  const v1::Error error = detail(stub().ValidateModel(&context, request, &reply));
  EXPECT_EQ(error.parameter(), "dy");
  EXPECT_EQ(error.line(), 2U);
  EXPECT_EQ(error.column(), 38U);
}

}  // namespace
}  // namespace remeshd::test

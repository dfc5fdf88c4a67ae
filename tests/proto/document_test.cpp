#include "proto/document.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/message_differencer.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "proto/document_error.h"
#include "proto/json_writer.h"
#include "tests/proto/refusal.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using google::protobuf::util::MessageDifferencer;
using test::model_refusal;
using test::refusal;
using test::with_feature;
using testing::HasSubstr;

DocumentErrorInfo edit_refusal(const std::string& text) {
  return refusal([&] { parse_edit(text); });
}

std::vector<std::filesystem::path> case_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(REMESHD_CASES_DIR))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

using OrderedJson = nlohmann::ordered_json;

/// Objects by name, as documents have them, as the lists that their messages are.
void lengthen(OrderedJson& json) {
  if (json.is_object() && json.contains("parameters")) {
    OrderedJson list = OrderedJson::array();
    for (const auto& [name, value] : json.at("parameters").items())
      list.push_back({{"name", name}, {"value", value}});
    json["parameters"] = list;
  }
  for (auto& child : json)
    if (child.is_structured()) lengthen(child);
}
std::string long_form(const std::string& text) {
  OrderedJson json = OrderedJson::parse(text);
  lengthen(json);
  return json.dump();
}

TEST(Document, EveryCaseReadsAsProtobufsOwnParserReadsItsLongForm) {
  ASSERT_GE(case_files().size(), 28U);
  for (const auto& file : case_files()) {
    SCOPED_TRACE(file.filename());
    const std::string text = read_document(file);
    if (file.string().ends_with(".edit.json")) {
      v1::ModelEdit theirs;
      ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(long_form(text), &theirs).ok());
      EXPECT_TRUE(MessageDifferencer::Equals(parse_edit(text), theirs));
      EXPECT_TRUE(std::holds_alternative<v1::ModelEdit>(parse_document(text)));
    } else {
      v1::FeatureModel theirs;
      ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(long_form(text), &theirs).ok());
      EXPECT_TRUE(MessageDifferencer::Equals(parse_model(text), theirs));
      EXPECT_TRUE(std::holds_alternative<v1::FeatureModel>(parse_document(text)));
    }
  }
}

TEST(Document, WhatIsWrittenReadsBackEqualAndWritesTheSameTextAgain) {
  for (const auto& file : case_files()) {
    SCOPED_TRACE(file.filename());
    std::visit(
        [](const auto& message) {
          const std::string text = write_document(message);
          const auto again = parse_document(text);
          using Message = std::decay_t<decltype(message)>;
          ASSERT_TRUE(std::holds_alternative<Message>(again)) << text;
          EXPECT_TRUE(MessageDifferencer::Equals(std::get<Message>(again), message)) << text;
          EXPECT_EQ(write_document(std::get<Message>(again)), text);
        },
        parse_document(read_document(file)));
  }
}

TEST(Document, ZeroHasNoSign) {
  const auto profile = [](const std::string& y) {
    return parse_model(with_feature(R"("parameters": {"profile": [[1, )" + y + "]]}"));
  };
  const std::string zero = write_document(profile("0"));
  for (const char* minus : {"-0", "-0.0", "-0e5", "-1e-999"})
    EXPECT_EQ(write_document(profile(minus)), zero) << minus;
  v1::FeatureModel message = profile("7");
  message.mutable_features(0)
      ->mutable_parameters(0)
      ->mutable_value()
      ->mutable_list_value()
      ->mutable_values(0)
      ->mutable_list_value()
      ->mutable_values(1)
      ->set_number_value(-0.0);
  EXPECT_EQ(write_document(message), zero);
}

TEST(Document, AReferenceThatIsNotSpecifiedIsLeftOut) {
  v1::FeatureModel message = parse_model(with_feature(""));
  const std::string without = write_document(message);
  message.mutable_features(0)->set_reference(v1::Feature::REFERENCE_UNSPECIFIED);
  EXPECT_EQ(write_document(message), without);
}

TEST(Document, AReferencePointIsAListOfThreeValues) {
  const v1::FeatureModel model = parse_model(with_feature(R"("referencePoint": [0, "h/2", 5])"));
  ASSERT_EQ(model.features(0).reference_choice_case(), v1::Feature::kReferencePoint);
  EXPECT_EQ(model.features(0).reference_point().values(1).string_value(), "h/2");
  EXPECT_EQ(model.features(0).reference_point().values(2).number_value(), 5);
}

TEST(Document, ProfilesKeepPointsAndArcs) {
  const v1::FeatureModel model = parse_model(
      with_feature(R"("parameters": {"profile": [[0, 0], {"to": [1, "r"], "through": [2, 3]}]})"));
  ASSERT_EQ(model.features(0).parameters(0).name(), "profile");
  const auto& profile = model.features(0).parameters(0).value().list_value();
  ASSERT_EQ(profile.values_size(), 2);
  EXPECT_EQ(profile.values(0).list_value().values(1).number_value(), 0);
  const auto& arc = profile.values(1).struct_value().fields();
  EXPECT_EQ(arc.at("to").list_value().values(1).string_value(), "r");
  EXPECT_EQ(arc.at("through").list_value().values(0).number_value(), 2);
}

TEST(Document, ParametersComeInTheOrderWrittenInTheShortFormAndTheLong) {
  const std::string text =
      R"({"features": [{"id": "a", "nature": "ADDITIVE", "type": "block"}], "parameters": {
    "wall": 8,
    "pin": {"value": "wall / 2", "lower": 1, "upper": 8.5, "integer": true, "unit": "mm",
            "description": "of the pin"},
    "b": {"value": 1},
    "a": "pin + 1"}})";
  const v1::FeatureModel model = parse_model(text);
  ASSERT_EQ(model.parameters_size(), 4);
  EXPECT_EQ(model.parameters(0).name(), "wall");
  EXPECT_EQ(model.parameters(0).value().number_value(), 8);
  EXPECT_FALSE(model.parameters(0).has_lower());
  const v1::Parameter& pin = model.parameters(1);
  EXPECT_EQ(pin.name(), "pin");
  EXPECT_EQ(pin.value().string_value(), "wall / 2");
  EXPECT_EQ(pin.lower(), 1);
  EXPECT_EQ(pin.upper(), 8.5);
  EXPECT_TRUE(pin.integer());
  EXPECT_EQ(pin.unit(), "mm");
  EXPECT_EQ(pin.description(), "of the pin");
  EXPECT_EQ(model.parameters(2).name(), "b");
  EXPECT_EQ(model.parameters(2).value().number_value(), 1);
  EXPECT_EQ(model.parameters(3).name(), "a");

  const std::string written = write_document(model);
  EXPECT_THAT(written, HasSubstr(R"("wall": 8,)"));
  EXPECT_THAT(written, HasSubstr(R"("b": 1,)"));
  EXPECT_TRUE(MessageDifferencer::Equals(parse_model(written), model)) << written;
}

TEST(Document, ParametersOfAFeatureStayInTheOrderWritten) {
  const v1::FeatureModel model =
      parse_model(with_feature(R"("parameters": {"radius": 2, "height": "h", "angle": 3})"));
  ASSERT_EQ(model.features(0).parameters_size(), 3);
  EXPECT_EQ(model.features(0).parameters(0).name(), "radius");
  EXPECT_EQ(model.features(0).parameters(1).name(), "height");
  EXPECT_EQ(model.features(0).parameters(1).value().string_value(), "h");
  EXPECT_THAT(write_document(model), HasSubstr(R"({"radius": 2, "height": "h", "angle": 3})"));
}

TEST(Document, SizesAndGroupsAreReadAndWritten) {
  const v1::FeatureModel model = parse_model(R"({
    "features": [{"id": "a", "nature": "ADDITIVE", "type": "block"}],
    "sizes": [{"id": "holes", "on": "hole*.wall", "size": "radius/4"},
              {"id": "corner", "in": {"ball": [0, 0, "h", 5]}, "size": 1},
              {"id": "end", "in": {"box": [0, 0, 0, 1, 1, 1]}, "size": 2}],
    "groups": {"load": "plate.top & z > 10",
               "bolts": {"on": "hole*.wall", "policy": {"maxAreaChange": 0.2, "on_emptied": "fail"}}}})");
  ASSERT_EQ(model.sizes_size(), 3);
  EXPECT_EQ(model.sizes(0).on(), "hole*.wall");
  EXPECT_EQ(model.sizes(0).size().string_value(), "radius/4");
  EXPECT_EQ(model.sizes(1).region().ball().values(2).string_value(), "h");
  EXPECT_EQ(model.sizes(2).region().box().values_size(), 6);
  ASSERT_EQ(model.groups_size(), 2);
  EXPECT_EQ(model.groups(0).name(), "load");
  EXPECT_EQ(model.groups(0).on(), "plate.top & z > 10");
  EXPECT_EQ(model.groups(1).policy().max_area_change(), 0.2);
  EXPECT_EQ(model.groups(1).policy().on_emptied(), "fail");

  const std::string written = write_document(model);
  EXPECT_THAT(written, HasSubstr(R"("load": "plate.top & z > 10")"));
  EXPECT_THAT(written, HasSubstr(R"("in": {"ball": [0, 0, "h", 5]})"));
  EXPECT_TRUE(MessageDifferencer::Equals(parse_model(written), model)) << written;

  const auto refused = [](const std::string& members) {
    return model_refusal("{\"features\": [], " + members + "}");
  };
  EXPECT_EQ(refused(R"("sizes": [{"id": "a", "on": "b"}])").reason, "MISSING_FIELD");
  EXPECT_EQ(refused(R"("sizes": [{"id": "a", "size": 1}])").reason, "MISSING_FIELD");
  EXPECT_EQ(refused(R"("sizes": [{"id": "a", "on": "b", "in": {}, "size": 1}])").reason,
            "WRONG_KIND");
  EXPECT_EQ(refused(R"("sizes": [{"id": "a", "in": {"ball": [1, 2, 3]}, "size": 1}])").parameter,
            "sizes[0].in.ball");
  EXPECT_EQ(refused(R"("groups": {"a": 1})").parameter, "groups.a");
  EXPECT_EQ(refused(R"("groups": {"a": {}})").reason, "MISSING_FIELD");
}

TEST(Document, EditsOfSizesAndGroupsAreReadAndWritten) {
  const v1::ModelEdit edit = parse_edit(R"({"edits": [
    {"setSize": {"id": "holes", "size": 2}},
    {"removeSize": {"id": "holes"}},
    {"setGroup": {"name": "load", "policy": {"onEmptied": "warn"}}},
    {"remove_group": {"name": "load"}}]})");
  EXPECT_EQ(edit.edits(0).set_size().size().number_value(), 2);
  EXPECT_EQ(edit.edits(1).remove_size().id(), "holes");
  EXPECT_EQ(edit.edits(2).set_group().policy().on_emptied(), "warn");
  EXPECT_EQ(edit.edits(3).remove_group().name(), "load");
  EXPECT_TRUE(MessageDifferencer::Equals(parse_edit(write_document(edit)), edit));
  EXPECT_EQ(edit_refusal(R"({"edits": [{"setSize": {"size": 2}}]})").reason, "MISSING_FIELD");
}

TEST(Document, NamesAreReadInSnakeCaseToo) {
  const v1::FeatureModel model = parse_model(
      with_feature(R"("reference_point": [1, 2, 3], "placement": {"z_axis": [0, 0, 1]})"));
  EXPECT_EQ(model.features(0).reference_point().values(2).number_value(), 3);
  EXPECT_EQ(model.features(0).placement().z_axis(2).number_value(), 1);
  const v1::ModelEdit edit = parse_edit(
      R"({"edits": [{"set_feature_parameter": {"feature": "a", "name": "radius", "value": 2}}]})");
  EXPECT_EQ(edit.edits(0).set_feature_parameter().feature(), "a");

  EXPECT_EQ(model_refusal(with_feature(R"("placement": {"z_axis": [0, 0, 1], "zAxis": [0, 0, 1]})"))
                .reason,
            "DUPLICATE_KEY");
  EXPECT_EQ(model_refusal(with_feature(R"("reference_Point": [1, 2, 3])")).reason, "UNKNOWN_FIELD");
}

TEST(Document, EveryMistakeTellsItsLineAndColumn) {
  const auto at = [](const DocumentErrorInfo& info) {
    return std::to_string(info.at.line) + ":" + std::to_string(info.at.column);
  };
  // Of a value: its first character. Columns count characters.
  EXPECT_EQ(at(model_refusal("{\n  \"name\": \"\xC3\xA9\", \"unit\": null,\n \"features\": []}")),
            "2:24");
  EXPECT_EQ(at(model_refusal("{\"features\": [\n\t12 ,\n  false]}")), "2:2");
  EXPECT_EQ(at(model_refusal("{\"features\": [], \"parameters\": {\"a\": [1]}}")), "1:38");
  // Of an unknown field or a key that stands twice: the key.
  EXPECT_EQ(at(model_refusal("{\"features\": [],\n  \"name\" : \"x\",\n   \"nmae\": 1}")), "3:4");
  EXPECT_EQ(at(model_refusal("{\"name\": \"x\",\r\n\"name\": \"y\"}")), "2:1");
  // Of a missing field: the object that lacks it.
  EXPECT_EQ(at(edit_refusal("{\"edits\":\n[ {\"removeFeature\":\n  {} }]}")), "3:3");
  EXPECT_EQ(at(model_refusal("{\n\"features\": []\n,}")), "3:2");
  EXPECT_EQ(at(model_refusal("[" + std::string(39, '[') + "\n  [")), "2:3");
  EXPECT_THAT(model_refusal("{\n\"features\": 1}").message, HasSubstr("line 2, column 13"));
}

TEST(Document, AnEditWithoutEditsIsRefused) {
  const auto info = edit_refusal(R"({"edits": []})");
  EXPECT_EQ(info.reason, "NO_EDITS");
  EXPECT_EQ(info.at.column, 11U);
}

TEST(Document, MistakesInAFeatureNameItById) {
  const auto unknown = model_refusal(with_feature(R"("placment": {})"));
  EXPECT_EQ(unknown.reason, "UNKNOWN_FIELD");
  EXPECT_EQ(unknown.feature, "hole1");
  EXPECT_THAT(unknown.message, HasSubstr("'placment'"));
  EXPECT_THAT(unknown.hint, HasSubstr("placement"));

  const auto null = model_refusal(with_feature(R"("parameters": {"radius": null})"));
  EXPECT_EQ(null.reason, "WRONG_KIND");
  EXPECT_EQ(null.feature, "hole1");
  EXPECT_EQ(null.parameter, "radius");
  EXPECT_THAT(null.message, HasSubstr("null"));

  EXPECT_EQ(model_refusal(with_feature(R"("parameters": {"radius": true})")).parameter, "radius");
  EXPECT_EQ(model_refusal(with_feature(R"("placement": {"origin": [0, 0]})")).parameter,
            "placement.origin");
  EXPECT_EQ(model_refusal(with_feature(R"("placement": {"zAxis": [0, 0, false]})")).parameter,
            "placement.zAxis[2]");
  EXPECT_EQ(model_refusal(with_feature(R"("reference": "CENTER")")).parameter, "reference");
  EXPECT_EQ(model_refusal(with_feature(R"("reference": 1)")).parameter, "reference");
  EXPECT_EQ(
      model_refusal(with_feature(R"("reference": "CENTRE", "referencePoint": [0, 0, 0])")).feature,
      "hole1");
}

TEST(Document, NumericEnumeratorsAndMissingFieldsAreRefused) {
  EXPECT_EQ(model_refusal(R"({"features": [{"id": "a", "nature": 1, "type": "block"}]})").parameter,
            "nature");
  EXPECT_EQ(model_refusal(
                R"({"features": [{"id": "a", "nature": "NATURE_UNSPECIFIED", "type": "block"}]})")
                .reason,
            "WRONG_KIND");
  EXPECT_EQ(model_refusal(R"({"features": [{"id": "a", "type": "block"}]})").reason,
            "MISSING_FIELD");
  EXPECT_EQ(model_refusal(R"({"features": [{"nature": "ADDITIVE", "type": "block"}]})").parameter,
            "features[0]");
  EXPECT_EQ(model_refusal(R"({"name": "x"})").reason, "MISSING_FIELD");
  EXPECT_EQ(model_refusal(R"({"features": [null]})").reason, "WRONG_KIND");
  EXPECT_EQ(model_refusal(R"([])").reason, "WRONG_KIND");
}

TEST(Document, WhatProtobufsParserForgivesIsRefusedWithItsPlace) {
  EXPECT_EQ(model_refusal("{\"features\": [],}").reason, "DOCUMENT_MALFORMED");
  EXPECT_EQ(model_refusal("{'features': []}").reason, "DOCUMENT_MALFORMED");
  EXPECT_EQ(model_refusal("{features: []}").reason, "DOCUMENT_MALFORMED");
  EXPECT_EQ(model_refusal("{\"features\": []} x").reason, "DOCUMENT_MALFORMED");
  EXPECT_EQ(model_refusal("{\"features\": [] // none\n}").reason, "DOCUMENT_MALFORMED");
  EXPECT_EQ(model_refusal("{\"features\": [], \"features\": []}").reason, "DUPLICATE_KEY");
  EXPECT_EQ(model_refusal("{\"name\": NaN, \"features\": []}").reason, "DOCUMENT_MALFORMED");
  EXPECT_EQ(model_refusal("{\"parameters\": {\"r\": 1e999}, \"features\": []}").reason,
            "DOCUMENT_MALFORMED");
  EXPECT_EQ(model_refusal("{\"name\": \"\xC3\x28\", \"features\": []}").reason,
            "DOCUMENT_MALFORMED");
  EXPECT_EQ(model_refusal("").reason, "DOCUMENT_MALFORMED");
  EXPECT_THAT(model_refusal("{\n  \"features\": [\n}").message, HasSubstr("line 3, column 1"));
}

TEST(Document, EditsNameTheirIndexAndFeature) {
  const auto unknown = edit_refusal(
      R"({"edits": [{"removeFeature": {"feature": "a"}}, {"moveFeature": {"feature": "b"}}]})");
  EXPECT_EQ(unknown.reason, "UNKNOWN_FIELD");
  EXPECT_EQ(unknown.edit_index, 1);
  EXPECT_THAT(unknown.hint, HasSubstr("setFeatureParameter"));

  const auto value = edit_refusal(
      R"({"edits": [{"setFeatureParameter": {"feature": "hole1", "name": "radius", "value": null}}]})");
  EXPECT_EQ(value.feature, "hole1");
  EXPECT_EQ(value.edit_index, 0);

  EXPECT_EQ(edit_refusal(R"({"edits": [{}]})").reason, "WRONG_KIND");
  EXPECT_EQ(edit_refusal(R"({"edits": [{"setParameter": {"name": "r"}}]})").reason,
            "MISSING_FIELD");
  EXPECT_EQ(edit_refusal(R"({"edits": [{"setParameter": {"name": "r", "value": [1]}}]})").reason,
            "WRONG_KIND");
  EXPECT_EQ(
      edit_refusal(
          R"({"edits": [{"removeFeature": {"feature": "a"}, "setParameter": {"name": "r", "value": 1}}]})")
          .reason,
      "WRONG_KIND");
  EXPECT_EQ(edit_refusal(R"({"features": []})").reason, "MISSING_FIELD");
}

}  // namespace
}  // namespace remeshd

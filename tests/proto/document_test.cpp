#include "proto/document.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/message_differencer.h>

#include <filesystem>
#include <fstream>

#include "proto/document_error.h"
#include "proto/json_writer.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using google::protobuf::util::MessageDifferencer;
using testing::HasSubstr;

/// The error that a text is refused with; fails the test where it is taken.
template <typename Parse>
DocumentErrorInfo refusal(Parse parse) {
  try {
    parse();
  } catch (const DocumentError& error) {
    return error.info();
  }
  ADD_FAILURE() << "the text was taken";
  return {};
}
DocumentErrorInfo model_refusal(const std::string& text) {
  return refusal([&] { parse_model(text); });
}
DocumentErrorInfo edit_refusal(const std::string& text) {
  return refusal([&] { parse_edit(text); });
}

std::string with_feature(const std::string& members) {
  return R"({"features": [{"id": "hole1", "nature": "SUBTRACTIVE", "type": "cylinder")" +
         (members.empty() ? "" : ", " + members) + "}]}";
}

std::vector<std::filesystem::path> case_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(REMESHD_CASES_DIR))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Document, EveryCaseReadsAsProtobufsOwnParserReadsIt) {
  ASSERT_GE(case_files().size(), 28U);
  for (const auto& file : case_files()) {
    SCOPED_TRACE(file.filename());
    const std::string text = read_document(file);
    if (file.string().ends_with(".edit.json")) {
      v1::ModelEdit theirs;
      ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(text, &theirs).ok());
      EXPECT_TRUE(MessageDifferencer::Equals(parse_edit(text), theirs));
      EXPECT_TRUE(std::holds_alternative<v1::ModelEdit>(parse_document(text)));
    } else {
      v1::FeatureModel theirs;
      ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(text, &theirs).ok());
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

TEST(Document, AReferencePointIsAListOfThreeValues) {
  const v1::FeatureModel model = parse_model(with_feature(R"("referencePoint": [0, "h/2", 5])"));
  ASSERT_EQ(model.features(0).reference_choice_case(), v1::Feature::kReferencePoint);
  EXPECT_EQ(model.features(0).reference_point().values(1).string_value(), "h/2");
  EXPECT_EQ(model.features(0).reference_point().values(2).number_value(), 5);
}

TEST(Document, ProfilesKeepPointsAndArcs) {
  const v1::FeatureModel model = parse_model(
      with_feature(R"("parameters": {"profile": [[0, 0], {"to": [1, "r"], "through": [2, 3]}]})"));
  const auto& profile = model.features(0).parameters().at("profile").list_value();
  ASSERT_EQ(profile.values_size(), 2);
  EXPECT_EQ(profile.values(0).list_value().values(1).number_value(), 0);
  const auto& arc = profile.values(1).struct_value().fields();
  EXPECT_EQ(arc.at("to").list_value().values(1).string_value(), "r");
  EXPECT_EQ(arc.at("through").list_value().values(0).number_value(), 2);
}

TEST(Document, MistakesInAFeatureNameItById) {
  const auto unknown = model_refusal(with_feature(R"("placment": {})"));
  EXPECT_EQ(unknown.reason, "UnknownField");
  EXPECT_EQ(unknown.feature, "hole1");
  EXPECT_THAT(unknown.message, HasSubstr("'placment'"));
  EXPECT_THAT(unknown.hint, HasSubstr("placement"));

  const auto null = model_refusal(with_feature(R"("parameters": {"radius": null})"));
  EXPECT_EQ(null.reason, "WrongKind");
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
            "WrongKind");
  EXPECT_EQ(model_refusal(R"({"features": [{"id": "a", "type": "block"}]})").reason,
            "MissingField");
  EXPECT_EQ(model_refusal(R"({"features": [{"nature": "ADDITIVE", "type": "block"}]})").parameter,
            "features[0]");
  EXPECT_EQ(model_refusal(R"({"name": "x"})").reason, "MissingField");
  EXPECT_EQ(model_refusal(R"({"features": [null]})").reason, "WrongKind");
  EXPECT_EQ(model_refusal(R"([])").reason, "WrongKind");
}

TEST(Document, WhatProtobufsParserForgivesIsRefusedWithItsPlace) {
  EXPECT_EQ(model_refusal("{\"features\": [],}").reason, "DocumentMalformed");
  EXPECT_EQ(model_refusal("{'features': []}").reason, "DocumentMalformed");
  EXPECT_EQ(model_refusal("{features: []}").reason, "DocumentMalformed");
  EXPECT_EQ(model_refusal("{\"features\": []} x").reason, "DocumentMalformed");
  EXPECT_EQ(model_refusal("{\"features\": [] // none\n}").reason, "DocumentMalformed");
  EXPECT_EQ(model_refusal("{\"features\": [], \"features\": []}").reason, "DuplicateKey");
  EXPECT_EQ(model_refusal("{\"name\": NaN, \"features\": []}").reason, "DocumentMalformed");
  EXPECT_EQ(model_refusal("{\"parameters\": {\"r\": 1e999}, \"features\": []}").reason,
            "DocumentMalformed");
  EXPECT_EQ(model_refusal("{\"name\": \"\xC3\x28\", \"features\": []}").reason,
            "DocumentMalformed");
  EXPECT_EQ(model_refusal("").reason, "DocumentMalformed");
  EXPECT_THAT(model_refusal("{\n  \"features\": [\n}").message, HasSubstr("line 3, column 1"));
}

TEST(Document, EditsNameTheirIndexAndFeature) {
  const auto unknown = edit_refusal(
      R"({"edits": [{"removeFeature": {"feature": "a"}}, {"moveFeature": {"feature": "b"}}]})");
  EXPECT_EQ(unknown.reason, "UnknownField");
  EXPECT_EQ(unknown.edit_index, 1);
  EXPECT_THAT(unknown.hint, HasSubstr("setFeatureParameter"));

  const auto value = edit_refusal(
      R"({"edits": [{"setFeatureParameter": {"feature": "hole1", "name": "radius", "value": null}}]})");
  EXPECT_EQ(value.feature, "hole1");
  EXPECT_EQ(value.edit_index, 0);

  EXPECT_EQ(edit_refusal(R"({"edits": [{}]})").reason, "WrongKind");
  EXPECT_EQ(edit_refusal(R"({"edits": [{"setParameter": {"name": "r"}}]})").reason, "MissingField");
  EXPECT_EQ(edit_refusal(R"({"edits": [{"setParameter": {"name": "r", "value": [1]}}]})").reason,
            "WrongKind");
  EXPECT_EQ(
      edit_refusal(
          R"({"edits": [{"removeFeature": {"feature": "a"}, "setParameter": {"name": "r", "value": 1}}]})")
          .reason,
      "WrongKind");
  EXPECT_EQ(edit_refusal(R"({"features": []})").reason, "MissingField");
}

TEST(Document, ListsNestedAHundredThousandDeepAreRefused) {
  const std::string deep(100000, '[');
  EXPECT_EQ(model_refusal(with_feature("\"parameters\": {\"profile\": " + deep)).reason,
            "DocumentTooDeep");
  const std::string objects = [] {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "{\"a\":";
    return text;
  }();
  EXPECT_EQ(model_refusal(objects).reason, "DocumentTooDeep");
}

TEST(Document, FortyLevelsAreTakenAndFortyOneAreNot) {
  const auto nested = [](int lists) {
    // The document, its features, the feature and its parameters are four levels themselves.
    return with_feature("\"parameters\": {\"profile\": " + std::string(lists, '[') +
                        std::string(lists, ']') + "}");
  };
  EXPECT_NO_THROW(parse_model(nested(36)));
  EXPECT_EQ(model_refusal(nested(37)).reason, "DocumentTooDeep");
}

TEST(Document, AHundredMegabytesAreRefusedUnread) {
  const auto file = std::filesystem::temp_directory_path() / "remeshd_document_test_large.json";
  std::ofstream(file).put('{');
  std::filesystem::resize_file(file, 100'000'000);
  const auto info = refusal([&] { read_document(file); });
  std::filesystem::remove(file);
  EXPECT_EQ(info.reason, "DocumentTooLarge");
  EXPECT_THAT(info.message, HasSubstr("100000000"));
  EXPECT_EQ(model_refusal(std::string((std::size_t{4} << 20) + 1, ' ')).reason, "DocumentTooLarge");
}

TEST(Document, FilesThatCannotBeReadSayWhy) {
  EXPECT_THAT(refusal([] { read_document("/nonexistent/model.json"); }).message,
              HasSubstr("No such file"));
  EXPECT_THAT(refusal([] { read_document("/tmp"); }).message, HasSubstr("directory"));
}

TEST(Document, LongTextsDoNotSwampTheError) {
  const auto info = model_refusal("{\"" + std::string(100000, 'x') + "\": 1, \"features\": []}");
  EXPECT_LT(info.message.size(), 400U);
}

}  // namespace
}  // namespace remeshd

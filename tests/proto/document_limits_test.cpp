#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "proto/document.h"
#include "tests/proto/refusal.h"
#include "tests/support/temporary_folder.h"

namespace remeshd {
namespace {

using test::model_refusal;
using test::refusal;
using test::with_feature;
using testing::HasSubstr;

TEST(Document, ListsNestedAHundredThousandDeepAreRefused) {
  const std::string deep(100000, '[');
  EXPECT_EQ(model_refusal(with_feature("\"parameters\": {\"profile\": " + deep)).reason,
            "DOCUMENT_TOO_DEEP");
  const std::string objects = [] {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "{\"a\":";
    return text;
  }();
  EXPECT_EQ(model_refusal(objects).reason, "DOCUMENT_TOO_DEEP");
}

TEST(Document, FortyLevelsAreTakenAndFortyOneAreNot) {
  const auto nested = [](int lists) {
    // The document, its features, the feature and its parameters are four levels themselves.
    return with_feature("\"parameters\": {\"profile\": " + std::string(lists, '[') +
                        std::string(lists, ']') + "}");
  };
  EXPECT_NO_THROW(parse_model(nested(36)));
  EXPECT_EQ(model_refusal(nested(37)).reason, "DOCUMENT_TOO_DEEP");
}

TEST(Document, AHundredMegabytesAreRefusedUnread) {
  const TemporaryFolder folder;
  const auto file = folder / "large.json";
  std::ofstream(file).put('{');
  std::filesystem::resize_file(file, 100'000'000);
  const auto info = refusal([&] { read_document(file); });
  EXPECT_EQ(info.reason, "DOCUMENT_TOO_LARGE");
  EXPECT_THAT(info.message, HasSubstr("100000000"));
  EXPECT_EQ(model_refusal(std::string((std::size_t{4} << 20) + 1, ' ')).reason,
            "DOCUMENT_TOO_LARGE");
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

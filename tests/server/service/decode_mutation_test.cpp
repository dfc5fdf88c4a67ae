#include <google/protobuf/stubs/logging.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/random.h"
#include "engine/model/feature_model.h"
#include "proto/document.h"
#include "server/service/decode.h"
#include "server/service/encode.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

TEST(Decode, OfDamagedMessagesEndsInAModelOrAnErrorInWords) {
  const google::protobuf::LogSilencer silence;
  Random random(20090202);
  int decoded = 0;
  for (const auto& file : std::filesystem::directory_iterator(REMESHD_CASES_DIR)) {
    const auto document = parse_document(
        file.path().extension() == ".json" ? read_document(file.path()) : "{\"features\": []}");
    const auto* model = std::get_if<v1::FeatureModel>(&document);
    if (model == nullptr) continue;
    const std::string bytes = model->SerializeAsString();
    for (int i = 0; i < 300; ++i) {
      std::string damaged = bytes;
      for (std::uint64_t n = 1 + random.below(3); n > 0 && !damaged.empty(); --n)
        damaged[random.below(damaged.size())] = static_cast<char>(random.next());
      v1::FeatureModel message;
      if (!message.ParseFromString(damaged)) continue;
      try {
        const ModelSource source = decode(message);
        ++decoded;
        EXPECT_EQ(decode(encode(source)), source);
        evaluate(source);
      } catch (const Error& error) {
        EXPECT_NE(error.info().kind, ErrorKind::Internal) << error.what();
        EXPECT_FALSE(error.info().reason.empty());
      }
    }
  }
  EXPECT_GT(decoded, 100);
}

TEST(Decode, GivesBackEveryCaseThatWasEncoded) {
  int models = 0;
  for (const auto& file : std::filesystem::directory_iterator(REMESHD_CASES_DIR)) {
    if (file.path().extension() != ".json") continue;
    const auto document = parse_document(read_document(file.path()));
    const auto* model = std::get_if<v1::FeatureModel>(&document);
    if (model == nullptr) continue;
    ++models;
    EXPECT_EQ(decode(encode(decode(*model))), decode(*model)) << file.path();
  }
  EXPECT_GE(models, 17);  // those of tests/cases
}

}  // namespace
}  // namespace remeshd

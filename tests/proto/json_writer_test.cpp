#include "proto/json_writer.h"

#include <gmock/gmock.h>

#include <bit>
#include <limits>
#include <nlohmann/json.hpp>

#include "remesh/v1/remesh.pb.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

TEST(JsonWriter, AReportHasTheNamesOfTheContractCountsAsNumbersAndZeros) {
  v1::Report report;
  report.set_revision("ab");
  report.set_nodes(15000);
  report.mutable_seconds()->set_total(1.25);
  report.mutable_quality()->set_dihedral_min(25.5);
  const auto json = nlohmann::json::parse(write_json(report));
  EXPECT_EQ(json["revision"], "ab");
  EXPECT_TRUE(json["nodes"].is_number_integer());
  EXPECT_EQ(json["nodes"], 15000);
  EXPECT_EQ(json["nodes_kept"], 0);
  EXPECT_EQ(json["tets_kept"], 0);
  EXPECT_EQ(json["cached"], false);
  EXPECT_EQ(json["free_share"], 0);
  EXPECT_EQ(json["seconds"]["total"], 1.25);
  EXPECT_EQ(json["quality"]["dihedral_min"], 25.5);
  EXPECT_EQ(json["quality"]["volume_length_mean"], 0);
  EXPECT_EQ(json["warnings"], nlohmann::json::array());
}

TEST(JsonWriter, NumbersReadBackToTheSameBits) {
  v1::Report report;
  for (const double value : {0.1, -1.0 / 3, 5e-324, 1.7976931348623157e308, 0.0, 258000.0}) {
    report.set_volume(value);
    const auto json = nlohmann::json::parse(write_json(report));
    const double back = json["volume"];
    EXPECT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value))
        << json["volume"];
  }
}

TEST(JsonWriter, ZeroHasNoSign) {
  v1::Report report;
  report.set_volume(-0.0);
  EXPECT_THAT(write_json(report), testing::HasSubstr("\"volume\": 0,"));
}

TEST(JsonWriter, SixtyFourBitIntegersAreNumbers) {
  v1::MeshOptions options;
  options.set_seed(std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(nlohmann::json::parse(write_json(options))["seed"],
            std::numeric_limits<std::uint64_t>::max());
}

TEST(JsonWriter, MapsAreSorted) {
  v1::Comparison comparison;
  auto& cells = *comparison.add_features()->mutable_cells();
  for (const char* key : {"--", "++", ".+", "+-"}) cells[key] = 1;
  EXPECT_THAT(write_json(comparison),
              testing::HasSubstr(R"("cells": {"++": 1, "+-": 1, "--": 1, ".+": 1})"));
}

TEST(JsonWriter, ControlCharactersAndQuotesAreEscaped) {
  v1::Report report;
  const std::string text = "a \"b\"\\\n\x01 \xC3\xA9";
  report.add_warnings()->set_message(text);
  EXPECT_EQ(nlohmann::json::parse(write_json(report))["warnings"][0]["message"], text);
}

TEST(JsonWriter, LinesKeepToTheWidthWhereTheirValuesAllow) {
  v1::Diagnostics diagnostics;
  for (std::uint32_t i = 0; i < 200; ++i) diagnostics.add_free_per_iteration(i);
  const std::string text = write_json(diagnostics);
  std::size_t start = 0;
  for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
    EXPECT_LE(end - start, 100U) << text.substr(start, end - start);
}

}  // namespace
}  // namespace remeshd

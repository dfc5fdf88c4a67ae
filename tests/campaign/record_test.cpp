#include "tests/campaign/record.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/cases.h"
#include "tests/support/temporary_folder.h"

namespace remeshd::campaign {
namespace {

WorkedCase some_case() {
  WorkedCase worked;
  worked.campaign_case = {.seed = 3, .number = 14, .model = test::case_model("simple-a")};
  worked.gentle = true;
  worked.facts.push_back({.measured = true, .wedge = true, .types = {"block"}});
  worked.discarded["EMPTY_MODEL"] = 2;
  Outcome refused;
  refused.kind = "refused";
  refused.reason = "BOUNDARY_NOT_RECOVERED";
  worked.outcomes.push_back(refused);
  worked.made = true;
  return worked;
}

struct RecordTest : testing::Test {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "record.jsonl";
};

TEST_F(RecordTest, GivesBackWhatWasAddedToEarlierOnes) {
  Record(file).add({3, 14}, some_case());
  const Record record(file);
  const auto found = record.find({3, 14});
  ASSERT_TRUE(found);
  EXPECT_EQ(write_worked(*found), write_worked(some_case()));
  EXPECT_FALSE(record.find({3, 15}));
  EXPECT_FALSE(record.find({4, 14}));
}

TEST_F(RecordTest, TellsCasesOfPartsFromOthersAndByTheirMeshes) {
  const CaseRequest part{3, 14, 800, false};
  Record(file).add(part, some_case());
  const Record record(file);
  EXPECT_TRUE(record.find(part));
  EXPECT_FALSE(record.find({3, 14}));
  EXPECT_FALSE(record.find({3, 14, {}, true}));
  EXPECT_FALSE(record.find({3, 14, 900, false}));
  EXPECT_FALSE(record.find({3, 14, 800, true}));
}

TEST_F(RecordTest, PassesOverLinesOfOtherBuildsAndAnEndThatIsMissing) {
  Record(file).add({3, 14}, some_case());
  std::string line;
  std::getline(std::ifstream(file), line);
  nlohmann::json other = nlohmann::json::parse(line);
  other["build"] = 1;
  other["request"] = CaseRequest{3, 15}.arguments();
  std::ofstream(file, std::ios::app) << other.dump() << "\n" << line.substr(0, 100);
  const Record record(file);
  EXPECT_TRUE(record.find({3, 14}));
  EXPECT_FALSE(record.find({3, 15}));
}

TEST_F(RecordTest, OfNoFileRemembersNothing) {
  const Record record{std::filesystem::path()};
  record.add({3, 14}, some_case());
  EXPECT_FALSE(record.find({3, 14}));
}

}  // namespace
}  // namespace remeshd::campaign

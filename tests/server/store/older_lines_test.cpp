#include <gtest/gtest.h>

#include "server/store/checked_line.h"
#include "server/store/journal_line.h"
#include "server/store/pack_head.h"

namespace remeshd {
namespace {

// Lines as they were written before records had a root, a digest of the model and a version of the
// algorithm, and designs a time of their last change.

TEST(OlderLines, OfTheJournalAreRead) {
  const auto line = read_journal_line(checked_line(
      R"({"version": 2, "number": 3, "operations": [)"
      R"({"add_revision": "aa", "parent": "", "model_name": "m", "created_ns": 5, "nodes": 7,)"
      R"( "tets": 8, "bytes": 9},)"
      R"({"add_revision": "bb", "parent": "aa", "model_name": "m", "created_ns": 5, "nodes": 7,)"
      R"( "tets": 8, "bytes": 9},)"
      R"({"add_design": "d", "next_number": 4}]})"));
  ASSERT_TRUE(line);
  const auto& first = std::get<AddRevision>(line->transaction.at(0)).record;
  EXPECT_EQ(first.nodes, 7U);
  EXPECT_EQ(first.root, "aa") << "a first mesh is its own root";
  EXPECT_EQ(first.model, "");
  EXPECT_EQ(first.algorithm_version, 0U);
  EXPECT_EQ(first.mid_nodes, 0U);
  EXPECT_EQ(std::get<AddRevision>(line->transaction.at(1)).record.root, "");
  const auto& design = std::get<AddDesign>(line->transaction.at(2));
  EXPECT_EQ(design.changed_ns, 0);
  EXPECT_TRUE(design.listed);
}

TEST(OlderLines, OfPacksAreRead) {
  const std::string head = checked_line(
      R"({"format": "remeshd-pack", "store": 1, "id": "aa", "parent": "", "model_name": "m",)"
      R"( "created_ns": 5, "nodes": 7, "tets": 8, "design": "d", "number": 2, "sha256": "ff"})");
  const auto read = read_pack_head(head);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->record.nodes, 7U);
  EXPECT_EQ(read->record.root, "aa");
  EXPECT_EQ(read->record.algorithm_version, 0U);
  EXPECT_EQ(read->record.mid_nodes, 0U);
  EXPECT_EQ(read->record.created_ns, 5);
  EXPECT_EQ(read->data, "ff");
}

TEST(OlderLines, OfTodayTellEverything) {
  RevisionRecord record{.id = "bb",
                        .parent = "aa",
                        .root = "aa",
                        .model_name = "m",
                        .model = "ee",
                        .algorithm_version = 3,
                        .created_ns = 5,
                        .nodes = 7,
                        .tets = 8,
                        .mid_nodes = 9,
                        .base = "aa",
                        .seconds = {0.1, 2}};
  const auto line = read_journal_line(write_journal_line(
      {.number = 1,
       .transaction = {
           AddRevision{record},
           AddDesign{.name = "d", .next_number = 4, .changed_ns = 6, .listed = false}}}));
  ASSERT_TRUE(line);
  EXPECT_EQ(std::get<AddRevision>(line->transaction.at(0)).record, record);
  const auto& design = std::get<AddDesign>(line->transaction.at(1));
  EXPECT_EQ(design.changed_ns, 6);
  EXPECT_FALSE(design.listed);
  const auto head = read_pack_head(write_pack_head({.record = record, .first = {.design = "d"}}));
  ASSERT_TRUE(head);
  record.created_ns = 0;  // which, like the seconds, differs between equal revisions
  record.seconds = {};
  EXPECT_EQ(head->record, record);
}

}  // namespace
}  // namespace remeshd

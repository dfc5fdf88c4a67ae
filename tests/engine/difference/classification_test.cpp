#include "engine/difference/classification.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace remeshd {
namespace {

struct Row {
  char original, modified;
  std::string_view words;
};

// Table 1 of the paper, as printed.
constexpr std::array<Row, 8> kTable1{{
    {'b', 'b', "Persistent-identical: boundary"},
    {'n', 'n', "Persistent-identical: non-boundary"},
    {'n', 'b', "Persistent-different: modified to boundary"},
    {'b', 'n', "Persistent-different: modified to non-boundary"},
    {'.', 'b', "New: boundary"},
    {'.', 'n', "New: non-boundary"},
    {'b', '.', "Old: boundary"},
    {'n', '.', "Old: non-boundary"},
}};

// Table 2 of the paper, as printed.
constexpr std::array<Row, 8> kTable2{{
    {'+', '+', "Persistent-identical: positive nature"},
    {'-', '-', "Persistent-identical: negative nature"},
    {'-', '+', "Persistent-different: modified to pos. nature"},
    {'+', '-', "Persistent-different: modified to neg. nature"},
    {'.', '+', "New: positive nature"},
    {'.', '-', "New: negative nature"},
    {'+', '.', "Old: positive nature"},
    {'-', '.', "Old: negative nature"},
}};

Mark mark(char c) { return c == 'b' || c == '+' ? Mark::Yes : c == '.' ? Mark::Absent : Mark::No; }

TEST(ClassificationTest, Table1RowByRow) {
  for (const Row& row : kTable1) {
    const DifferenceClass value = classify(mark(row.original), mark(row.modified));
    ASSERT_NE(find_classification(value), nullptr) << row.words;
    EXPECT_EQ(find_classification(value)->words, row.words);
    EXPECT_EQ(geometry_class_name(value), (std::string{row.original, row.modified}));
  }
}

TEST(ClassificationTest, Table2RowByRow) {
  for (const Row& row : kTable2) {
    const DifferenceClass value = classify(mark(row.original), mark(row.modified));
    ASSERT_NE(find_classification(value), nullptr) << row.words;
    EXPECT_EQ(find_classification(value)->cell_words, row.words);
    EXPECT_EQ(cell_class_name(value), (std::string{row.original, row.modified}));
  }
}

TEST(ClassificationTest, RelationsAreTheFourOfThePaper) {
  for (const Classification& row : kClassifications) {
    const Relation expected = row.original == Mark::Absent   ? Relation::New
                              : row.modified == Mark::Absent ? Relation::Old
                              : row.original == row.modified ? Relation::PersistentIdentical
                                                             : Relation::PersistentDifferent;
    EXPECT_EQ(row.relation, expected) << row.words;
  }
}

TEST(ClassificationTest, WhatIsInNeitherModelHasNoRow) {
  EXPECT_EQ(classify(Mark::Absent, Mark::Absent), DifferenceClass::Artefact);
  EXPECT_EQ(find_classification(DifferenceClass::Artefact), nullptr);
  EXPECT_EQ(cell_class_name(DifferenceClass::Artefact), "artefact");
}

TEST(ClassificationTest, ReportsPrintEveryClassOnceInTheirOrder) {
  std::string cells;
  for (const DifferenceClass c : kAllClasses) cells += std::string(cell_class_name(c)) + " ";
  EXPECT_EQ(cells, "++ +- -+ -- .+ .- +. -. artefact ");
  std::set<std::string_view> faces;
  for (const DifferenceClass c : kAllClasses) faces.insert(geometry_class_name(c));
  EXPECT_EQ(faces.size(), kDifferenceClasses);
}

}  // namespace
}  // namespace remeshd

#include <gmock/gmock.h>

#include "engine/remesh/remesh.h"
#include "engine/revision/storage/stored_documents.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

using test::kRun;

std::vector<std::string> tried_strategies(const Report& report) {
  std::vector<std::string> names;
  for (const TriedStrategy& attempt : report.attempts) names.push_back(attempt.strategy);
  return names;
}

/// Each tells why, and none took longer than all of it.
void expect_told(const Report& report) {
  double together = 0;
  EXPECT_GT(report.geometry_seconds, 0);
  EXPECT_THAT(report.taken.reason, IsEmpty());
  EXPECT_GT(report.taken.seconds, 0);
  together += report.geometry_seconds + report.taken.seconds;
  for (const TriedStrategy& attempt : report.attempts) {
    EXPECT_THAT(attempt.reason, testing::Not(IsEmpty())) << attempt.strategy;
    EXPECT_GT(attempt.seconds, 0) << attempt.strategy;
    together += attempt.seconds;
  }
  EXPECT_LE(together, report.seconds.total);
}

/// tool2-c with the end of its base .004 edge lengths behind the wall's: a ledge, which only
/// TetGen's mesh of the whole can follow.
Revision mesh_of_a_ledge() {
  const ModelEdit shorter{{SetFeatureParameter{"base", "dx", 119.98}}};
  return make_revision(Revision::none(), apply(test::case_model("tool2-c"), shorter),
                       {.nodes = 3000}, kRun);
}

/// An edit of a mesh that was made in one iteration from random nodes, in a chain that is said to
/// have begun with a mean volume-length of .87.
Revision edit_of_a_drifted_mesh(const MeshOptions& options) {
  Revision base =
      make_revision(Revision::none(), test::case_model("simple-a"),
                    {.nodes = 2500, .iterations = 1, .start = MeshOptions::Start::Random}, kRun);
  base.reference.volume_length_mean = 0.87;
  return make_revision(base, apply(base.source, test::case_edit("simple-ab")), options, kRun);
}

TEST(Attempts, AreNoneWhereTheFirstStrategyServes) {
  const Revision first =
      make_revision(Revision::none(), test::case_model("simple-a"), {.nodes = 500}, kRun);
  EXPECT_THAT(first.report.attempts, IsEmpty());
  const Revision same = make_revision(first, first.source, {}, kRun);
  EXPECT_EQ(same.report.strategy, MeshStrategy::Unchanged);
  EXPECT_THAT(same.report.attempts, IsEmpty());
}

TEST(Attempts, OfAMeshByTetGenAreTheWaysBeforeIt) {
  const Revision made = mesh_of_a_ledge();
  ASSERT_EQ(made.report.strategy, MeshStrategy::TetGen);
  const std::string refilled = "local, everywhere, refilled";
  EXPECT_THAT(tried_strategies(made.report), ElementsAre(refilled, refilled, "local, everywhere"));
  expect_told(made.report);
  EXPECT_THAT(made.report.attempts.back().reason,
              testing::EndsWith("; its boundary takes far more nodes than were asked for"));
}

TEST(Attempts, OfARenewedMeshEndWithTheRemeshThatHadWorn) {
  const Revision made = edit_of_a_drifted_mesh({});
  ASSERT_EQ(made.report.strategy, MeshStrategy::Renewed);
  EXPECT_THAT(
      tried_strategies(made.report),
      ElementsAre("local, 4 edge lengths", "local, 6 edge lengths", "local, 8 edge lengths"));
  expect_told(made.report);
  EXPECT_EQ(made.report.taken.strategy, "renewed");
  EXPECT_EQ(made.report.attempts[0].reason,
            "the part cut out of the base did not suffice for reusing improved tets");
  EXPECT_THAT(made.report.attempts.back().reason, StartsWith("the quality had drifted: "));
}

TEST(Attempts, TellOfARegularMeshThatWasNoBetter) {
  const Revision made =
      edit_of_a_drifted_mesh({.iterations = 1, .start = MeshOptions::Start::Random});
  ASSERT_EQ(made.report.strategy, MeshStrategy::Local);
  EXPECT_THAT(tried_strategies(made.report), ElementsAre("local, 4 edge lengths", "renewed"));
  expect_told(made.report);
  EXPECT_THAT(made.report.attempts.back().reason, StartsWith("no better"));
}

TEST(Attempts, TellOfARegularMeshThatWouldHaveTooManyNodes) {
  // The remesh has its nodes already; a limit that has become lower is no reason to refuse it.
  const MeshOptions options{.nodes = 2500, .sizing = {.even = false}};
  Revision base = make_revision(Revision::none(), test::case_model("tool1-a"), options, kRun);
  base.reference.volume_length_mean = 0.99;
  remeshd::Run limited;
  limited.max_nodes = 2000;
  const Revision made = make_revision(base, apply(base.source, test::case_edit("tool1-ab")),
                                      {.sizing = {.even = false}}, limited);
  ASSERT_EQ(made.report.strategy, MeshStrategy::Local);
  EXPECT_THAT(tried_strategies(made.report), ElementsAre("renewed"));
  expect_told(made.report);
  EXPECT_THAT(made.report.attempts.back().reason,
              testing::HasSubstr("nodes, more than the limit of 2000"));
}

TEST(Attempts, AreStoredButForTheirSeconds) {
  const Revision made = edit_of_a_drifted_mesh({});
  const Report loaded = test::stored_and_loaded(made).report;
  EXPECT_THAT(tried_strategies(loaded), testing::SizeIs(3));
  EXPECT_EQ(tried_strategies(loaded), tried_strategies(made.report));
  EXPECT_EQ(loaded.taken.strategy, "renewed");
  for (std::size_t k = 0; k < loaded.attempts.size(); ++k) {
    EXPECT_EQ(loaded.attempts[k].reason, made.report.attempts[k].reason);
    EXPECT_EQ(loaded.attempts[k].seconds, 0);
  }
}

TEST(Attempts, AreNoneOfRevisionsThatWereStoredBeforeTheyWereTold) {
  Revision made =
      make_revision(Revision::none(), test::case_model("simple-a"), {.nodes = 60}, kRun);
  made.report.figures.clear();
  std::string bytes = write_documents(made);
  ASSERT_EQ(bytes[1], 18);
  // Format 17 had no hold after it.
  bytes[1] = 17;
  bytes.resize(bytes.size() - sizeof(double));
  // Format 16 had no groups of the two models after it, and no figures of groups.
  bytes[1] = 16;
  bytes.resize(bytes.size() - 3 * sizeof(std::uint64_t));
  // Format 15 had no order after it, and nothing of mid-nodes: an id and two counts.
  bytes[1] = 15;
  bytes.resize(bytes.size() - 3 * sizeof(std::uint32_t) - sizeof(std::uint64_t));
  // Format 14 had no sizes of the two models after it and no dense places, none here.
  bytes[1] = 14;
  bytes.resize(bytes.size() - 3 * sizeof(std::uint64_t));
  Revision without_sizes;
  read_documents(bytes, without_sizes);
  EXPECT_EQ(without_sizes.source, made.source);
  // Format 13 had no sizing before them: a switch, two counts, no least size, two factors; nor
  // the nodes that warnings tell of, of which there are none.
  bytes[1] = 13;
  bytes.resize(bytes.size() - 2 - 2 * sizeof(std::uint32_t) - 2 * sizeof(double) -
               sizeof(std::uint64_t) - made.report.warnings.size() * sizeof(std::uint32_t));
  Revision even;
  even.options.sizing.even = false;
  read_documents(bytes, even);
  EXPECT_EQ(even.report.taken.strategy, "local, everywhere");
  EXPECT_EQ(even.options, made.options) << "all meshes of then are even";
  // Format 12 had not what made the mesh: "local, everywhere", and no reason.
  bytes[1] = 12;
  const std::string taken = made.report.taken.strategy;
  ASSERT_EQ(taken, "local, everywhere");
  bytes.resize(bytes.size() - 2 * sizeof(std::uint64_t) - taken.size());
  Revision before;
  read_documents(bytes, before);
  EXPECT_EQ(before.report.taken.strategy, "");
  // Format 11 was the same without the list at the end, empty here.
  bytes[1] = 11;
  bytes.resize(bytes.size() - sizeof(std::uint64_t));
  Revision read;
  read_documents(bytes, read);
  EXPECT_EQ(read.source, made.source);
  EXPECT_EQ(read.report.geometry, "fused");
  // Format 10 had neither the word before it nor the list before that, empty too.
  bytes[1] = 10;
  ASSERT_TRUE(bytes.ends_with("fused"));
  bytes.resize(bytes.size() - 2 * sizeof(std::uint64_t) - 5);
  Revision older;
  read_documents(bytes, older);
  EXPECT_EQ(older.source, made.source);
  EXPECT_THAT(older.report.attempts, IsEmpty());
  EXPECT_EQ(older.report.geometry, "");
}

}  // namespace
}  // namespace remeshd

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random.h"
#include "engine/patch/node_map.h"
#include "engine/remesh/remesh.h"
#include "engine/verify/verify.h"
#include "tests/engine/verify/same_verdict.h"
#include "tests/support/cases.h"
#include "tests/support/flat.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

constexpr MeshOptions kParent{.nodes = 2500, .iterations = 5};
constexpr MeshOptions kOfEdit{.iterations = 5};

/// A mesh and what it claims of its base.
struct Heir {
  TetMesh mesh;
  std::vector<std::int32_t> node, tet;

  explicit Heir(const Revision& r)
      : mesh(test::flat(r.output.mesh)),
        node(r.output.map.original_node.flat()),
        tet(r.output.map.original_tet.flat()) {}
};

Verification whole(const Heir& h, const Revision& r) {
  return verify(paged(h.mesh), r.supports(), r.cells.boundary, r.cells.volume, kRun);
}
Verification inherited(const Heir& h, const Revision& r, const Revision& base) {
  const VerifiedParent parent = verified_parent(base, CowVector(h.node), CowVector(h.tet));
  return verify(paged(h.mesh), r.supports(), r.cells.boundary, r.cells.volume, kRun,
                {.parent = &parent});
}

void expect_both_to_say_the_same(const Revision& r, const Revision& base) {
  const Heir good(r);
  const Verification all = whole(good, r), some = inherited(good, r, base);
  EXPECT_TRUE(all.valid);
  test::expect_same_verdict(all, some);
  ASSERT_EQ(some.surface.size(), r.output.groups.facets.size());
  for (std::size_t f = 0; f < some.surface.size(); ++f) {
    EXPECT_EQ(some.surface[f].nodes, r.output.groups.facets[f].nodes);
    EXPECT_EQ(some.surface[f].tet, r.output.groups.facets[f].tet);
  }
  EXPECT_EQ(r.report.verification.tets_inherited, some.tets_inherited);
  EXPECT_EQ(r.report.verification.tets_proved, some.tets_proved);
  EXPECT_EQ(r.report.verification.chord_error, some.chord_error);

  for (const bool changed : {true, false}) {
    const auto it = std::find_if(good.tet.begin(), good.tet.end(),
                                 [&](std::int32_t t) { return (t < 0) == changed; });
    if (it == good.tet.end()) continue;
    const auto t = it - good.tet.begin();
    Heir twice = good;
    twice.mesh.tets.push_back(good.mesh.tets[t]);
    twice.tet.push_back(*it);
    EXPECT_FALSE(whole(twice, r).valid);
    test::expect_same_verdict(whole(twice, r), inherited(twice, r, base));
    Heir gone = good;
    gone.mesh.tets.erase(gone.mesh.tets.begin() + t);
    gone.tet.erase(gone.tet.begin() + t);
    EXPECT_FALSE(whole(gone, r).valid);
    test::expect_same_verdict(whole(gone, r), inherited(gone, r, base));
    Heir turned = good;
    std::swap(turned.mesh.tets[t][0], turned.mesh.tets[t][1]);
    EXPECT_GT(inherited(turned, r, base).count(MeshFailure::BadTet), 0U);
    test::expect_same_verdict(whole(turned, r), inherited(turned, r, base));
  }
}

TEST(InheritedVerification, OfTheSevenEditsSaysWhatTheWholeOneSays) {
  for (const test::EditCase& c : test::seven_cases()) {
    SCOPED_TRACE(c.edit);
    const Revision base =
        make_revision(Revision::none(), test::case_model(c.original), kParent, kRun);
    EXPECT_EQ(base.report.verification.tets_inherited, 0U);
    EXPECT_EQ(base.report.verification.tets_proved, base.report.counts.tets);
    EXPECT_LT(base.report.verification.volume_error, 2e-3);
    const Revision r =
        make_revision(base, apply(base.source, test::case_edit(c.edit)), kOfEdit, kRun);
    EXPECT_GT(r.report.verification.tets_inherited, 0U);
    expect_both_to_say_the_same(r, base);
  }
}

TEST(InheritedVerification, AlongAChainOfRandomEditsSaysWhatTheWholeOneSays) {
  Revision base = make_revision(Revision::none(), test::case_model("fig11-a"), kParent, kRun);
  Random random(3);
  for (int k = 0; k < 8; ++k) {
    SCOPED_TRACE(k);
    // Steps of all sizes: with some of them the connectivity stays.
    const double step = k % 3 == 0 ? 1e-3 : 1.5;
    const double radius = 8 + random.uniform(-step, step);
    Revision r = make_revision(
        base, apply(base.source, ModelEdit{{SetParameter{"hole_radius", radius}}}), kOfEdit, kRun);
    expect_both_to_say_the_same(r, base);
    base = std::move(r);
  }
}

TEST(InheritedVerification, WhereOnlyNodesMoveOnlyTheirTetsAreProved) {
  const Revision base = make_revision(Revision::none(), test::case_model("fig11-a"), kParent, kRun);
  const Revision r = make_revision(
      base, apply(base.source, ModelEdit{{SetParameter{"hole_radius", 8.001}}}), kOfEdit, kRun);
  ASSERT_EQ(r.report.strategy, MeshStrategy::Morphed);
  EXPECT_EQ(r.report.verification.tets_inherited, r.report.counts.tets_kept);
  EXPECT_LT(r.report.verification.tets_proved, r.report.counts.tets);
  EXPECT_GT(r.report.verification.tets_proved, 0U);
}

TEST(InheritedVerification, AMeshWithoutAChangeInheritsWhole) {
  const Revision base =
      make_revision(Revision::none(), test::case_model("simple-a"), kParent, kRun);
  const Revision r = make_revision(base, base.source, kOfEdit, kRun);
  EXPECT_EQ(r.report.verification.tets_proved, 0U);
  EXPECT_EQ(r.report.verification.tets_inherited, r.report.counts.tets);
  EXPECT_EQ(r.report.verification.chord_error, base.report.verification.chord_error);
}

}  // namespace
}  // namespace remeshd

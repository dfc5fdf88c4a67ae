#include "engine/verify/inheritance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "engine/improve/improve.h"
#include "engine/verify/verify.h"
#include "tests/engine/verify/same_verdict.h"
#include "tests/support/solid_fixture.h"

namespace remeshd {
namespace {

using test::expect_same_verdict;
using test::SolidFixture;

/// A verified mesh and its child, which clean-up has changed at low x.
class Family {
 public:
  explicit Family(SolidFixture parent)
      : parent_(std::move(parent)), child(parent_.mesh), supports(parent_.supports) {
    const Verification v = verify(parent_.mesh, parent_.supports, parent_.boundary, volume(), {});
    EXPECT_TRUE(v.valid);
    surface_ = v.surface;
    volume_ = v.volume;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Vec3& p : child.nodes) low = std::min(low, p.x), high = std::max(high, p.x);
    std::vector<std::uint8_t> dirty;
    for (const Tet& t : child.tets)
      dirty.push_back(child.nodes[t[0]].x < low + 0.4 * (high - low) ? 1 : 0);
    child = improve(child, supports, parent_.boundary, dirty, {}, {}).mesh;
    claim();
  }

  /// Claims what has the same four nodes, in any turn.
  void claim() {
    std::map<Tet, std::int32_t> index;
    for (std::size_t t = 0; t < parent_.mesh.tets.size(); ++t)
      index[key(parent_.mesh.tets[t])] = static_cast<std::int32_t>(t);
    node.resize(child.nodes.size());
    for (std::size_t n = 0; n < node.size(); ++n)
      node[n] = n < parent_.mesh.nodes.size() ? static_cast<std::int32_t>(n) : -1;
    tet.clear();
    for (const Tet& t : child.tets) {
      const auto it = index.find(key(t));
      tet.push_back(it == index.end() ? -1 : it->second);
    }
  }

  [[nodiscard]] double volume() const { return parent_.volume; }
  [[nodiscard]] Verification whole() const {
    return verify(child, supports, parent_.boundary, volume(), {});
  }
  [[nodiscard]] Verification inherited() const {
    const PagedMesh mesh = paged(parent_.mesh);
    const VerifiedParent parent{mesh,    boxes_round(mesh), surface_,
                                volume_, CowVector(node),   CowVector(tet)};
    return verify(child, supports, parent_.boundary, volume(), {}, {.parent = &parent});
  }

  /// The first tet that the claims say is changed or not and that has no node of the boundary.
  [[nodiscard]] std::size_t inner(bool changed) const {
    for (std::size_t t = 0; t < child.tets.size(); ++t)
      if ((tet[t] < 0) == changed &&
          std::all_of(child.tets[t].begin(), child.tets[t].end(),
                      [&](std::int32_t n) { return supports[n].kind == Support::Kind::Interior; }))
        return t;
    ADD_FAILURE() << "no such tet";
    return 0;
  }
  /// The first unchanged tet that has three nodes of changed ones.
  [[nodiscard]] std::size_t rim() const {
    std::vector<std::uint8_t> touched(child.nodes.size(), 0);
    for (std::size_t t = 0; t < child.tets.size(); ++t)
      if (tet[t] < 0)
        for (const std::int32_t n : child.tets[t]) touched[n] = 1;
    for (std::size_t t = 0; t < child.tets.size(); ++t)
      if (tet[t] >= 0 &&
          std::count_if(child.tets[t].begin(), child.tets[t].end(),
                        [&](std::int32_t n) { return touched[n] != 0; }) == 3 &&
          supports[child.tets[t][0]].kind == Support::Kind::Interior)
        return t;
    ADD_FAILURE() << "no such tet";
    return 0;
  }
  void erase(std::size_t t) {
    child.tets.erase(child.tets.begin() + static_cast<std::ptrdiff_t>(t));
  }

 private:
  static Tet key(Tet t) {
    std::sort(t.begin(), t.end());
    return t;
  }

  SolidFixture parent_;
  std::vector<SurfaceFacet> surface_;
  double volume_ = 0;

 public:
  TetMesh child;
  std::vector<Support> supports;
  std::vector<std::int32_t> node, tet;
};

Family box() { return Family(test::make_box({1, 1, 1}, 7, 2)); }

TEST(TetCorrespondence, OfAGoodMeshSaysWhatTheWholeVerificationSays) {
  for (const Family& f : {box(), Family(test::make_cylinder(10, 20, 30, 1))}) {
    const Verification inherited = f.inherited();
    EXPECT_TRUE(inherited.valid);
    expect_same_verdict(f.whole(), inherited);
    EXPECT_GT(inherited.tets_inherited, 0.3 * static_cast<double>(f.child.tets.size()));
    EXPECT_GT(inherited.tets_proved, 0U);
    EXPECT_EQ(inherited.tets_proved + inherited.tets_inherited, f.child.tets.size());
    EXPECT_EQ(f.whole().tets_inherited, 0U);
  }
}

TEST(TetCorrespondence, FindsWhatIsBrokenAmongChangedTetsOnTheRimAndAwayFromBoth) {
  using Break = std::function<void(Family&, std::size_t)>;
  const std::map<std::string, Break> breaks{
      {"gone", [](Family& f, std::size_t t) { f.erase(t); }},
      {"twice", [](Family& f, std::size_t t) { f.child.tets.push_back(f.child.tets[t]); }},
      {"turned",
       [](Family& f, std::size_t t) { std::swap(f.child.tets[t][1], f.child.tets[t][2]); }},
      {"inverted by a node",
       [](Family& f, std::size_t t) {
         const Tet tet = f.child.tets[t];
         const auto& p = f.child.nodes;
         const auto inner = std::find_if(tet.begin(), tet.end(), [&](std::int32_t n) {
           return f.supports[n].kind == Support::Kind::Interior;
         });
         Vec3 c;
         for (const std::int32_t n : tet)
           if (n != *inner) c += p[n] / 3.0;
         f.child.nodes[*inner] = c + 0.5 * (c - p[*inner]);
       }},
      {"another node", [](Family& f, std::size_t t) {
         Tet& tet = f.child.tets[t];
         for (std::int32_t n = 0;; ++n)
           if (std::find(tet.begin(), tet.end(), n) == tet.end()) {
             tet[3] = n;
             return;
           }
       }}};
  for (const auto& [name, apply] : breaks)
    for (const char* where : {"changed", "rim", "kept"}) {
      SCOPED_TRACE(name + (" " + std::string(where)));
      Family f = box();
      const std::string at = where;
      apply(f, at == "rim" ? f.rim() : f.inner(at == "changed"));
      f.claim();
      const Verification inherited = f.inherited();
      EXPECT_FALSE(inherited.valid);
      expect_same_verdict(f.whole(), inherited);
    }
}

TEST(TetCorrespondence, ManyBreaksAtOnceAreCountedAlike) {
  Random random(5);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    Family f = box();
    for (int k = 0; k <= round % 4; ++k) {
      const auto t = static_cast<std::size_t>(
          random.uniform(0, static_cast<double>(f.child.tets.size()) - 0.5));
      const auto n = static_cast<std::int32_t>(
          random.uniform(0, static_cast<double>(f.child.nodes.size()) - 0.5));
      switch ((round + k) % 4) {
        case 0:
          f.erase(t);
          break;
        case 1:
          f.child.tets.push_back(f.child.tets[t]);
          break;
        case 2:
          f.child.tets[t][round % 4] = n;
          break;
        default:
          f.child.nodes[n] += 0.3 * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 0.1};
      }
    }
    f.claim();
    expect_same_verdict(f.whole(), f.inherited());
  }
}

TEST(TetCorrespondence, WhatHasNotChangedNeedsNoClaim) {
  Family f = box();
  std::ranges::fill(f.tet, -1);
  std::ranges::fill(f.node, -1);
  const Verification unclaimed = f.inherited();
  EXPECT_TRUE(unclaimed.valid);
  EXPECT_GT(unclaimed.tets_inherited, 0U);
  expect_same_verdict(f.whole(), unclaimed);
}

TEST(TetCorrespondence, AFalseClaimIsNotBelieved) {
  Family f = box();
  const std::uint32_t unchanged = f.inherited().tets_inherited;
  std::ranges::reverse(f.child.tets);  // under other numbers, so that claims tell
  f.claim();
  const std::uint32_t proved = f.inherited().tets_proved;
  EXPECT_EQ(f.inherited().tets_inherited, unchanged);
  std::rotate(f.tet.begin(), f.tet.begin() + 1, f.tet.end());
  const Verification shifted = f.inherited();
  EXPECT_TRUE(shifted.valid);
  EXPECT_EQ(shifted.tets_proved, f.child.tets.size());
  expect_same_verdict(f.whole(), shifted);

  f.claim();
  const auto kept = static_cast<std::size_t>(
      std::find_if(f.tet.begin(), f.tet.end(), [](std::int32_t t) { return t >= 0; }) -
      f.tet.begin());
  for (const std::int32_t wrong : {-7, 1 << 30, f.tet[kept + 1]}) {
    f.claim();
    f.tet[kept] = wrong;
    EXPECT_GT(f.inherited().tets_proved, proved);
    expect_same_verdict(f.whole(), f.inherited());
  }
}

TEST(TetCorrespondence, OneNodeOfTheParentHasOneHeir) {
  // A copy of a node takes its place in half of its tets: they seem to be the parent's still, and
  // the mesh is torn.
  Family f = box();
  const std::int32_t n = f.child.tets[f.inner(false)][0];
  const auto copy = static_cast<std::int32_t>(f.child.nodes.size());
  f.child.nodes.push_back(f.child.nodes[n]);
  f.supports.emplace_back();
  bool other = false;
  for (Tet& t : f.child.tets)
    for (std::int32_t& m : t)
      if (m == n && (other = !other)) m = copy;
  f.node.push_back(n);
  const Verification inherited = f.inherited();
  EXPECT_FALSE(inherited.valid);
  expect_same_verdict(f.whole(), inherited);
}

TEST(TetCorrespondence, ANodeThatMovedHasItsTetsProvedAndTheirFacetsInherited) {
  Family f = box();
  const std::int32_t n = f.child.tets[f.inner(false)][0];
  const Verification before = f.inherited();
  f.child.nodes[n].x += 1e-3;
  const Verification after = f.inherited();
  EXPECT_TRUE(after.valid);
  EXPECT_GT(after.tets_proved, before.tets_proved);
  expect_same_verdict(f.whole(), after);
}

TEST(TetCorrespondence, FindsANodeThatNoTetIsLeftAt) {
  Family f = box();
  const std::int32_t n = f.child.tets[f.inner(false)][0];
  std::erase_if(f.child.tets,
                [&](const Tet& t) { return std::find(t.begin(), t.end(), n) != t.end(); });
  f.claim();
  const Verification inherited = f.inherited();
  EXPECT_EQ(inherited.count(MeshFailure::OrphanNode), 1U);
  expect_same_verdict(f.whole(), inherited);
}

}  // namespace
}  // namespace remeshd

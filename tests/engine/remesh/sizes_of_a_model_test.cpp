// First meshes and edits of models that ask for edge lengths at places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// The model's sizes hold, and no rule does.
MeshOptions sized() {
  MeshOptions options{.size = 4};
  options.sizing = {.even = false, .edges_per_circle = 0, .layers = 0};
  return options;
}

ModelSource plate_with_sizes(std::vector<SizeControlSource> sizes) {
  ModelSource source =
      test::model_of({test::block("plate", 40, 40, 8),
                      test::placed(test::cylinder("hole", 4, 10), -8, 0, -1, Nature::Subtractive)});
  source.sizes = std::move(sizes);
  return source;
}

/// Facets of the mesh that lie on a face of a feature.
std::ptrdiff_t facets_on(const Revision& r, const std::string& face) {
  const MeshGroups& groups = r.output.groups;
  return std::ranges::count_if(groups.facets, [&](const MeshFacet& f) {
    const auto& names = groups.facet_groups[f.group];
    return std::ranges::find(names, face) != names.end();
  });
}

TEST(SizesOfAModel, MakeItsMeshFinerThere) {
  const Revision plain = make_revision(Revision::none(), plate_with_sizes({}), sized(), kRun);
  const Revision fine = make_revision(
      Revision::none(), plate_with_sizes({{"rim", "hole.wall", "radius/4"}}), sized(), kRun);
  EXPECT_GE(facets_on(fine, "hole.wall"), 6 * facets_on(plain, "hole.wall"));
  EXPECT_LE(facets_on(fine, "plate.x_max"), 2 * facets_on(plain, "plate.x_max"));
}

/// Edges of the plate's top whose facets are near a place.
struct TopEdges {
  double mean = 0, longest = 0;
};

TopEdges top_edges_near(const Revision& r, double x, double y) {
  TopEdges edges;
  int count = 0;
  const auto& nodes = r.output.mesh.nodes;
  for (const MeshFacet& f : r.output.groups.facets) {
    const Vec3 c = (nodes[f.nodes[0]] + nodes[f.nodes[1]] + nodes[f.nodes[2]]) / 3;
    if (c.z < 8 - 1e-6 || std::hypot(c.x - x, c.y - y) > 4) continue;
    for (int k = 0; k < 3; ++k, ++count) {
      const double length = distance(nodes[f.nodes[k]], nodes[f.nodes[(k + 1) % 3]]);
      edges.mean += length;
      edges.longest = std::fmax(edges.longest, length);
    }
  }
  edges.mean /= count;
  return edges;
}

TEST(SizesOfAModel, UnderAConditionHoldWhereItDoes) {
  const Revision fine = make_revision(
      Revision::none(), plate_with_sizes({{"corner", "plate.top & x > 10 && y > dy/4", 1.0}}),
      sized(), kRun);
  EXPECT_LT(top_edges_near(fine, 15, 15).longest, 2);
  EXPECT_GT(top_edges_near(fine, 15, -15).longest, 3);
}

TEST(SizesOfAModel, ComeOutWhateverShareOfTheBaseSizeTheyAre) {
  // The cubes that the nodes start from are halved from the base size down.
  for (const double size : {0.8, 0.9, 1.0, 1.1, 1.2}) {
    const Revision fine = make_revision(
        Revision::none(), plate_with_sizes({{"corner", "plate.top & x > 10 && y > 10", size}}),
        sized(), kRun);
    const TopEdges edges = top_edges_near(fine, 15, 15);
    EXPECT_NEAR(edges.mean, size, 0.08 * size) << size;
    EXPECT_LT(edges.longest, 2 * size) << size;
  }
}

TEST(SizesOfAModel, OnAFeatureHoldInItsMaterialToo) {
  ModelSource source = test::model_of(
      {test::block("body", 40, 40, 40), test::placed(test::block("core", 16, 16, 16), 0, 0, 12)});
  source.sizes = {{"core", "core", 1.6}};
  const Revision r = make_revision(Revision::none(), source, sized(), kRun);
  // Nothing of the core is boundary, and it has as many nodes as a lattice of that length.
  const auto within = [](const Vec3& p) {
    return std::fabs(p.x) < 8 && std::fabs(p.y) < 8 && std::fabs(p.z - 20) < 8;
  };
  EXPECT_GT(std::ranges::count_if(r.output.mesh.nodes, within), 700);
}

TEST(SizesOfAModel, WhoseConditionHoldsNowhereAreAnErrorOfAFirstMesh) {
  const ErrorInfo info = test::error_of([] {
    make_revision(Revision::none(), plate_with_sizes({{"rim", "hole.wall & z > 50", 1.0}}), sized(),
                  kRun);
  });
  EXPECT_EQ(test::place_of(info), "SELECTOR_EMPTY - sizes.rim.on");
}

TEST(SizesOfAModel, DoNotHoldInAnEvenMesh) {
  const MeshOptions even{.size = 4};
  const Revision plain = make_revision(Revision::none(), plate_with_sizes({}), even, kRun);
  const Revision asked = make_revision(
      Revision::none(), plate_with_sizes({{"rim", "hole.wall", "radius/4"}}), even, kRun);
  EXPECT_EQ(asked.output.mesh.nodes, plain.output.mesh.nodes);
}

TEST(SizesOfAModel, ThatSelectNothingAreAnErrorOfAFirstMesh) {
  const ErrorInfo info = test::error_of([] {
    make_revision(Revision::none(), plate_with_sizes({{"rim", "bore*.wall", 1.0}}), sized(), kRun);
  });
  EXPECT_EQ(test::place_of(info), "SELECTOR_EMPTY - sizes.rim.on");
}

TEST(SizesOfAModel, ThatSelectNothingAnyMoreAreAWarningOfAnEdit) {
  const ModelSource source = plate_with_sizes({{"rim", "hole.wall", "radius/4"}});
  const Revision base = make_revision(Revision::none(), source, sized(), kRun);
  MeshOptions inherited = sized();
  inherited.size.reset();
  const Revision r = make_revision(base, apply(source, {{RemoveFeature{"hole"}}}), inherited, kRun);
  EXPECT_TRUE(std::ranges::any_of(r.report.warnings, [](const Warning& w) {
    return w.code == WarningCode::GroupEmptied && w.groups == std::vector<std::string>{"rim"};
  }));
}

}  // namespace
}  // namespace remeshd

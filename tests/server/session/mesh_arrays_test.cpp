#include "server/session/mesh_arrays.h"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

#include "proto/checksum.h"

namespace remeshd {
namespace {

OutputMesh output(std::size_t nodes, std::int32_t facets) {
  OutputMesh d;
  for (std::size_t n = 0; n < nodes; ++n) d.mesh.nodes.push_back({double(n), 0.5, -1});
  for (std::int32_t f = 0; f < facets; ++f)
    d.groups.facets.push_back({{f, f + 1, f + 2}, 10 * f, f % 2});
  d.groups.facet_groups = {{"hole.wall", "plate.top"}, {"plate.side1"}};
  return d;
}

MeshArray array_named(const std::vector<MeshArray>& arrays, ArrayName name) {
  for (const MeshArray& array : arrays)
    if (array.name == name) return array;
  ADD_FAILURE() << "no such array";
  return {};
}

std::string whole(const MeshArray& array) {
  std::string out;
  array.read(0, array.bytes, out);
  return out;
}

struct Digested {
  explicit Digested(const OutputMesh& d) : arrays(mesh_arrays(d)) {}
  std::vector<MeshArray> arrays;
  MeshDigests digests;
};

TEST(MeshArrays, ComeInTheOrderOfTheirNamesWithTypeRowsAndBytes) {
  const OutputMesh d = output(1000, 7);
  const auto arrays = mesh_arrays(d);
  ASSERT_EQ(arrays.size(), 16U);
  for (std::size_t i = 0; i < arrays.size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(arrays[i].name), i + 1);
  const MeshArray nodes = array_named(arrays, ArrayName::Nodes);
  EXPECT_EQ(nodes.type, NumberType::F64);
  EXPECT_EQ(nodes.components, 3U);
  EXPECT_EQ(nodes.count, 1000U);
  EXPECT_EQ(nodes.bytes, 24000U);
  const MeshArray facets = array_named(arrays, ArrayName::Facets);
  EXPECT_EQ(facets.type, NumberType::I32);
  EXPECT_EQ(facets.components, 3U);
  EXPECT_EQ(facets.count, 7U);
  EXPECT_EQ(array_named(arrays, ArrayName::FacetTets).components, 1U);
  EXPECT_EQ(array_named(arrays, ArrayName::Transforms).components, 12U);
  EXPECT_EQ(array_named(arrays, ArrayName::NodeOrigins).type, NumberType::U8);
  const MeshArray groups = array_named(arrays, ArrayName::FacetGroups);
  EXPECT_EQ(groups.type, NumberType::Text);
  EXPECT_EQ(groups.count, 2U);
  EXPECT_EQ(whole(groups), "hole.wall plate.top\nplate.side1\n");
}

TEST(MeshArrays, HaveTheSizesOfAMeshThatIsNotEven) {
  OutputMesh d = output(10, 2);
  for (int n = 0; n < 10; ++n) d.node_sizes.push_back(0.5 + n);
  const auto arrays = mesh_arrays(d);
  ASSERT_EQ(arrays.size(), 17U);
  EXPECT_EQ(arrays.back().name, ArrayName::NodeSizes);
  EXPECT_EQ(arrays.back().type, NumberType::F64);
  EXPECT_EQ(arrays.back().count, 10U);
  EXPECT_EQ(arrays.back().bytes, 80U);
}

TEST(MeshArrays, AreReadInPiecesOfAnySizeAsAtOnce) {
  const OutputMesh d = output(2000, 500);
  for (const MeshArray& array : mesh_arrays(d)) {
    const std::string all = whole(array);
    ASSERT_EQ(all.size(), array.bytes);
    for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, std::size_t{4097}}) {
      std::string joined;
      while (joined.size() < all.size())
        array.read(joined.size(), std::min(piece, all.size() - joined.size()), joined);
      EXPECT_TRUE(joined == all);
    }
  }
}

TEST(MeshArrays, OfFacetsHoldNodesTetsAndGroupsApart) {
  const OutputMesh d = output(10, 2);
  const auto numbers = [&](ArrayName name) {
    const std::string bytes = whole(array_named(mesh_arrays(d), name));
    std::vector<std::int32_t> out(bytes.size() / 4);
    std::copy_n(bytes.data(), bytes.size(), reinterpret_cast<char*>(out.data()));
    return out;
  };
  EXPECT_EQ(numbers(ArrayName::Facets), (std::vector<std::int32_t>{0, 1, 2, 1, 2, 3}));
  EXPECT_EQ(numbers(ArrayName::FacetTets), (std::vector<std::int32_t>{0, 10}));
  EXPECT_EQ(numbers(ArrayName::FacetGroup), (std::vector<std::int32_t>{0, 1}));
}

TEST(MeshDigests, AreOverTheDigestsOfBlocksOf16Kibibytes) {
  // 24,000 bytes of nodes are two blocks.
  const OutputMesh d = output(1000, 0);
  const auto arrays = mesh_arrays(d);
  const std::string nodes = whole(arrays.front());
  std::string digests;
  for (const std::string& block : {nodes.substr(0, 16384), nodes.substr(16384)}) {
    Sha256 sum;
    sum.update(block);
    digests += sum.finish();
  }
  EXPECT_EQ(digest_of(arrays.front()).whole, sha256_hex(digests));
  EXPECT_EQ(digest_of(array_named(arrays, ArrayName::Tets)).whole, sha256_hex("")) << "no block";
}

TEST(MeshDigests, TakeOverThoseOfTheSameBlocksOfAnotherMesh) {
  const OutputMesh base = output(5000, 3000);
  const Digested other(base);
  const auto changed = [&](auto&& change) {
    OutputMesh d = base;
    change(d);
    return d;
  };
  const std::vector<OutputMesh> meshes{
      base,
      changed([](OutputMesh& d) { d.mesh.nodes.edit(3000).x = 7; }),
      changed([](OutputMesh& d) {
        d.mesh.nodes.push_back({1, 2, 3});
      }),
      changed([](OutputMesh& d) { d.groups.facets.resize(1500); }),
      changed([](OutputMesh& d) { d.groups.facets.clear(); }),
      output(100, 1),
      output(9000, 4000),
  };
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const Digested own(meshes[m]);
    for (std::size_t i = 0; i < own.arrays.size(); ++i) {
      EXPECT_EQ(own.digests.of(own.arrays[i], other.arrays[i], other.digests),
                digest_of(own.arrays[i]).whole)
          << "mesh " << m << ", array " << i;
    }
  }
}

TEST(MeshDigests, ReadWhatIsSharedWithAnotherMeshNotAtAll) {
  const OutputMesh base = output(5000, 0);
  OutputMesh next = base;
  next.mesh.nodes.edit(0).x = 7;
  const MeshArray nodes = mesh_arrays(next).front(), others = mesh_arrays(base).front();
  ArrayDigest of_others = digest_of(others);
  // Were they worked out, these blocks would have other digests.
  of_others.blocks.replace(32, 32, 32, 'x');
  const ArrayDigest digest = digest_of(nodes, &others, &of_others);
  EXPECT_EQ(digest.blocks.substr(0, 32), digest_of(nodes).blocks.substr(0, 32));
  EXPECT_EQ(digest.blocks.substr(32, 32), std::string(32, 'x'));
}

TEST(MeshDigests, AreWorkedOutOnceForManyThreads) {
  const OutputMesh d = output(10, 0);
  std::atomic<int> reads = 0;
  MeshArray counted = mesh_arrays(d).front();
  counted.from = [&, from = counted.from](std::uint64_t at) {
    ++reads;
    return from(at);
  };
  const MeshDigests digests;
  const std::string wanted = digest_of(mesh_arrays(d).front()).whole;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) threads.emplace_back([&] { EXPECT_EQ(digests.of(counted), wanted); });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(reads, 1);
}

}  // namespace
}  // namespace remeshd

#include "server/session/mesh_arrays.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "engine/mesh/tet_mesh.h"
#include "proto/checksum.h"

namespace remeshd {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are sent as they lie in memory");
static_assert(sizeof(Vec3) == 24 && sizeof(Tet) == 16 && sizeof(Triangle) == 12 &&
              sizeof(Transform) == 96 && sizeof(NodeOrigin) == 1);

constexpr std::size_t kBlock = 16384;
constexpr std::size_t kDigest = 32;  // bytes of one block's

template <typename Row>
MeshArray empty_array(ArrayName name, NumberType type, std::size_t rows) {
  constexpr std::array<std::size_t, 5> kSizes{8, 4, 8, 1, 1};
  return {.name = name,
          .type = type,
          .components =
              static_cast<std::uint32_t>(sizeof(Row) / kSizes[static_cast<std::size_t>(type) - 1]),
          .count = static_cast<std::uint32_t>(rows),
          .bytes = rows * sizeof(Row),
          .from = {}};
}

template <typename Row>
std::string_view bytes_of(std::span<const Row> rows) {
  return {reinterpret_cast<const char*>(rows.data()), rows.size_bytes()};
}

template <typename Row>
MeshArray array_of(ArrayName name, NumberType type, const CowVector<Row>& rows) {
  MeshArray array = empty_array<Row>(name, type, rows.size());
  array.from = [&rows](std::uint64_t offset) {
    constexpr std::size_t kPage = CowVector<Row>::page_bytes();
    return bytes_of(rows.page(offset / kPage)).substr(offset % kPage);
  };
  return array;
}

/// An array of what `member` takes out of each struct, put together when it is first read.
template <typename Struct, typename Member>
MeshArray array_of(ArrayName name, const std::vector<Struct>& structs, Member member) {
  using Row = std::decay_t<decltype(member(structs.front()))>;
  MeshArray array = empty_array<Row>(name, NumberType::I32, structs.size());
  const auto together = [&structs, member] {
    std::vector<Row> rows(structs.size());
    std::ranges::transform(structs, rows.begin(), member);
    return rows;
  };
  array.from = [rows = std::make_shared<Lazy<std::vector<Row>>>(), together](std::uint64_t offset) {
    return bytes_of(std::span<const Row>(rows->get(together))).substr(offset);
  };
  return array;
}

MeshArray array_of(ArrayName name, const std::vector<Transform>& transforms) {
  MeshArray array = empty_array<Transform>(name, NumberType::F64, transforms.size());
  array.from = [&transforms](std::uint64_t offset) {
    return bytes_of(std::span<const Transform>(transforms)).substr(offset);
  };
  return array;
}

MeshArray text_array(ArrayName name, std::size_t rows, std::string lines) {
  MeshArray array = empty_array<char>(name, NumberType::Text, rows);
  array.bytes = lines.size();
  array.from = [text = std::make_shared<const std::string>(std::move(lines))](
                   std::uint64_t offset) { return std::string_view(*text).substr(offset); };
  return array;
}

std::string lines(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (const auto& names : rows) {
    for (std::size_t i = 0; i < names.size(); ++i) text += (i > 0 ? " " : "") + names[i];
    text += '\n';
  }
  return text;
}

std::string lines(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += name + '\n';
  return text;
}

/// An array of pairs: the index of a group of the model, and a member of the group.
MeshArray members_of(ArrayName name, const std::vector<GroupMembers>& groups,
                     std::vector<std::int32_t> GroupMembers::*which) {
  using Row = std::array<std::int32_t, 2>;
  std::size_t count = 0;
  for (const GroupMembers& group : groups) count += (group.*which).size();
  MeshArray array = empty_array<Row>(name, NumberType::I32, count);
  const auto together = [&groups, which] {
    std::vector<Row> rows;
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const std::int32_t member : groups[g].*which)
        rows.push_back({static_cast<std::int32_t>(g), member});
    return rows;
  };
  array.from = [rows = std::make_shared<Lazy<std::vector<Row>>>(), together](std::uint64_t offset) {
    return bytes_of(std::span<const Row>(rows->get(together))).substr(offset);
  };
  return array;
}

void add_groups(const std::vector<GroupMembers>& groups, std::vector<MeshArray>& arrays) {
  std::string names;
  for (const GroupMembers& group : groups) names += group.name + "\n";
  arrays.push_back(text_array(ArrayName::GroupNames, groups.size(), std::move(names)));
  arrays.push_back(members_of(ArrayName::GroupFacets, groups, &GroupMembers::facets));
  arrays.push_back(members_of(ArrayName::GroupTets, groups, &GroupMembers::tets));
}

// Mid-nodes of a facet, of its edges 01, 12 and 20.
std::array<std::int32_t, 3> mids_of(const MeshFacet& facet, const OutputMesh& d) {
  const Tet& tet = d.mesh.tets[facet.tet];
  const auto& mids = d.mids.of_tets[facet.tet];
  std::array<std::int32_t, 3> out{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t e = 0; e < kTetEdges.size(); ++e) {
      const std::int32_t a = tet[kTetEdges[e][0]], b = tet[kTetEdges[e][1]];
      const std::int32_t from = facet.nodes[k], to = facet.nodes[(k + 1) % 3];
      if ((a == from && b == to) || (a == to && b == from)) out[k] = mids[e];
    }
  return out;
}

void add_mids(const OutputMesh& d, std::vector<MeshArray>& arrays) {
  using enum ArrayName;
  using enum NumberType;
  const auto& m = d.mids;
  for (MeshArray array :
       {array_of(ArrayName::MidNodes, F64, m.positions), array_of(EdgeMids, I32, m.edges),
        array_of(TetMids, I32, m.of_tets),
        array_of(FacetMids, d.groups.facets, [&d](const MeshFacet& f) { return mids_of(f, d); }),
        array_of(MidNodeIds, U64, m.ids), array_of(MidNodeOrigins, U8, m.origin),
        array_of(OriginalMidNodes, I32, m.original), array_of(MidNodeTransforms, I32, m.transform)})
    arrays.push_back(std::move(array));
}

}  // namespace

std::vector<MeshArray> mesh_arrays(const OutputMesh& d) {
  using enum ArrayName;
  using enum NumberType;
  const MeshGroups& g = d.groups;
  const NodeMap& m = d.map;
  std::vector<MeshArray> arrays{
      array_of(Nodes, F64, d.mesh.nodes),
      array_of(Tets, I32, d.mesh.tets),
      array_of(NodeIds, U64, d.node_ids),
      array_of(TetIds, U64, d.tet_ids),
      array_of(Facets, g.facets, [](const MeshFacet& f) { return f.nodes; }),
      array_of(FacetTets, g.facets, [](const MeshFacet& f) { return f.tet; }),
      array_of(FacetGroup, g.facets, [](const MeshFacet& f) { return f.group; }),
      text_array(FacetGroups, g.facet_groups.size(), lines(g.facet_groups)),
      array_of(TetCells, I32, g.tet_cell),
      text_array(CellOwners, g.cell_owners.size(), lines(g.cell_owners)),
      array_of(NodeOrigins, U8, m.node_origin),
      array_of(OriginalNodes, I32, m.original_node),
      array_of(NodeTransforms, I32, m.node_transform),
      array_of(Transforms, m.transforms),
      text_array(TransformFeatures, m.transform_features.size(), lines(m.transform_features)),
      array_of(OriginalTets, I32, m.original_tet)};
  if (!g.of_model.empty()) add_groups(g.of_model, arrays);
  if (!d.node_sizes.empty()) arrays.push_back(array_of(NodeSizes, F64, d.node_sizes));
  if (!d.mids.positions.empty()) add_mids(d, arrays);
  return arrays;
}

namespace {

/// Whether two arrays have the same `size` bytes from `offset` on. Pre: both have as many.
bool are_same(const MeshArray& a, const MeshArray& b, std::uint64_t offset, std::uint64_t size) {
  while (size > 0) {
    std::string_view of_a = a.from(offset), of_b = b.from(offset);
    const std::uint64_t common = std::min<std::uint64_t>({size, of_a.size(), of_b.size()});
    of_a = of_a.substr(0, common);
    of_b = of_b.substr(0, common);
    if (of_a.data() != of_b.data() && of_a != of_b) return false;  // most pages are shared
    offset += common;
    size -= common;
  }
  return true;
}

std::string block_digest(const MeshArray& array, std::uint64_t offset, std::uint64_t size) {
  Sha256 sum;
  array.pieces(offset, size, [&](std::string_view piece) { sum.update(piece); });
  return sum.finish();
}

}  // namespace

ArrayDigest digest_of(const MeshArray& array, const MeshArray* alike, const ArrayDigest* of_alike) {
  ArrayDigest digest;
  for (std::uint64_t at = 0; at < array.bytes; at += kBlock) {
    const std::uint64_t size = std::min<std::uint64_t>(kBlock, array.bytes - at);
    const bool same = alike != nullptr && at < alike->bytes &&
                      size == std::min<std::uint64_t>(kBlock, alike->bytes - at) &&
                      are_same(array, *alike, at, size);
    digest.blocks += same ? of_alike->blocks.substr(at / kBlock * kDigest, kDigest)
                          : block_digest(array, at, size);
  }
  digest.whole = sha256_hex(digest.blocks);
  return digest;
}

}  // namespace remeshd

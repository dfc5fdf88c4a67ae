#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/remesh/remesh.h"
#include "server/session/lazy.h"

namespace remeshd {

/// Arrays of a mesh, with the numbers that they have in MeshArray in proto/remesh/v1/mesh.proto,
/// which tells what each holds.
enum class ArrayName : std::uint8_t {
  Nodes = 1,
  Tets,
  NodeIds,
  TetIds,
  Facets,
  FacetTets,
  FacetGroup,
  FacetGroups,
  TetCells,
  CellOwners,
  NodeOrigins,
  OriginalNodes,
  NodeTransforms,
  Transforms,
  TransformFeatures,
  OriginalTets,
  GroupNames,
  GroupFacets,
  GroupTets,
  NodeSizes,
  MidNodes,
  EdgeMids,
  TetMids,
  FacetMids,
  MidNodeIds,
  MidNodeOrigins,
  OriginalMidNodes,
  MidNodeTransforms,
};
inline constexpr std::size_t kLastArrayName = 28;

/// The type of an array's numbers, with the values of the protocol's ArrayType.
enum class NumberType : std::uint8_t { F64 = 1, I32, U64, U8, Text };

/// An array as it is sent, little-endian and without gaps, taken from the memory of a revision.
struct MeshArray {
  ArrayName name;
  NumberType type;
  std::uint32_t components;  ///< numbers a row; 1 for text
  std::uint32_t count;       ///< rows
  std::uint64_t bytes;
  /// The bytes from `offset` on that lie together in memory, one at least. They are valid as long
  /// as the delivery and this array or a copy of it. Pre: the array has a byte there.
  std::function<std::string_view(std::uint64_t offset)> from;

  /// Hands `size` bytes from `offset` on to `take`, piece by piece. Pre: the array has them.
  template <typename Take>
  void pieces(std::uint64_t offset, std::uint64_t size, Take take) const {
    while (size > 0) {
      const std::string_view piece = from(offset).substr(0, size);
      take(piece);
      offset += piece.size();
      size -= piece.size();
    }
  }
  /// Appends them to `out`.
  void read(std::uint64_t offset, std::uint64_t size, std::string& out) const {
    pieces(offset, size, [&](std::string_view piece) { out += piece; });
  }
};

/// The arrays of a mesh, in the order of their names: all, but for groups where the model has none,
/// the sizes of an even mesh and the mid-nodes of a mesh of first order.
/// The delivery must outlive them.
std::vector<MeshArray> mesh_arrays(const OutputMesh& delivery);

struct ArrayDigest {
  std::string whole;   ///< 64 hexadecimal digits: SHA-256 over `blocks`
  std::string blocks;  ///< SHA-256s of the array's blocks of 16 KiB, 32 bytes each
};

/// The digest of an array. Takes 0.6 ms a megabyte, several times that on processors without
/// instructions for it, and a tenth for blocks that are the same as in `alike`, another array, with
/// its digest; null for none.
ArrayDigest digest_of(const MeshArray& array, const MeshArray* alike = nullptr,
                      const ArrayDigest* of_alike = nullptr);

/// The digests of one mesh, each worked out when it is first asked for.
class MeshDigests {
 public:
  const std::string& of(const MeshArray& array) const {
    return digest(array, [&] { return digest_of(array); }).whole;
  }
  /// The same, worked out from that of an array of the same name of another mesh, whose digests
  /// `others` are.
  const std::string& of(const MeshArray& array, const MeshArray& alike,
                        const MeshDigests& others) const {
    return digest(array,
                  [&] {
                    const ArrayDigest& other =
                        others.digest(alike, [&] { return digest_of(alike); });
                    return digest_of(array, &alike, &other);
                  })
        .whole;
  }

 private:
  template <typename Make>
  const ArrayDigest& digest(const MeshArray& array, Make&& make) const {
    return digests_[static_cast<std::size_t>(array.name) - 1].get(make);
  }

  std::array<Lazy<ArrayDigest>, kLastArrayName> digests_;
};

}  // namespace remeshd

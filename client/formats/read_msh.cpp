// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <optional>
#include <unordered_map>

#include "client/formats/element_types.h"
#include "client/formats/read_mesh.h"
#include "client/formats/scanner.h"

namespace remeshd::client {
namespace {

/// Reads the numbers of a section, which is text or binary.
class Values {
 public:
  Values(Scanner& scanner, bool binary) : scanner_(scanner), binary_(binary) {}
  int integer() { return binary_ ? scanner_.raw<std::int32_t>() : scanner_.number<int>(); }
  std::uint64_t size() {
    return binary_ ? scanner_.raw<std::uint64_t>() : scanner_.number<std::uint64_t>();
  }
  double real() { return binary_ ? scanner_.raw<double>() : scanner_.number<double>(); }
  /// Throws unless so many values of at least `bytes` bytes can follow.
  void expect(std::uint64_t count, std::size_t bytes) const {
    if (count > scanner_.left() / bytes) throw FileError("it ends too soon");
  }
  [[nodiscard]] std::size_t least_bytes() const { return binary_ ? 8 : 2; }

 private:
  Scanner& scanner_;
  bool binary_;
};

/// Index of each node by its tag in the file.
using NodesByTag = std::unordered_map<std::uint64_t, std::int32_t>;

void read_nodes(Values values, FileMesh& mesh, NodesByTag& places) {
  const std::uint64_t blocks = values.size();
  for (int skipped = 0; skipped < 3; ++skipped) values.size();  // count, first and last tag
  std::vector<std::uint64_t> tags;
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const int dimension = values.integer();
    values.integer();  // entity
    const int parametric = values.integer();
    const std::uint64_t count = values.size();
    values.expect(count, 4 * values.least_bytes());
    tags.resize(count);
    for (auto& tag : tags) tag = values.size();
    for (const std::uint64_t tag : tags) {
      places[tag] = static_cast<std::int32_t>(mesh.nodes.size());
      for (double& coordinate : mesh.nodes.emplace_back()) coordinate = values.real();
      for (int k = 0; parametric != 0 && k < dimension; ++k) values.real();
    }
  }
}

/// Nodes of an element of each Gmsh type that a mesh of tets may come with, 0 for others.
int nodes_of(int type) {
  switch (type) {
    case 15:
      return 1;
    case 1:
      return 2;
    case 2:
    case 8:
      return 3;
    case 3:
    case 4:
      return 4;
    case 5:
      return 8;
    case 6:
    case 9:
      return 6;
    case 7:
      return 5;
    case 11:
      return 10;
    default:
      return 0;
  }
}

void read_elements(Values values, FileMesh& mesh, const NodesByTag& places) {
  const std::uint64_t blocks = values.size();
  for (int skipped = 0; skipped < 3; ++skipped) values.size();
  for (std::uint64_t block = 0; block < blocks; ++block) {
    values.integer();  // dimension
    values.integer();  // entity
    const int type = values.integer();
    const int nodes = nodes_of(type);
    const bool is_tet = type == kGmshTetrahedron || type == kGmshTetrahedron10;
    if (nodes == 0) throw FileError("elements of type " + std::to_string(type) + " are unknown");
    const std::uint64_t count = values.size();
    values.expect(count, static_cast<std::size_t>(nodes + 1) * values.least_bytes());
    for (std::uint64_t element = 0; element < count; ++element) {
      values.size();  // tag
      std::array<std::int32_t, 4> tet{};
      for (int k = 0; k < nodes; ++k) {
        const std::uint64_t tag = values.size();
        if (!is_tet || k >= 4) continue;
        const auto place = places.find(tag);
        if (place == places.end()) throw FileError("a tet refers to a node that is not there");
        tet[static_cast<std::size_t>(k)] = place->second;
      }
      if (is_tet) mesh.tets.push_back(tet);
    }
  }
}

bool read_format(Scanner& scanner) {
  const std::string_view version = scanner.word();
  if (version != "4.1") throw FileError("MSH version " + std::string(version) + ", not 4.1");
  const int binary = scanner.number<int>();
  const int size = scanner.number<int>();
  scanner.line();
  if (binary != 0 && (size != 8 || scanner.raw<std::int32_t>() != 1))
    throw FileError("binary data of another byte order or word size");
  return binary != 0;
}

}  // namespace

FileMesh parse_msh(std::string_view bytes) {
  Scanner scanner(bytes);
  FileMesh mesh;
  NodesByTag places;
  std::optional<bool> binary;
  const auto values = [&] {
    if (!binary) throw FileError("$MeshFormat is missing");
    return Values(scanner, *binary);
  };
  while (scanner.skip_blanks()) {
    const std::string_view section = scanner.line();
    if (!section.starts_with('$')) throw FileError("it is not a Gmsh file");
    if (section == "$MeshFormat")
      binary = read_format(scanner);
    else if (section == "$Nodes")
      read_nodes(values(), mesh, places);
    else if (section == "$Elements")
      read_elements(values(), mesh, places);
    const std::string end = "$End" + std::string(section.substr(1));
    if (!scanner.skip_past_line(end)) throw FileError(end + " is missing");
  }
  return mesh;
}

}  // namespace remeshd::client

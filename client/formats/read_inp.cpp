// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <map>

#include "client/formats/read_mesh.h"
#include "client/formats/scanner.h"

namespace remeshd::client {
namespace {

std::string folded(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\t')
      out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

std::vector<std::string_view> fields(std::string_view line) {
  std::vector<std::string_view> out;
  while (true) {
    const std::size_t comma = line.find(',');
    out.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return out;
    line.remove_prefix(comma + 1);
  }
}

enum class Block { Nodes, Tets, Other };

/// What the data lines below a keyword line are.
Block block_of(const std::string& keyword) {
  if (keyword == "*NODE" || keyword.starts_with("*NODE,")) return Block::Nodes;
  if (!keyword.starts_with("*ELEMENT,")) return Block::Other;
  return keyword.find("TYPE=C3D4,") != std::string::npos || keyword.ends_with("TYPE=C3D4")
             ? Block::Tets
             : Block::Other;
}

}  // namespace

FileMesh parse_inp(std::string_view bytes) {
  FileMesh mesh;
  std::map<std::int64_t, std::int32_t> place;  // of each node number
  Block block = Block::Other;
  Scanner scanner(bytes);
  while (!scanner.at_end()) {
    const std::string_view line = scanner.line();
    if (line.starts_with("**") || line.find_first_not_of(" \t") == std::string_view::npos) continue;
    if (line.starts_with('*')) {
      block = block_of(folded(line));
      continue;
    }
    if (block == Block::Other) continue;
    const auto parts = fields(line);
    const std::size_t wanted = block == Block::Nodes ? 4 : 5;
    if (parts.size() < wanted) throw FileError("a line is too short: " + std::string(line));
    if (block == Block::Nodes) {
      place[Scanner::to_number<std::int64_t>(parts[0])] =
          static_cast<std::int32_t>(mesh.nodes.size());
      mesh.nodes.push_back({Scanner::to_number<double>(parts[1]),
                            Scanner::to_number<double>(parts[2]),
                            Scanner::to_number<double>(parts[3])});
    } else {
      std::array<std::int32_t, 4> tet{};
      for (std::size_t k = 0; k < 4; ++k) {
        const auto node = place.find(Scanner::to_number<std::int64_t>(parts[k + 1]));
        if (node == place.end()) throw FileError("an element refers to a node that is not there");
        tet[k] = node->second;
      }
      mesh.tets.push_back(tet);
    }
  }
  return mesh;
}

}  // namespace remeshd::client

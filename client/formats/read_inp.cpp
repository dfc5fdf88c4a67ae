// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <map>
#include <ranges>

#include "client/formats/inp_head.h"
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

enum class Block { Nodes, Tets, QuadraticTets, Other };

/// What the data lines below a keyword line are.
Block block_of(const std::string& keyword) {
  if (keyword == "*NODE" || keyword.starts_with("*NODE,")) return Block::Nodes;
  if (!keyword.starts_with("*ELEMENT,")) return Block::Other;
  const auto are = [&](const std::string& type) {
    return keyword.find(type + ",") != std::string::npos || keyword.ends_with(type);
  };
  return are("TYPE=C3D4") ? Block::Tets : are("TYPE=C3D10") ? Block::QuadraticTets : Block::Other;
}

/// Entries of each data line of a block; 0 for other blocks.
std::size_t entries(Block block) {
  switch (block) {
    case Block::Nodes:
      return 4;
    case Block::Tets:
      return 5;
    case Block::QuadraticTets:
      return 11;
    case Block::Other:
      break;
  }
  return 0;
}

/// Index of each node by its number in the file.
using NodesByNumber = std::map<std::int64_t, std::int32_t>;

void read_node(const std::vector<std::string_view>& parts, FileMesh& mesh, NodesByNumber& places) {
  places[Scanner::to_number<std::int64_t>(parts[0])] = static_cast<std::int32_t>(mesh.nodes.size());
  mesh.nodes.push_back({Scanner::to_number<double>(parts[1]), Scanner::to_number<double>(parts[2]),
                        Scanner::to_number<double>(parts[3])});
}

void read_tet(const std::vector<std::string_view>& parts, FileMesh& mesh,
              const NodesByNumber& places) {
  std::array<std::int32_t, 4> tet{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto node = places.find(Scanner::to_number<std::int64_t>(parts[k + 1]));
    if (node == places.end()) throw FileError("an element refers to a node that is not there");
    tet[k] = node->second;
  }
  mesh.tets.push_back(tet);
}

/// How many nodes and tets our own writer says that it wrote.
struct Written {
  std::size_t nodes = 0;
  std::size_t tets = 0;
};

Written written(std::string_view counts) {
  const auto parts = fields(counts);
  if (parts.size() != 2) throw FileError("the counts in front are damaged");
  return {Scanner::to_number<std::size_t>(parts[0]), Scanner::to_number<std::size_t>(parts[1])};
}

/// Whether more digits would make of a node's number that of another node.
bool may_go_on(std::string_view text, const NodesByNumber& places) {
  const auto number = Scanner::to_number<std::int64_t>(text);
  const std::string start = std::to_string(number);
  return std::ranges::any_of(places | std::views::keys, [&](std::int64_t other) {
    return other != number && std::to_string(other).starts_with(start);
  });
}

}  // namespace

FileMesh parse_inp(std::string_view bytes) {
  FileMesh mesh;
  NodesByNumber places;
  Written wrote;
  Block block = Block::Other;
  Scanner scanner(bytes);
  while (!scanner.at_end()) {
    const std::string_view line = scanner.line();
    if (line.starts_with(kInpHead)) wrote = written(line.substr(kInpHead.size()));
    if (line.starts_with("**") || line.find_first_not_of(" \t") == std::string_view::npos) continue;
    if (line.starts_with('*')) {
      block = block_of(folded(line));
      continue;
    }
    if (block == Block::Other) continue;
    const auto parts = fields(line);
    const std::size_t wanted = entries(block);
    if (parts.size() < wanted) throw FileError("a line is too short: " + std::string(line));
    if (block == Block::Nodes)
      read_node(parts, mesh, places);
    else
      read_tet(parts, mesh, places);
    // Some programs leave out the end of the last line. That is accepted where its last number
    // cannot be the beginning of a longer one.
    const bool open = scanner.at_end() && parts.size() == wanted && bytes.back() > ' ';
    if (open && (block == Block::Nodes || may_go_on(parts[wanted - 1], places)))
      throw FileError("its last line may be cut, for it has no end: " + std::string(line));
  }
  if (mesh.nodes.size() < wrote.nodes || mesh.tets.size() < wrote.tets)
    throw FileError("it is cut: there were " + std::to_string(wrote.nodes) + " nodes and " +
                    std::to_string(wrote.tets) + " tets");
  return mesh;
}

}  // namespace remeshd::client

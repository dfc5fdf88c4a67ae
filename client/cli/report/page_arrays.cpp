#include "client/cli/report/page_arrays.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>

namespace remeshd::cli {
namespace {

static_assert(std::endian::native == std::endian::little, "the page's arrays are little-endian");

std::string type_name(float) { return "f32"; }
std::string type_name(std::int32_t) { return "i32"; }
std::string type_name(std::uint8_t) { return "u8"; }

template <class Number>
PageArray array_of(const std::string& name, std::size_t components,
                   const std::vector<Number>& numbers) {
  const auto bytes = std::as_bytes(std::span(numbers));
  return {.name = name,
          .type = type_name(Number{}),
          .components = components,
          .count = numbers.size() / components,
          .bytes = {reinterpret_cast<const char*>(bytes.data()), bytes.size()}};
}

/// The number that each node has in the page; -1 for those left out.
std::vector<std::int32_t> numbers_in_page(const PageMesh& page) {
  std::vector<std::int32_t> numbers(page.mesh.nodes.size(), page.surfaces_only ? -1 : 0);
  for (const client::Facet& facet : page.mesh.facets)
    for (const std::int32_t node : facet.nodes) numbers[static_cast<std::size_t>(node)] = 0;
  std::int32_t next = 0;
  for (std::int32_t& number : numbers)
    if (number == 0) number = next++;
  return numbers;
}

std::uint8_t in_byte(float quality) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(quality, 0.0F, 1.0F)));
}

void add_nodes(const PageMesh& page, const std::vector<std::int32_t>& numbers,
               std::vector<PageArray>& arrays) {
  std::vector<float> nodes, sizes;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    if (numbers[n] < 0) continue;
    for (std::size_t k = 0; k < 3; ++k)
      nodes.push_back(static_cast<float>(page.mesh.nodes[n][k] - page.centre[k]));
    if (!page.mesh.node_sizes.empty()) sizes.push_back(static_cast<float>(page.mesh.node_sizes[n]));
  }
  arrays.push_back(array_of("nodes", 3, nodes));
  if (!sizes.empty()) arrays.push_back(array_of("sizes", 1, sizes));
}

void add_facets(const PageMesh& page, const std::vector<std::int32_t>& numbers,
                std::vector<PageArray>& arrays) {
  std::vector<std::int32_t> corners, groups, tets, cells;
  std::vector<std::uint8_t> states, qualities;
  for (const client::Facet& facet : page.mesh.facets) {
    for (const std::int32_t node : facet.nodes)
      corners.push_back(numbers[static_cast<std::size_t>(node)]);
    const auto tet = static_cast<std::size_t>(facet.tet);
    groups.push_back(facet.group);
    tets.push_back(facet.tet);
    cells.push_back(page.mesh.tet_cell[tet]);
    states.push_back(static_cast<std::uint8_t>(page.states[tet]));
    qualities.push_back(in_byte(page.figures.volume_length[tet]));
  }
  arrays.push_back(array_of("facets", 3, corners));
  arrays.push_back(array_of("facet_group", 1, groups));
  if (!page.surfaces_only) arrays.push_back(array_of("facet_tet", 1, tets));
  arrays.push_back(array_of("facet_cell", 1, cells));
  arrays.push_back(array_of("facet_state", 1, states));
  arrays.push_back(array_of("facet_quality", 1, qualities));
}

void add_tets(const PageMesh& page, std::vector<PageArray>& arrays) {
  std::vector<std::int32_t> corners;
  std::vector<std::uint8_t> states, qualities;
  for (const auto& tet : page.mesh.tets) corners.insert(corners.end(), tet.begin(), tet.end());
  for (const TetState state : page.states) states.push_back(static_cast<std::uint8_t>(state));
  std::ranges::transform(page.figures.volume_length, std::back_inserter(qualities), in_byte);
  arrays.push_back(array_of("tets", 4, corners));
  arrays.push_back(array_of("tet_cell", 1, page.mesh.tet_cell));
  arrays.push_back(array_of("tet_state", 1, states));
  arrays.push_back(array_of("tet_quality", 1, qualities));
}

}  // namespace

std::vector<PageArray> page_arrays(const PageMesh& page) {
  std::vector<PageArray> arrays;
  const auto numbers = numbers_in_page(page);
  add_nodes(page, numbers, arrays);
  add_facets(page, numbers, arrays);
  if (!page.surfaces_only) add_tets(page, arrays);
  return arrays;
}

std::string packed(const std::string& bytes) {
  uLongf length = compressBound(bytes.size());
  std::vector<Bytef> compressed(length);
  if (compress2(compressed.data(), &length, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib could not compress an array of the report");
  std::string text(4 * ((length + 2) / 3) + 1, '\0');  // with the NUL that OpenSSL ends it by
  const int written = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                      compressed.data(), static_cast<int>(length));
  text.resize(static_cast<std::size_t>(written));
  return text;
}

}  // namespace remeshd::cli

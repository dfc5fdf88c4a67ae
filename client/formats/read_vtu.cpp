// SPDX-License-Identifier: Apache-2.0
#include <openssl/evp.h>
#include <zlib.h>

#include <limits>
#include <pugixml.hpp>

#include "client/formats/element_types.h"
#include "client/formats/read_mesh.h"
#include "client/formats/scanner.h"

namespace remeshd::client {
namespace {

/// How the arrays of one file are stored.
struct Storage {
  bool wide_headers = false;  ///< UInt64 instead of UInt32
  bool zlib = false;
  bool base64 = false;          ///< of the appended section
  std::string_view appended{};  ///< behind its underscore
};

std::string from_base64(std::string_view text) {
  std::string clean;
  for (const char c : text)
    if (c > ' ') clean += c;
  if (clean.size() % 4 != 0) throw FileError("base64 data are cut short");
  if (clean.size() > std::size_t{std::numeric_limits<int>::max()})
    throw FileError("base64 data over 2 GiB are not read");
  std::string out(clean.size() / 4 * 3, '\0');
  const int size = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(out.data()),
                                   reinterpret_cast<const unsigned char*>(clean.data()),
                                   static_cast<int>(clean.size()));
  if (size < 0) throw FileError("base64 data are damaged");
  while (clean.ends_with('=')) {
    clean.pop_back();
    out.pop_back();
  }
  return out;
}

/// The first `count` bytes that base64 text stands for.
std::string head_of_base64(std::string_view text, std::size_t count) {
  const std::size_t characters = (count + 2) / 3 * 4;
  if (text.size() < characters) throw FileError("base64 data are cut short");
  const std::string bytes = from_base64(text.substr(0, characters));
  if (bytes.size() < count) throw FileError("base64 data are cut short");  // padded within
  return bytes.substr(0, count);
}

/// The sizes in front of an array's data.
std::vector<std::size_t> sizes(const std::string& bytes, const Storage& storage) {
  std::vector<std::size_t> out;
  Scanner scanner(bytes);
  while (!scanner.at_end()) {
    const std::uint64_t size =
        storage.wide_headers ? scanner.raw<std::uint64_t>() : scanner.raw<std::uint32_t>();
    if (size > (std::uint64_t{1} << 40)) throw FileError("an array is impossibly long");
    out.push_back(static_cast<std::size_t>(size));
  }
  return out;
}

std::string inflate_block(std::string_view packed, std::uint64_t size) {
  constexpr std::uint64_t kMostGrowth = 2048;  // deflate makes 1032 bytes of one
  if (size / kMostGrowth > packed.size()) throw FileError("compressed data are damaged");
  std::string out(size, '\0');
  uLongf length = size;
  if (uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                 reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
      length != size)
    throw FileError("compressed data are damaged");
  return out;
}

/// The bytes of an array whose header and data begin at the front of `text`.
std::string decode(std::string_view text, bool base64, const Storage& storage) {
  const std::size_t word = storage.wide_headers ? 8 : 4;
  const auto head = [&](std::size_t count) {
    if (base64) return head_of_base64(text, count);
    if (text.size() < count) throw FileError("it ends too soon");
    return std::string(text.substr(0, count));
  };
  if (!storage.zlib) {
    const std::size_t size = sizes(head(word), storage)[0];
    // VTK encodes the size apart from the data, meshio together with them.
    const std::size_t apart = (word + 2) / 3 * 4;
    if (base64 && text[apart - 1] == '=') return head_of_base64(text.substr(apart), size);
    return head(word + size).substr(word);
  }
  // Blocks, size of one, size of the last if it is not full, packed sizes; then the blocks, which
  // base64 encodes apart from the sizes.
  const std::size_t blocks = sizes(head(word), storage)[0];
  if (blocks > text.size()) throw FileError("it ends too soon");
  const std::size_t header_size = (3 + blocks) * word;
  const std::vector<std::size_t> header = sizes(head(header_size), storage);
  const std::string_view rest = text.substr(base64 ? (header_size + 2) / 3 * 4 : header_size);
  std::size_t packed = 0;
  for (std::size_t b = 0; b < blocks; ++b) packed += header[3 + b];
  if (!base64 && rest.size() < packed) throw FileError("it ends too soon");
  const std::string data =
      base64 ? head_of_base64(rest, packed) : std::string(rest.substr(0, packed));
  std::string out;
  std::size_t at = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    const bool partial = b + 1 == blocks && header[2] != 0;
    out += inflate_block(std::string_view(data).substr(at, header[3 + b]),
                         partial ? header[2] : header[1]);
    at += header[3 + b];
  }
  return out;
}

template <class To, class From>
std::vector<To> converted(const std::string& bytes) {
  Scanner scanner(bytes);
  std::vector<To> out;
  out.reserve(bytes.size() / sizeof(From));
  while (!scanner.at_end()) {
    const From value = scanner.raw<From>();
    if constexpr (std::is_integral_v<To> && std::is_floating_point_v<From>)
      if (!(value >= -0x1p62 && value <= 0x1p62)) throw FileError("a whole number is too large");
    out.push_back(static_cast<To>(value));
  }
  return out;
}

/// The values of a DataArray element, whatever their type and place.
template <class To>
std::vector<To> values_of(pugi::xml_node array, const Storage& storage) {
  if (!array) throw FileError("an array is missing");
  const std::string_view format = array.attribute("format").as_string("ascii");
  if (format == "ascii") {
    std::vector<To> out;
    Scanner scanner(array.text().get());
    while (scanner.skip_blanks()) out.push_back(scanner.number<To>());
    return out;
  }
  std::string bytes;
  if (format == "binary") {
    std::string_view text = array.text().get();
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    bytes = decode(text, true, storage);
  } else {
    const std::uint64_t offset = array.attribute("offset").as_ullong();
    if (offset > storage.appended.size()) throw FileError("it ends too soon");
    bytes = decode(storage.appended.substr(offset), storage.base64, storage);
  }
  const std::string_view type = array.attribute("type").as_string();
  if (type == "Float64") return converted<To, double>(bytes);
  if (type == "Float32") return converted<To, float>(bytes);
  if (type == "Int64") return converted<To, std::int64_t>(bytes);
  if (type == "UInt64") return converted<To, std::uint64_t>(bytes);
  if (type == "Int32") return converted<To, std::int32_t>(bytes);
  if (type == "UInt32") return converted<To, std::uint32_t>(bytes);
  if (type == "UInt8") return converted<To, std::uint8_t>(bytes);
  if (type == "Int8") return converted<To, std::int8_t>(bytes);
  throw FileError("arrays of type '" + std::string(type) + "' are unknown");
}

void read_piece(pugi::xml_node piece, const Storage& storage, FileMesh& mesh) {
  const auto points = values_of<double>(piece.child("Points").child("DataArray"), storage);
  const std::size_t first = mesh.nodes.size();
  for (std::size_t k = 0; k + 2 < points.size(); k += 3)
    mesh.nodes.push_back({points[k], points[k + 1], points[k + 2]});

  const pugi::xml_node cells = piece.child("Cells");
  const auto array = [&](const char* name) {
    return values_of<std::int64_t>(cells.find_child_by_attribute("DataArray", "Name", name),
                                   storage);
  };
  const auto connectivity = array("connectivity");
  const auto offsets = array("offsets");
  const auto types = array("types");
  if (offsets.size() != types.size()) throw FileError("its cells are damaged");
  for (std::size_t c = 0; c < types.size(); ++c) {
    if (types[c] != kVtkTetra && types[c] != kVtkQuadraticTetra) continue;
    const std::int64_t nodes = types[c] == kVtkTetra ? 4 : 10;
    if (offsets[c] < nodes || static_cast<std::size_t>(offsets[c]) > connectivity.size())
      throw FileError("its cells are damaged");
    std::array<std::int32_t, 4> tet{};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int64_t node = connectivity[static_cast<std::size_t>(offsets[c] - nodes) + k];
      if (node < 0 || static_cast<std::uint64_t>(node) >= mesh.nodes.size() - first)
        throw FileError("a tet refers to a node that is not there");
      tet[k] = static_cast<std::int32_t>(static_cast<std::size_t>(node) + first);
    }
    mesh.tets.push_back(tet);
  }
}

}  // namespace

FileMesh parse_vtu(std::string_view bytes) {
  // Raw appended data are no XML: the document is what stands before them.
  Storage storage;
  const std::size_t cut = bytes.find("<AppendedData");
  std::string head(bytes.substr(0, cut));
  if (cut != std::string_view::npos) {
    const std::size_t open = bytes.find('>', cut);
    const std::size_t underscore = bytes.find('_', std::min(open, bytes.size()));
    if (underscore == std::string_view::npos) throw FileError("its appended data are damaged");
    storage.base64 = bytes.substr(cut, open - cut).find("base64") != std::string_view::npos;
    storage.appended = bytes.substr(underscore + 1);
    if (storage.base64) storage.appended = storage.appended.substr(0, storage.appended.find('<'));
    head += "</VTKFile>";
  }
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(head.data(), head.size());
  if (!result) throw FileError(std::string("it is no XML: ") + result.description());
  const pugi::xml_node file = document.child("VTKFile");
  if (std::string_view(file.attribute("type").as_string()) != "UnstructuredGrid")
    throw FileError("it is no VTK unstructured grid");
  if (std::string_view(file.attribute("byte_order").as_string("LittleEndian")) != "LittleEndian")
    throw FileError("its byte order is not little-endian");
  storage.wide_headers = std::string_view(file.attribute("header_type").as_string()) == "UInt64";
  const std::string_view compressor = file.attribute("compressor").as_string();
  storage.zlib = compressor == "vtkZLibDataCompressor";
  if (!compressor.empty() && !storage.zlib)
    throw FileError("compressor " + std::string(compressor) + " is unknown");

  FileMesh mesh;
  for (const pugi::xml_node piece : file.child("UnstructuredGrid").children("Piece"))
    read_piece(piece, storage, mesh);
  return mesh;
}

}  // namespace remeshd::client

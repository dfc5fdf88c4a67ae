#include "engine/nodes/dump.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "engine/base/error.h"

namespace remeshd {

namespace {

/// One DataArray; `value(i)` is what is written for element i.
template <class Value>
void array(std::ostream& out, const char* type, const char* name, int components, std::size_t count,
           const Value& value) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
      << components << "\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < count; ++i) {
    value(i);
    out << '\n';
  }
  out << "</DataArray>\n";
}

/// Opens a file in the run's folder; where that fails, `finish` throws.
std::ofstream opened(const Run& run, const std::string& file) {
  std::error_code ignored;
  std::filesystem::create_directories(run.dumps, ignored);
  return std::ofstream(run.dumps / file);
}

void finish(std::ofstream& out, const Run& run) {
  out.close();
  if (!out) throw error::internal("dump", "a dump could not be written to " + run.dumps.string());
}

}  // namespace

void dump_nodes(const Run& run, std::string_view name, const NodeSet& nodes, const SizeField& sizes,
                std::span<const Tet> tets) {
  if (run.dumps.empty()) return;
  std::ofstream out = opened(run, std::string(name) + ".vtu");
  out.precision(17);
  const std::size_t count = nodes.positions.size();
  const bool points = tets.empty();
  const std::size_t cells = points ? count : tets.size();
  out << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid>\n"
      << "<Piece NumberOfPoints=\"" << count << "\" NumberOfCells=\"" << cells << "\">\n"
      << "<PointData>\n";
  array(out, "Int32", "new", 1, count, [&](std::size_t n) { out << (nodes.original[n] < 0); });
  array(out, "Int32", "free", 1, count, [&](std::size_t n) { out << (nodes.is_free(n) ? 1 : 0); });
  array(out, "Int32", "boundary", 1, count,
        [&](std::size_t n) { out << (nodes.supports[n].kind != Support::Kind::Interior); });
  array(out, "Float64", "size", 1, count, [&](std::size_t n) { out << sizes(nodes.positions[n]); });
  out << "</PointData>\n<Points>\n";
  array(out, "Float64", "Points", 3, count, [&](std::size_t n) {
    const Vec3& p = nodes.positions[n];
    out << p.x << ' ' << p.y << ' ' << p.z;
  });
  out << "</Points>\n<Cells>\n";
  array(out, "Int64", "connectivity", 1, cells, [&](std::size_t i) {
    if (points)
      out << i;
    else
      out << tets[i][0] << ' ' << tets[i][1] << ' ' << tets[i][2] << ' ' << tets[i][3];
  });
  array(out, "Int64", "offsets", 1, cells,
        [&](std::size_t i) { out << (points ? 1 : 4) * (i + 1); });
  array(out, "UInt8", "types", 1, cells, [&](std::size_t) { out << (points ? 1 : 10); });
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  finish(out, run);
}

void dump_text(const Run& run, std::string_view name, const std::function<std::string()>& text) {
  if (run.dumps.empty()) return;
  std::ofstream out = opened(run, std::string(name) + ".txt");
  out << text();
  finish(out, run);
}

}  // namespace remeshd

// Gmsh as a peer of the benchmark, in a program of its own: Gmsh brings parts of Netgen and TetGen,
// which must not meet other editions of them.
//
//   remesh-peer-gmsh geometry MODEL.json OUT.brep       the merged solid
//   remesh-peer-gmsh mesh GEOMETRY.brep SIZE hxt|delaunay [EDGES_PER_CIRCLE]
//   remesh-peer-gmsh surface GEOMETRY.brep SIZE OUT.smesh
//
// Each prints a line of JSON.
#include <gmsh.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/bench/peers/gmsh_geometry.h"
#include "tests/bench/sample.h"
#include "tests/support/documents.h"

namespace {

using namespace remeshd;
using namespace remeshd::bench;
using nlohmann::json;

/// Gmsh's node tags as indices, and the nodes.
struct Nodes {
  std::vector<Vec3> points;
  std::map<std::size_t, std::int32_t> index;
};

/// Of the elements of a type, the node tags; `per_element` of them for each.
std::vector<std::size_t> elements(int type) {
  std::vector<std::size_t> tags, nodes;
  gmsh::model::mesh::getElementsByType(type, tags, nodes);
  return nodes;
}

/// The nodes that the elements use.
Nodes nodes_of(const std::vector<std::size_t>& used) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::size_t largest = 0;
  for (const std::size_t tag : tags) largest = std::max(largest, tag);
  std::vector<std::uint8_t> wanted(largest + 1, 0);
  for (const std::size_t tag : used) wanted[tag] = 1;
  Nodes nodes;
  for (std::size_t k = 0; k < tags.size(); ++k) {
    if (wanted[tags[k]] == 0) continue;
    nodes.index[tags[k]] = static_cast<std::int32_t>(nodes.points.size());
    nodes.points.push_back({coordinates[3 * k], coordinates[3 * k + 1], coordinates[3 * k + 2]});
  }
  return nodes;
}

constexpr int kTriangles = 2, kTets = 4;  // Gmsh's element types

int make_geometry(const std::string& model_file, const std::string& out) {
  std::ifstream in(model_file);
  if (!in) throw std::runtime_error("cannot open " + model_file);
  const FeatureModel model = evaluate(test::read_model(json::parse(in)));
  const double before = processor_seconds();
  const int volume = build_merged_solid(model);
  const double seconds = processor_seconds() - before;
  double mass = 0;
  gmsh::model::occ::getMass(3, volume, mass);
  gmsh::vectorpair faces;
  gmsh::model::getEntities(faces, 2);
  gmsh::write(out);
  std::cout << json{{"volume", mass}, {"faces", faces.size()}, {"cpu", seconds}}.dump()
            << std::endl;
  return 0;
}

/// Of the size, that edges have at least: as in ours where they follow the curvature.
double least_share = 1;

void set_size(double size) {
  gmsh::option::setNumber("Mesh.MeshSizeMin", least_share * size);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
}

/// A small mesh, so that no measured one pays for what the library does once.
void warm_up(int dimension) {
  gmsh::model::add("warm-up");
  gmsh::model::occ::addBox(0, 0, 0, 1, 1, 1);
  gmsh::model::occ::synchronize();
  set_size(0.3);
  gmsh::model::mesh::generate(dimension);
  gmsh::model::remove();
}

/// Reads the geometry and meshes it, up to volumes or surfaces alone.
Sample mesh(const std::string& geometry, double size, int dimension) {
  Sample sample;
  warm_up(dimension);
  Meter meter;
  gmsh::model::add("case");
  const double before = processor_seconds();
  gmsh::vectorpair imported;
  gmsh::model::occ::importShapes(geometry, imported);
  gmsh::model::occ::synchronize();
  sample.import = processor_seconds() - before;
  set_size(size);
  meter.start();
  const double start = processor_seconds();
  gmsh::model::mesh::generate(2);
  sample.surface = processor_seconds() - start;
  if (dimension == 3) gmsh::model::mesh::generate(3);
  meter.stop(sample);
  return sample;
}

void print(const Sample& sample) { std::cout << write_sample(sample).dump() << std::endl; }

int make_mesh(const std::string& geometry, double size, const std::string& algorithm) {
  gmsh::option::setNumber("Mesh.Algorithm3D", algorithm == "hxt" ? 10 : 1);
  gmsh::option::setNumber("Mesh.Optimize", 1);
  Sample sample = mesh(geometry, size, 3);
  const std::vector<std::size_t> corners = elements(kTets);
  if (corners.empty()) throw std::runtime_error("Gmsh made no tets");
  const Nodes nodes = nodes_of(corners);
  std::vector<Tet> tets(corners.size() / 4);
  for (std::size_t k = 0; k < corners.size(); ++k) tets[k / 4][k % 4] = nodes.index.at(corners[k]);
  describe_mesh(nodes.points, tets, sample);
  print(sample);
  return 0;
}

int make_surface(const std::string& geometry, double size, const std::string& out) {
  Sample sample = mesh(geometry, size, 2);
  const std::vector<std::size_t> corners = elements(kTriangles);
  const Nodes nodes = nodes_of(corners);
  std::ofstream file(out);
  file.precision(std::numeric_limits<double>::max_digits10);
  file << nodes.points.size() << " 3 0 0\n";
  for (std::size_t k = 0; k < nodes.points.size(); ++k) {
    const Vec3& p = nodes.points[k];
    file << k << " " << p.x << " " << p.y << " " << p.z << "\n";
  }
  file << corners.size() / 3 << " 0\n";
  for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
    file << "3 " << nodes.index.at(corners[k]) << " " << nodes.index.at(corners[k + 1]) << " "
         << nodes.index.at(corners[k + 2]) << "\n";
  file << "0\n0\n";
  if (!file.flush()) throw std::runtime_error("cannot write " + out);
  sample.nodes = static_cast<std::uint32_t>(nodes.points.size());
  print(sample);
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 3) return 2;
  gmsh::initialize();
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  // Uniform edges, as ours are.
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  if (arguments[0] == "geometry") return make_geometry(arguments[1], arguments[2]);
  if (arguments.size() < 4) return 2;
  const double size = std::stod(arguments[2]);
  if (arguments.size() > 4) {
    gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", std::stod(arguments[4]));
    least_share = 0.1;
  }
  if (arguments[0] == "mesh") return make_mesh(arguments[1], size, arguments[3]);
  if (arguments[0] == "surface") return make_surface(arguments[1], size, arguments[3]);
  return 2;
} catch (const std::exception& failure) {
  std::cerr << "remesh-peer-gmsh: " << failure.what() << "\n";
  return 1;
}

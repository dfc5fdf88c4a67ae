// Netgen as a peer of the benchmark, in a program of its own.
//
//   remesh-peer-netgen GEOMETRY.brep SIZE
//
// Prints a line of JSON. Edges, surface and volume with Netgen's own settings, optimisation
// included; SIZE is the largest edge length.
#include <array>
#include <cstddef>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/bench/sample.h"

// The library has it all in this namespace, its header only by whoever includes it; and functions
// for B-reps only where that is defined.
#define OCCGEOMETRY
namespace nglib {
#include <nglib.h>
}

namespace {

using namespace remeshd;
using namespace remeshd::bench;

void require(bool well, const char* what) {
  if (!well) throw std::runtime_error(what);
}

Sample mesh(const std::string& file, double size) {
  using namespace nglib;
  Sample sample;
  Meter meter;
  const double before = processor_seconds();
  Ng_OCC_Geometry* geometry = Ng_OCC_Load_BREP(file.c_str());
  require(geometry != nullptr, "Netgen does not read the geometry");
  sample.import = processor_seconds() - before;

  Ng_Meshing_Parameters parameters;
  parameters.maxh = size;
  Ng_Mesh* made = Ng_NewMesh();
  meter.start();
  const double start = processor_seconds();
  Ng_OCC_SetLocalMeshSize(geometry, made, &parameters);
  require(Ng_OCC_GenerateEdgeMesh(geometry, made, &parameters) == NG_OK, "no edges");
  require(Ng_OCC_GenerateSurfaceMesh(geometry, made, &parameters) == NG_OK, "no surface");
  sample.surface = processor_seconds() - start;
  require(Ng_GenerateVolumeMesh(made, &parameters) == NG_OK, "no volume");
  meter.stop(sample);

  std::vector<Vec3> nodes(Ng_GetNP(made));
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    std::array<double, 3> p{};
    Ng_GetPoint(made, static_cast<int>(k) + 1, p.data());
    nodes[k] = {p[0], p[1], p[2]};
  }
  std::vector<Tet> tets(Ng_GetNE(made));
  for (std::size_t k = 0; k < tets.size(); ++k) {
    std::array<int, NG_VOLUME_ELEMENT_MAXPOINTS> corners{};
    require(Ng_GetVolumeElement(made, static_cast<int>(k) + 1, corners.data()) == NG_TET,
            "an element is no tet");
    for (int i = 0; i < 4; ++i) tets[k][i] = corners[i] - 1;
  }
  describe_mesh(nodes, tets, sample);
  return sample;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) return 2;
  // Netgen talks on stdout.
  std::ostringstream talk;
  std::streambuf* out = std::cout.rdbuf(talk.rdbuf());
  nglib::Ng_Init();
  const Sample sample = mesh(argv[1], std::stod(argv[2]));
  std::cout.rdbuf(out);
  std::cout << write_sample(sample).dump() << std::endl;
  return 0;
} catch (const std::exception& failure) {
  std::cerr << "remesh-peer-netgen: " << failure.what() << "\n";
  return 1;
}

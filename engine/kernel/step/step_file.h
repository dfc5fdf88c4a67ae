#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/base/surface.h"
#include "engine/kernel/brep.h"

namespace remeshd::kernel {

/// A face of a B-rep with material on one side.
struct SkinFace {
  int face = -1;
  bool material_behind = true;  ///< in cells[0] of the face, else in cells[1]
  int whole = -1;               ///< the face of the model that it is a part of, 0 ..
};

/// All faces of a B-rep with material on one side, and the faces of the model they are parts of.
struct Skin {
  std::vector<SkinFace> faces;
  std::vector<std::string> names;  ///< of the faces of the model
  std::vector<int> edges;          ///< of the B-rep, which remain edges where faces are joined
  std::vector<int> vertices;       ///< likewise, where edges are
};

/// The unit of lengths that a file declares.
struct LengthUnit {
  const char* name = "MM";  ///< as OpenCASCADE's `write.step.unit` spells it
  double millimetres = 1;
};

/// What a file tells beside the geometry.
struct StepLabels {
  std::string file;                      ///< its name
  std::vector<std::string> description;  ///< of its content, a line each
  std::string origin;                    ///< the system that made the model
  std::string solid;                     ///< the name of the model
  LengthUnit unit;
};

/// The material as an exact B-rep in a STEP file (ISO 10303-21, AP214): one solid, with its voids.
/// Coordinates are the model's to 16 digits. The bytes depend on the arguments alone. Where the
/// parts of some face cannot be joined none are: all parts are faces, each under the name of its
/// face of the model.
///
/// Pre: the skin is closed and manifold, its material in one piece.
/// Throws Error(KERNEL_FAILURE), Error(Cancelled).
std::string write_step(const Brep& brep, const Skin& skin, const StepLabels& labels,
                       const Run& run);

struct StepFace {
  std::string name;
  double area = 0;
};

/// What a STEP file holds, by a reader that has not seen the model; in the file's unit.
struct StepContent {
  int solids = 0, shells = 0;
  std::vector<StepFace> faces;
  int edges = 0;  ///< without seams and the poles and apexes of surfaces
  std::vector<std::string> solid_names;
  double volume = 0, area = 0;  ///< exact
  Box box;                      ///< may be a little larger than need be
};

/// Reads a file whose lengths are all in `unit`. `scale`: about Brep::scale of the model in the
/// file.
///
/// Throws Error(KERNEL_FAILURE) where it is no STEP file or nothing can be made of it,
/// Error(Cancelled).
StepContent read_step(const std::string& bytes, const LengthUnit& unit, double scale,
                      const Run& run);

}  // namespace remeshd::kernel

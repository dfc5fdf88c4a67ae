#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/random.h"
#include "engine/base/vec.h"
#include "engine/model/source.h"

namespace remeshd::campaign {

/// A free disc on the body where features may stand: local z looks out of the material.
struct Site {
  Transform frame;
  double radius = 0;                  ///< of the disc
  double depth = 0;                   ///< of the material below it
  std::vector<std::string> features;  ///< what stands there; empty: the site is free
};

/// A model in the making: the document, and what a generator of further features has to know.
struct Draft {
  Random random;
  ModelSource model;
  std::vector<Site> sites;
  std::vector<std::string> body;   ///< ids of the features that carry all others
  double length = 0;               ///< about the target edge length l
  double nodes = 2000;             ///< the target that l follows from
  bool dense = false;              ///< as many sites as there is room for
  bool may_add_parameters = true;  ///< an edit adds none
  int serial = 0;                  ///< for ids

  explicit Draft(std::uint64_t seed) : random(seed) {}

  bool chance(double probability) { return random.uniform() < probability; }
  /// 10^uniform: sizes over many orders of magnitude.
  double log_uniform(double lo, double hi);
  /// A number, or now and then an expression of that value over a parameter of the model.
  Scalar value(double v);

  /// Adds a feature at the end of history and returns its id.
  std::string add(const std::string& type, Nature nature, const Transform& placement,
                  const std::vector<std::pair<std::string, double>>& parameters);
  /// The same with a profile.
  std::string add_outline(const std::string& type, Nature nature, const Transform& placement,
                          const std::vector<ProfileEntry>& profile,
                          const std::vector<std::pair<std::string, double>>& parameters);
};

/// Digits that read back to the same bits.
std::string text_of_number(double v);

/// The placement of a document for a frame; axes that are the default are left out.
PlacementSource placement_of(const Transform& frame);

/// `frame` moved by a vector in its own axes.
Transform shifted(const Transform& frame, double x, double y, double z);
/// `frame` turned about its own axis (0 x, 1 y, 2 z) by an angle in rad.
Transform turned(const Transform& frame, int axis, double angle);
/// A frame of uniformly random directions at the origin.
Transform random_rotation(Random& random);

/// Regular polygon of `corners` round the origin.
std::vector<ProfileEntry> polygon(int corners, double radius);
std::vector<ProfileEntry> outline(const std::vector<std::array<double, 2>>& corners);

/// Sets `draft.length` from the model as it stands and the target of nodes.
/// Throws Error where the model is not valid.
void find_length(Draft& draft);

}  // namespace remeshd::campaign

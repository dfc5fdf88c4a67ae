#include "engine/model/shape.h"

#include <cmath>
#include <numbers>

#include "engine/base/angle.h"
#include "engine/base/error.h"
#include "engine/model/expression.h"
#include "engine/model/feature_types.h"
#include "engine/model/limits.h"
#include "engine/model/profile.h"

namespace remeshd {
namespace {

/// Reads the parameters of one feature by name.
class Reader {
 public:
  Reader(const FeatureSource& source, const Scope& scope) : source_(source), scope_(scope) {}

  [[nodiscard]] bool has(const std::string& name) const {
    return source_.parameters.contains(name);
  }
  [[nodiscard]] double value(const std::string& name) const {
    return scope_.value(source_.parameters.at(name), source_.id, name);
  }
  [[nodiscard]] double size(const std::string& name) const {
    return checked_size(value(name), false, source_.id, name);
  }
  [[nodiscard]] double size_or_zero(const std::string& name) const {
    return checked_size(value(name), true, source_.id, name);
  }
  [[noreturn]] void degenerate(const std::string& name, double value,
                               const std::string& why) const {
    throw error::degenerate_feature(source_.id, name, value, why);
  }
  [[nodiscard]] const FeatureSource& source() const { return source_; }
  [[nodiscard]] const Scope& scope() const { return scope_; }

 private:
  const FeatureSource& source_;
  const Scope& scope_;
};

Shape read_block(const Reader& r) { return Block{r.size("dx"), r.size("dy"), r.size("dz")}; }

Shape read_cylinder(const Reader& r) { return Cylinder{r.size("radius"), r.size("height")}; }

Shape read_cone(const Reader& r) {
  const Cone cone{r.size_or_zero("radius_bottom"), r.size_or_zero("radius_top"), r.size("height")};
  if (cone.radius_bottom == 0 && cone.radius_top == 0)
    r.degenerate("radius_top", 0, "cannot be zero as well as radius_bottom");
  return cone;
}

Shape read_sphere(const Reader& r) { return Sphere{r.size("radius")}; }

Shape read_torus(const Reader& r) {
  const Torus torus{r.size("major_radius"), r.size("minor_radius")};
  if (torus.minor_radius >= torus.major_radius)
    r.degenerate("minor_radius", torus.minor_radius, "must be less than major_radius");
  return torus;
}

Shape read_prism(const Reader& r) {
  const double height = r.size("height");
  return Prism{evaluate_profile(*r.source().profile, r.scope(), r.source().id), height};
}

Shape read_revolution(const Reader& r) {
  double angle = kTurn;
  if (r.has("angle")) {
    const double degrees = r.value("angle");
    // 2*180 and 720*cos(60*deg) both mean a full turn.
    const bool full = std::fabs(degrees - 360) <= 1e-9;
    if (!full && degrees > 360) r.degenerate("angle", degrees, "must be at most 360 degrees");
    if (degrees < kMinSize) r.degenerate("angle", degrees, "must be positive");
    if (!full) angle = degrees * (std::numbers::pi / 180);
  }
  const bool full_turn = angle == kTurn;
  return Revolution{evaluate_half_profile(*r.source().profile, full_turn, r.scope(), r.source().id),
                    angle};
}

Shape read_slot(const Reader& r) {
  const Slot slot{r.size("length"), r.size("width"), r.size("height")};
  if (slot.length <= slot.width)
    r.degenerate("length", slot.length, "must be more than width; a round slot is a cylinder");
  return slot;
}

struct TypeReader {
  std::string_view name;
  Shape (*read)(const Reader&);
};
constexpr TypeReader kReaders[] = {
    {"block", read_block},           {"cylinder", read_cylinder}, {"cone", read_cone},
    {"sphere", read_sphere},         {"torus", read_torus},       {"prism", read_prism},
    {"revolution", read_revolution}, {"slot", read_slot},
};

/// Throws on missing and extra parameters, and on a profile where there should be none.
void check_parameter_names(const FeatureSource& source, const FeatureTypeInfo& type) {
  for (const auto& [name, scalar] : source.parameters) {
    const ParameterInfo* parameter = find_parameter(type, name);
    if (parameter == nullptr)
      throw error::unknown_parameter(source.id, name, list_parameters(type));
    if (parameter->unit == "profile")
      throw error::wrong_value_kind(source.id, name, "a list of points and arcs");
  }
  if (source.profile && find_parameter(type, "profile") == nullptr)
    throw error::unknown_parameter(source.id, "profile", list_parameters(type));
  for (const ParameterInfo& parameter : type.parameters) {
    const bool present = parameter.unit == "profile" ? source.profile.has_value()
                                                     : source.parameters.contains(parameter.name);
    if (parameter.required && !present)
      throw error::missing_parameter(source.id, parameter.name, type.name);
  }
}

}  // namespace

Shape evaluate_shape(const FeatureSource& source, const Scope& scope) {
  const FeatureTypeInfo* type = find_feature_type(source.type);
  if (type == nullptr)
    throw error::unknown_feature_type(source.id, source.type, list_feature_types());
  check_parameter_names(source, *type);
  for (const TypeReader& reader : kReaders)
    if (reader.name == source.type) return reader.read(Reader(source, scope));
  throw error::internal("model", "a feature type of the table has no reader");
}

}  // namespace remeshd

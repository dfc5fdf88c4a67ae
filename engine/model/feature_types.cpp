#include "engine/model/feature_types.h"

namespace remeshd {
namespace {

ParameterInfo length(std::string name, std::string description) {
  return {std::move(name), "length", std::move(description), true, ""};
}

const std::string kProfileForm =
    "closed outline: a list of points [x, y] and arcs {\"to\": [x, y], \"through\": [x, y]}; the "
    "first entry is a point, an arc is the side that ends at `to`, and the last side closes the "
    "loop unless the last entry returns to the first";

}  // namespace

const std::vector<FeatureTypeInfo>& feature_types() {
  static const std::vector<FeatureTypeInfo> types{
      {"block",
       "box centred on x and y, z from 0 to dz",
       {length("dx", "extent along x"), length("dy", "extent along y"),
        length("dz", "extent along z")},
       {"x_min", "x_max", "y_min", "y_max", "bottom", "top"}},
      {"cylinder",
       "round cylinder along z from 0 to height",
       {length("radius", "radius"), length("height", "extent along z")},
       {"wall", "bottom", "top"}},
      {"cone",
       "cone or frustum along z from 0 to height; a face whose radius is 0 does not exist",
       {length("radius_bottom", "radius at z = 0; one of the two radii may be 0"),
        length("radius_top", "radius at z = height; one of the two radii may be 0"),
        length("height", "extent along z")},
       {"wall", "bottom", "top"}},
      {"sphere", "ball centred at the origin", {length("radius", "radius")}, {"surface"}},
      {"torus",
       "ring about z, centred at the origin",
       {length("major_radius", "from the axis to the centre of the tube; above minor_radius"),
        length("minor_radius", "radius of the tube")},
       {"surface"}},
      {"prism",
       "outline in the xy plane extruded along z from 0 to height",
       {{"profile", "profile", kProfileForm, true, ""}, length("height", "extent along z")},
       {"side#", "bottom", "top"}},
      {"revolution",
       "outline in the half-plane x >= 0 of xz, turned about z; sides on the axis sweep no face, "
       "and "
       "start and end exist where the angle is below 360",
       {{"profile", "profile", kProfileForm + "; its y is the local z", true, ""},
        {"angle", "deg", "angle turned through from the xz plane, above 0 and at most 360", false,
         "360"}},
       {"side#", "start", "end"}},
      {"slot",
       "obround (a rectangle between two half circles) in xy, centred, along x, z from 0 to height",
       {length("length", "total length along x; above width"),
        length("width", "extent along y, diameter of the half circles"),
        length("height", "extent along z")},
       {"wall", "bottom", "top"}},
  };
  return types;
}

const FeatureTypeInfo* find_feature_type(std::string_view name) {
  for (const FeatureTypeInfo& type : feature_types())
    if (type.name == name) return &type;
  return nullptr;
}

const ParameterInfo* find_parameter(const FeatureTypeInfo& type, std::string_view name) {
  for (const ParameterInfo& parameter : type.parameters)
    if (parameter.name == name) return &parameter;
  return nullptr;
}

std::string list_feature_types() {
  std::string list;
  for (const FeatureTypeInfo& type : feature_types())
    list += (list.empty() ? "" : ", ") + type.name;
  return list;
}

std::string list_parameters(const FeatureTypeInfo& type) {
  std::string list;
  for (const ParameterInfo& parameter : type.parameters)
    list += (list.empty() ? "" : ", ") + parameter.name;
  return list;
}

}  // namespace remeshd

#include "server/session/recipe.h"

#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "server/store/json_number.h"

namespace remeshd {
namespace {

using nlohmann::json;

constexpr int kFormat = 1;

json to_json(const Scalar& value) {
  return std::visit([](const auto& v) { return json(v); }, value);
}
Scalar scalar_in(const json& j) {
  if (j.is_string()) return j.get<std::string>();
  return j.get<double>();
}

template <std::size_t n>
json to_json(const std::array<Scalar, n>& values) {
  json list = json::array();
  for (const Scalar& value : values) list.push_back(to_json(value));
  return list;
}
template <std::size_t n>
std::array<Scalar, n> scalars_in(const json& j) {
  std::array<Scalar, n> values;
  for (std::size_t i = 0; i < n; ++i) values[i] = scalar_in(j.at(i));
  return values;
}

json to_json(const ParameterSource& p) {
  json j{{"name", p.name},
         {"value", to_json(p.value)},
         {"integer", p.integer},
         {"unit", p.unit},
         {"description", p.description}};
  if (p.lower) j["lower"] = *p.lower;
  if (p.upper) j["upper"] = *p.upper;
  return j;
}
ParameterSource parameter_in(const json& j) {
  ParameterSource p{.name = j.at("name"), .value = scalar_in(j.at("value"))};
  p.integer = j.at("integer");
  p.unit = j.at("unit");
  p.description = j.at("description");
  if (j.contains("lower")) p.lower = j.at("lower").get<double>();
  if (j.contains("upper")) p.upper = j.at("upper").get<double>();
  return p;
}

json to_json(const PlacementSource& p) {
  json j{{"origin", to_json(p.origin)}};
  if (p.z_axis) j["z_axis"] = to_json(*p.z_axis);
  if (p.x_axis) j["x_axis"] = to_json(*p.x_axis);
  return j;
}
PlacementSource placement_in(const json& j) {
  PlacementSource p{.origin = scalars_in<3>(j.at("origin"))};
  if (j.contains("z_axis")) p.z_axis = scalars_in<3>(j.at("z_axis"));
  if (j.contains("x_axis")) p.x_axis = scalars_in<3>(j.at("x_axis"));
  return p;
}

json to_json(const ProfileEntry& entry) {
  json j{{"x", to_json(entry.x)}, {"y", to_json(entry.y)}};
  if (entry.through) j["through"] = to_json(*entry.through);
  return j;
}
ProfileEntry profile_entry_in(const json& j) {
  ProfileEntry entry{.x = scalar_in(j.at("x")), .y = scalar_in(j.at("y"))};
  if (j.contains("through")) entry.through = scalars_in<2>(j.at("through"));
  return entry;
}

json to_json(const FeatureSource& f) {
  json j{{"id", f.id},
         {"subtractive", f.nature == Nature::Subtractive},
         {"type", f.type},
         {"parameters", json::object()},
         {"placement", to_json(f.placement)}};
  for (const auto& [name, value] : f.parameters) j["parameters"][name] = to_json(value);
  if (f.profile) {
    j["profile"] = json::array();
    for (const ProfileEntry& entry : *f.profile) j["profile"].push_back(to_json(entry));
  }
  if (const auto* kind = std::get_if<ReferenceKind>(&f.reference)) {
    j["reference"] = *kind == ReferenceKind::Centre ? "centre" : "origin";
  } else {
    j["reference"] = to_json(std::get<std::array<Scalar, 3>>(f.reference));
  }
  return j;
}
FeatureSource feature_in(const json& j) {
  FeatureSource f{
      .id = j.at("id"),
      .nature = j.at("subtractive").get<bool>() ? Nature::Subtractive : Nature::Additive,
      .type = j.at("type")};
  for (const auto& [name, value] : j.at("parameters").items())
    f.parameters[name] = scalar_in(value);
  if (j.contains("profile")) {
    f.profile.emplace();
    for (const json& entry : j.at("profile")) f.profile->push_back(profile_entry_in(entry));
  }
  f.placement = placement_in(j.at("placement"));
  const json& reference = j.at("reference");
  if (reference.is_array()) {
    f.reference = scalars_in<3>(reference);
  } else {
    f.reference = reference == "centre" ? ReferenceKind::Centre : ReferenceKind::Origin;
  }
  return f;
}

json to_json(const SizeControlSource& s) {
  json j{{"id", s.id}, {"size", to_json(s.size)}};
  if (const auto* on = std::get_if<std::string>(&s.place)) {
    j["on"] = *on;
  } else if (const auto* ball = std::get_if<BallSource>(&s.place)) {
    j["ball"] = to_json(*ball);
  } else {
    j["box"] = to_json(std::get<BoxSource>(s.place));
  }
  return j;
}
SizeControlSource size_in(const json& j) {
  SizeControlSource s{.id = j.at("id"), .place = {}, .size = scalar_in(j.at("size"))};
  if (j.contains("on")) {
    s.place = j.at("on").get<std::string>();
  } else if (j.contains("ball")) {
    s.place = scalars_in<4>(j.at("ball"));
  } else {
    s.place = scalars_in<6>(j.at("box"));
  }
  return s;
}

json to_json(const GroupSource& g) {
  json j{{"name", g.name}, {"on", g.on}, {"fail_emptied", g.policy.fail_emptied}};
  if (g.policy.max_area_change) j["max_area_change"] = *g.policy.max_area_change;
  return j;
}
GroupSource group_in(const json& j) {
  GroupSource g{.name = j.at("name"), .on = j.at("on")};
  g.policy.fail_emptied = j.at("fail_emptied");
  if (j.contains("max_area_change"))
    g.policy.max_area_change = j.at("max_area_change").get<double>();
  return g;
}

json to_json(const ModelSource& m) {
  json j{{"name", m.name},
         {"unit", m.unit},
         {"parameters", json::array()},
         {"features", json::array()}};
  for (const ParameterSource& p : m.parameters) j["parameters"].push_back(to_json(p));
  for (const FeatureSource& f : m.features) j["features"].push_back(to_json(f));
  for (const SizeControlSource& s : m.sizes) j["sizes"].push_back(to_json(s));
  for (const GroupSource& g : m.groups) j["groups"].push_back(to_json(g));
  return j;
}
ModelSource model_in(const json& j) {
  ModelSource m{.name = j.at("name"), .unit = j.at("unit")};
  for (const json& p : j.at("parameters")) m.parameters.push_back(parameter_in(p));
  for (const json& f : j.at("features")) m.features.push_back(feature_in(f));
  if (j.contains("sizes"))
    for (const json& s : j.at("sizes")) m.sizes.push_back(size_in(s));
  if (j.contains("groups"))
    for (const json& g : j.at("groups")) m.groups.push_back(group_in(g));
  return m;
}

json to_json(const Sizing& s) {
  json j{{"edges_per_circle", s.edges_per_circle}, {"layers", s.layers}, {"growth", s.growth}};
  if (s.min_size) j["min_size"] = *s.min_size;
  return j;
}
Sizing sizing_in(const json& j) {
  Sizing s{.even = false};
  read_number(j, "edges_per_circle", s.edges_per_circle);
  read_number(j, "layers", s.layers);
  j.at("growth").get_to(s.growth);
  if (j.contains("min_size")) s.min_size = j.at("min_size").get<double>();
  return s;
}

json to_json(const MeshOptions& o) {
  json j{{"iterations", o.iterations}, {"seed", o.seed},       {"inside", o.inside},
         {"start", o.start},           {"rebuild", o.rebuild}, {"clean_up", o.clean_up},
         {"threshold", o.threshold}};
  if (o.nodes) j["nodes"] = *o.nodes;
  if (o.size) j["size"] = *o.size;
  if (o.order != 1) j["order"] = o.order;
  if (o.hold != 0) j["hold"] = o.hold;
  if (!o.sizing.even) j["sizing"] = to_json(o.sizing);
  return j;
}
MeshOptions options_in(const json& j) {
  MeshOptions o;
  if (j.contains("nodes")) o.nodes = whole_number<std::uint32_t>(j.at("nodes"));
  if (j.contains("size")) o.size = j.at("size").get<double>();
  read_number(j, "iterations", o.iterations);
  read_number(j, "seed", o.seed);
  o.inside = MeshOptions::Inside{whole_number<std::uint8_t>(j.at("inside"))};
  o.start = MeshOptions::Start{whole_number<std::uint8_t>(j.at("start"))};
  j.at("rebuild").get_to(o.rebuild);
  j.at("clean_up").get_to(o.clean_up);
  j.at("threshold").get_to(o.threshold);
  if (j.contains("order")) o.order = whole_number<std::uint32_t>(j.at("order"));
  if (j.contains("hold")) o.hold = j.at("hold").get<double>();
  o.sizing = j.contains("sizing") ? sizing_in(j.at("sizing")) : Sizing{.even = true};
  return o;
}

}  // namespace

std::vector<Recipe::Digest> digests_of(const HeldRevision& held, const HeldRevision* alike) {
  std::vector<Recipe::Digest> digests;
  const std::vector<MeshArray> arrays = mesh_arrays(held.revision.output);
  const auto others = alike ? mesh_arrays(alike->revision.output) : std::vector<MeshArray>();
  for (const MeshArray& array : arrays) {
    const auto other = std::ranges::find(others, array.name, &MeshArray::name);
    digests.push_back({array.name, other != others.end()
                                       ? held.digests.of(array, *other, alike->digests)
                                       : held.digests.of(array)});
  }
  return digests;
}

Recipe recipe_of(const HeldRevision& held, const HeldRevision* alike) {
  if (!held.asked) return {};
  return {.revision = held.record.id,
          .parent = held.record.parent,
          .algorithm_version = held.record.algorithm_version,
          .model = held.revision.source,
          .edit = held.edit,
          .options = *held.asked,
          .digests = digests_of(held, alike)};
}

std::string write_recipe(const Recipe& recipe) {
  json digests = json::array();
  for (const Recipe::Digest& digest : recipe.digests)
    digests.push_back(json::array({static_cast<int>(digest.array), digest.digest}));
  return json{{"format", kFormat},
              {"revision", recipe.revision},
              {"parent", recipe.parent},
              {"algorithm_version", recipe.algorithm_version},
              {"model", to_json(recipe.model)},
              {"edit", recipe.edit},
              {"options", to_json(recipe.options)},
              {"digests", std::move(digests)}}
      .dump();
}

Recipe read_recipe(const std::string& text) {
  try {
    const json j = json::parse(text);
    if (j.at("format") != kFormat) throw error::internal("store", "a recipe of another format");
    Recipe recipe{.revision = j.at("revision"),
                  .parent = j.at("parent"),
                  .algorithm_version = whole_number<std::uint32_t>(j.at("algorithm_version")),
                  .model = model_in(j.at("model")),
                  .edit = j.at("edit"),
                  .options = options_in(j.at("options"))};
    for (const json& digest : j.at("digests"))
      recipe.digests.push_back({ArrayName{whole_number<std::uint8_t>(digest.at(0))}, digest.at(1)});
    return recipe;
  } catch (const json::exception& failure) {
    throw error::internal("store", std::string("a recipe cannot be read: ") + failure.what());
  }
}

}  // namespace remeshd

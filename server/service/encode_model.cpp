#include "server/service/encode_model.h"

#include <utility>

#include "engine/model/feature_types.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using google::protobuf::Value;

void put(const Scalar& scalar, Value& out) {
  if (const auto* number = std::get_if<double>(&scalar)) {
    out.set_number_value(*number);
  } else {
    out.set_string_value(std::get<std::string>(scalar));
  }
}

template <typename Scalars, typename Add>
void put_all(const Scalars& scalars, Add&& add) {
  for (const Scalar& scalar : scalars) put(scalar, *add());
}

void put_point(const Scalar& x, const Scalar& y, Value& out) {
  auto& values = *out.mutable_list_value();
  put(x, *values.add_values());
  put(y, *values.add_values());
}

void put_profile(const std::vector<ProfileEntry>& profile, Value& out) {
  auto& list = *out.mutable_list_value();
  for (const ProfileEntry& entry : profile) {
    Value& value = *list.add_values();
    if (entry.through) {
      auto& fields = *value.mutable_struct_value()->mutable_fields();
      put_point(entry.x, entry.y, fields["to"]);
      put_point((*entry.through)[0], (*entry.through)[1], fields["through"]);
    } else {
      put_point(entry.x, entry.y, value);
    }
  }
}

Value& add_parameter(const std::string& name, v1::Feature& out) {
  v1::FeatureParameter& parameter = *out.add_parameters();
  parameter.set_name(name);
  return *parameter.mutable_value();
}

/// Puts parameters in the order of the type's table, then those that it lacks, by name.
void put_parameters(const FeatureSource& source, v1::Feature& out) {
  auto left = source.parameters;
  bool profile_left = source.profile.has_value();
  if (const FeatureTypeInfo* type = find_feature_type(source.type)) {
    for (const ParameterInfo& info : type->parameters) {
      if (const auto found = left.find(info.name); found != left.end()) {
        put(found->second, add_parameter(info.name, out));
        left.erase(found);
      } else if (info.name == "profile" && std::exchange(profile_left, false)) {
        put_profile(*source.profile, add_parameter("profile", out));
      }
    }
  }
  for (const auto& [name, value] : left) put(value, add_parameter(name, out));
  if (profile_left) put_profile(*source.profile, add_parameter("profile", out));
}

void put_parameter(const ParameterSource& source, v1::Parameter& out) {
  out.set_name(source.name);
  put(source.value, *out.mutable_value());
  if (source.lower) out.set_lower(*source.lower);
  if (source.upper) out.set_upper(*source.upper);
  out.set_integer(source.integer);
  out.set_unit(source.unit);
  out.set_description(source.description);
}

void put_feature(const FeatureSource& source, v1::Feature& out) {
  out.set_id(source.id);
  out.set_nature(source.nature == Nature::Additive ? v1::Feature::ADDITIVE
                                                   : v1::Feature::SUBTRACTIVE);
  out.set_type(source.type);
  put_parameters(source, out);
  v1::Placement& placement = *out.mutable_placement();
  put_all(source.placement.origin, [&] { return placement.add_origin(); });
  if (source.placement.z_axis)
    put_all(*source.placement.z_axis, [&] { return placement.add_z_axis(); });
  if (source.placement.x_axis)
    put_all(*source.placement.x_axis, [&] { return placement.add_x_axis(); });
  if (const auto* kind = std::get_if<ReferenceKind>(&source.reference)) {
    if (*kind == ReferenceKind::Centre) out.set_reference(v1::Feature::CENTRE);
  } else {
    auto& point = *out.mutable_reference_point();
    put_all(std::get<std::array<Scalar, 3>>(source.reference), [&] { return point.add_values(); });
  }
}

void put_size(const SizeControlSource& source, v1::SizeControl& out) {
  out.set_id(source.id);
  if (const auto* on = std::get_if<std::string>(&source.place)) {
    out.set_on(*on);
  } else if (const auto* ball = std::get_if<BallSource>(&source.place)) {
    auto& values = *out.mutable_region()->mutable_ball();
    put_all(*ball, [&] { return values.add_values(); });
  } else {
    auto& values = *out.mutable_region()->mutable_box();
    put_all(std::get<BoxSource>(source.place), [&] { return values.add_values(); });
  }
  put(source.size, *out.mutable_size());
}

void put_group(const GroupSource& source, v1::Group& out) {
  out.set_name(source.name);
  out.set_on(source.on);
  if (source.policy == GroupPolicy{}) return;
  v1::GroupPolicy& policy = *out.mutable_policy();
  if (source.policy.max_area_change) policy.set_max_area_change(*source.policy.max_area_change);
  policy.set_on_emptied(source.policy.fail_emptied ? "fail" : "warn");
}

}  // namespace

v1::FeatureModel encode(const ModelSource& source) {
  v1::FeatureModel out;
  out.set_name(source.name);
  out.set_unit(source.unit);
  for (const ParameterSource& parameter : source.parameters)
    put_parameter(parameter, *out.add_parameters());
  for (const FeatureSource& feature : source.features) put_feature(feature, *out.add_features());
  for (const SizeControlSource& size : source.sizes) put_size(size, *out.add_sizes());
  for (const GroupSource& group : source.groups) put_group(group, *out.add_groups());
  return out;
}

}  // namespace remeshd

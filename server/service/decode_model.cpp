#include "server/service/decode_model.h"

#include <optional>
#include <utility>

#include "engine/base/error.h"
#include "server/service/decode_value.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

PlacementSource placement(const v1::Placement& message, const DocumentPlace& place) {
  PlacementSource out;
  if (message.origin_size() > 0) out.origin = triple_of(message.origin(), below(place, "origin"));
  if (message.z_axis_size() > 0) out.z_axis = triple_of(message.z_axis(), below(place, "zAxis"));
  if (message.x_axis_size() > 0) out.x_axis = triple_of(message.x_axis(), below(place, "xAxis"));
  return out;
}

Nature nature(v1::Feature::Nature value, const DocumentPlace& place) {
  switch (value) {
    case v1::Feature::ADDITIVE:
      return Nature::Additive;
    case v1::Feature::SUBTRACTIVE:
      return Nature::Subtractive;
    default:
      throw error::wrong_kind(place, "ADDITIVE or SUBTRACTIVE",
                              "the enumerator " + std::to_string(value));
  }
}

ReferenceSource reference(const v1::Feature& message, const DocumentPlace& place) {
  if (message.has_reference_point())
    return triple_of(message.reference_point().values(), below(place, "referencePoint"));
  switch (message.reference()) {
    case v1::Feature::REFERENCE_UNSPECIFIED:
    case v1::Feature::ORIGIN:
      return ReferenceKind::Origin;
    case v1::Feature::CENTRE:
      return ReferenceKind::Centre;
    default:
      throw error::wrong_kind(below(place, "reference"), "ORIGIN or CENTRE",
                              "the enumerator " + std::to_string(message.reference()));
  }
}

DocumentError twice(const std::string& feature, const std::string& parameter) {
  DocumentErrorInfo info;
  info.reason = "DUPLICATE_PARAMETER";
  info.message = "feature '" + feature + "' has the parameter '" + parameter + "' twice";
  info.feature = feature;
  info.parameter = parameter;
  return DocumentError(std::move(info));
}

FeatureSource feature(const v1::Feature& message, DocumentPlace place, const std::string& path) {
  // A feature without an id can only be told by where it stands.
  place.path = message.id().empty() ? path : "";
  place.feature = message.id();
  FeatureSource out;
  out.id = text_of(message.id(), below(place, "id"));
  out.nature = nature(message.nature(), below(place, "nature"));
  out.type = text_of(message.type(), below(place, "type"));
  for (const v1::FeatureParameter& parameter : message.parameters()) {
    const std::string& name = text_of(parameter.name(), place);
    const DocumentPlace here = below(place, name);
    if (out.parameters.contains(name) || (name == "profile" && out.profile))
      throw twice(message.id(), name);
    if (name == "profile") {
      out.profile = profile_of(parameter.value(), here);
    } else {
      out.parameters[name] = scalar_of(parameter.value(), here);
    }
  }
  out.placement = placement(message.placement(), below(place, "placement"));
  out.reference = reference(message, place);
  return out;
}

std::optional<SizePlaceSource> size_place(const v1::SizeControl& message,
                                          const DocumentPlace& place) {
  switch (message.place_case()) {
    case v1::SizeControl::kOn:
      return text_of(message.on(), below(place, "on"));
    case v1::SizeControl::kRegion:
      if (message.region().has_ball())
        return ball_of(message.region().ball(), below(place, "in.ball"));
      if (message.region().has_box()) return box_of(message.region().box(), below(place, "in.box"));
      throw error::missing_field(below(place, "in"), "box");
    default:
      return std::nullopt;
  }
}

SizeControlSource size(const v1::SizeControl& message, const DocumentPlace& place) {
  const auto where = size_place(message, place);
  if (!where) throw error::missing_field(place, "in");
  if (!message.has_size()) throw error::missing_field(place, "size");
  return {.id = text_of(message.id(), below(place, "id")),
          .place = *where,
          .size = scalar_of(message.size(), below(place, "size"))};
}

SetSize set_size(const v1::SizeControl& message, const DocumentPlace& place) {
  SetSize out{.id = text_of(message.id(), below(place, "id")), .place = size_place(message, place)};
  if (message.has_size()) out.size = scalar_of(message.size(), below(place, "size"));
  return out;
}

GroupPolicy policy(const v1::GroupPolicy& message, const DocumentPlace& place) {
  GroupPolicy out;
  if (message.has_max_area_change()) out.max_area_change = message.max_area_change();
  const std::string& on_emptied = message.on_emptied();
  if (!on_emptied.empty() && on_emptied != "warn" && on_emptied != "fail")
    throw error::wrong_kind(below(place, "onEmptied"), "\"warn\" or \"fail\"", "another string");
  out.fail_emptied = on_emptied == "fail";
  return out;
}

GroupSource group(const v1::Group& message, const DocumentPlace& place) {
  if (message.on().empty()) throw error::missing_field(place, "on");
  return {.name = text_of(message.name(), place),
          .on = text_of(message.on(), below(place, "on")),
          .policy = policy(message.policy(), below(place, "policy"))};
}

SetGroup set_group(const v1::Group& message, const DocumentPlace& place) {
  SetGroup out{.name = text_of(message.name(), below(place, "name"))};
  if (!message.on().empty()) out.on = text_of(message.on(), below(place, "on"));
  if (message.has_policy()) out.policy = policy(message.policy(), below(place, "policy"));
  return out;
}

Edit edit(const v1::Edit& message, DocumentPlace place) {
  switch (message.edit_case()) {
    case v1::Edit::kSetParameter: {
      const auto& set = message.set_parameter();
      return SetParameter{text_of(set.name(), place),
                          scalar_of(set.value(), below(place, set.name()))};
    }
    case v1::Edit::kSetFeatureParameter: {
      const auto& set = message.set_feature_parameter();
      place.feature = text_of(set.feature(), place);
      SetFeatureParameter out{set.feature(), text_of(set.name(), place), 0.0};
      const DocumentPlace here = below(place, set.name());
      if (set.name() == "profile") {
        out.value = profile_of(set.value(), here);
      } else {
        out.value = scalar_of(set.value(), here);
      }
      return out;
    }
    case v1::Edit::kSetPlacement: {
      const auto& set = message.set_placement();
      place.feature = text_of(set.feature(), place);
      if (!set.has_placement()) throw error::missing_field(place, "placement");
      return SetPlacement{set.feature(), placement(set.placement(), below(place, "placement"))};
    }
    case v1::Edit::kAddFeature: {
      const auto& add = message.add_feature();
      if (!add.has_feature()) throw error::missing_field(place, "feature");
      return AddFeature{feature(add.feature(), place, "feature"), text_of(add.after(), place)};
    }
    case v1::Edit::kRemoveFeature:
      return RemoveFeature{text_of(message.remove_feature().feature(), place)};
    case v1::Edit::kSetSize:
      return set_size(message.set_size(), place);
    case v1::Edit::kRemoveSize:
      return RemoveSize{text_of(message.remove_size().id(), place)};
    case v1::Edit::kSetGroup:
      return set_group(message.set_group(), place);
    case v1::Edit::kRemoveGroup:
      return RemoveGroup{text_of(message.remove_group().name(), place)};
    default:
      throw error::wrong_kind(place, "a kind of edit", "none");
  }
}

ParameterSource parameter(const v1::Parameter& message) {
  const DocumentPlace parameters{.feature = "", .path = "parameters"};
  ParameterSource out;
  out.name = text_of(message.name(), parameters);
  const DocumentPlace place = below(parameters, out.name);
  out.value = scalar_of(message.value(), place);
  if (message.has_lower()) out.lower = message.lower();
  if (message.has_upper()) out.upper = message.upper();
  out.integer = message.integer();
  out.unit = text_of(message.unit(), below(place, "unit"));
  out.description = text_of(message.description(), below(place, "description"));
  return out;
}

ModelSource model(const v1::FeatureModel& message) {
  ModelSource out;
  out.name = text_of(message.name(), {.feature = "", .path = "name"});
  out.unit = text_of(message.unit(), {.feature = "", .path = "unit"});
  for (const v1::Parameter& each : message.parameters()) out.parameters.push_back(parameter(each));
  for (int i = 0; i < message.features_size(); ++i)
    out.features.push_back(feature(message.features(i), {}, "features[" + std::to_string(i) + "]"));
  for (int i = 0; i < message.sizes_size(); ++i)
    out.sizes.push_back(
        size(message.sizes(i), {.feature = "", .path = "sizes[" + std::to_string(i) + "]"}));
  for (const v1::Group& each : message.groups())
    out.groups.push_back(group(each, {.feature = "", .path = "groups." + each.name()}));
  return out;
}

ModelEdit edits(const v1::ModelEdit& message) {
  if (message.edits().empty()) throw error::no_edits({});
  ModelEdit out;
  for (int i = 0; i < message.edits_size(); ++i)
    out.edits.push_back(edit(message.edits(i), {.feature = "", .path = "", .edit_index = i}));
  return out;
}

}  // namespace

Error to_error(const DocumentErrorInfo& info) {
  ErrorInfo out;
  out.kind = ErrorKind::InvalidArgument;
  out.reason = info.reason;
  out.message = info.message;
  out.stage = "document";
  if (!info.feature.empty()) out.features.push_back(info.feature);
  out.parameter = info.parameter;
  out.hint = info.hint;
  out.edit_index = info.edit_index;
  if (info.at.line > 0) {
    out.line = static_cast<int>(info.at.line);
    out.column = static_cast<int>(info.at.column);
  }
  return Error(std::move(out));
}

ModelSource decode(const v1::FeatureModel& message) {
  return checked([&] { return model(message); });
}

ModelEdit decode(const v1::ModelEdit& message) {
  return checked([&] { return edits(message); });
}

}  // namespace remeshd

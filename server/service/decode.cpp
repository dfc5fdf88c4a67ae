#include "server/service/decode.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "proto/document_error.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using google::protobuf::Value;
using Values = google::protobuf::RepeatedPtrField<Value>;

const char* kind_of(const Value& value) {
  switch (value.kind_case()) {
    case Value::kNullValue:
      return "null";
    case Value::kNumberValue:
      return "a number";
    case Value::kStringValue:
      return "a string";
    case Value::kBoolValue:
      return "true or false";
    case Value::kStructValue:
      return "an object";
    case Value::kListValue:
      return "a list";
    default:
      return "nothing";
  }
}

DocumentPlace below(DocumentPlace place, const std::string& path) {
  place.path += (place.path.empty() ? "" : ".") + path;
  return place;
}
DocumentPlace entry(DocumentPlace place, int index) {
  place.path += '[' + std::to_string(index) + ']';
  return place;
}

const std::string& text_of(const std::string& text, const DocumentPlace& place) {
  if (text.find('\0') != std::string::npos)
    throw error::wrong_kind(place, "a text", "one with a NUL character");
  return text;
}

Scalar scalar(const Value& value, const DocumentPlace& place) {
  if (value.kind_case() == Value::kStringValue) return text_of(value.string_value(), place);
  if (value.kind_case() != Value::kNumberValue)
    throw error::wrong_kind(place, "a number or an expression", kind_of(value));
  if (!std::isfinite(value.number_value())) throw error::not_finite(place);
  return value.number_value();
}

template <std::size_t N>
std::array<Scalar, N> tuple(const Values& values, const DocumentPlace& place) {
  if (values.size() != static_cast<int>(N))
    throw error::wrong_kind(place, std::to_string(N) + " values", std::to_string(values.size()));
  std::array<Scalar, N> out;
  for (std::size_t i = 0; i < N; ++i) {
    const int index = static_cast<int>(i);
    out[i] = scalar(values[index], entry(place, index));
  }
  return out;
}

std::array<Scalar, 2> point(const Value& value, const DocumentPlace& place) {
  if (value.kind_case() != Value::kListValue)
    throw error::wrong_kind(place, "a point [x, y]", kind_of(value));
  return tuple<2>(value.list_value().values(), place);
}

ProfileEntry profile_entry(const Value& value, const DocumentPlace& place) {
  ProfileEntry out;
  if (value.kind_case() == Value::kStructValue) {
    const auto& fields = value.struct_value().fields();
    for (const char* name : {"to", "through"})
      if (!fields.contains(name)) throw error::missing_field(place, name);
    if (fields.size() > 2) {
      // Of several unknown ones the first by name, so that the error is always the same.
      std::string unknown;
      for (const auto& [name, field] : fields)
        if (name != "to" && name != "through" && (unknown.empty() || name < unknown))
          unknown = name;
      throw error::unknown_field(place, unknown, "to, through");
    }
    const auto to = point(fields.at("to"), below(place, "to"));
    out.x = to[0];
    out.y = to[1];
    out.through = point(fields.at("through"), below(place, "through"));
    return out;
  }
  if (value.kind_case() != Value::kListValue)
    throw error::wrong_kind(place, "a point [x, y] or an arc {\"to\", \"through\"}",
                            kind_of(value));
  const auto to = point(value, place);
  out.x = to[0];
  out.y = to[1];
  return out;
}

std::vector<ProfileEntry> profile(const Value& value, const DocumentPlace& place) {
  if (value.kind_case() != Value::kListValue)
    throw error::wrong_kind(place, "a list of points and arcs", kind_of(value));
  std::vector<ProfileEntry> out;
  const Values& values = value.list_value().values();
  for (int i = 0; i < values.size(); ++i) out.push_back(profile_entry(values[i], entry(place, i)));
  return out;
}

PlacementSource placement(const v1::Placement& message, const DocumentPlace& place) {
  PlacementSource out;
  if (message.origin_size() > 0) out.origin = tuple<3>(message.origin(), below(place, "origin"));
  if (message.z_axis_size() > 0) out.z_axis = tuple<3>(message.z_axis(), below(place, "zAxis"));
  if (message.x_axis_size() > 0) out.x_axis = tuple<3>(message.x_axis(), below(place, "xAxis"));
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
    return tuple<3>(message.reference_point().values(), below(place, "referencePoint"));
  switch (message.reference()) {
    case v1::Feature::ORIGIN:
      return ReferenceKind::Origin;
    case v1::Feature::CENTRE:
      return ReferenceKind::Centre;
    default:
      throw error::wrong_kind(below(place, "reference"), "ORIGIN or CENTRE",
                              "the enumerator " + std::to_string(message.reference()));
  }
}

/// The entries of a map by name: the first mistake reported is always the same one.
template <typename Map>
std::map<std::string, const Value*> sorted(const Map& values) {
  std::map<std::string, const Value*> out;
  for (const auto& [name, value] : values) out[name] = &value;
  return out;
}

FeatureSource feature(const v1::Feature& message, DocumentPlace place, const std::string& path) {
  // A feature without an id can only be told by where it stands.
  place.path = message.id().empty() ? path : "";
  place.feature = message.id();
  FeatureSource out;
  out.id = text_of(message.id(), below(place, "id"));
  out.nature = nature(message.nature(), below(place, "nature"));
  out.type = text_of(message.type(), below(place, "type"));
  for (const auto& [name, value] : sorted(message.parameters())) {
    const DocumentPlace here = below(place, text_of(name, place));
    if (name == "profile") {
      out.profile = profile(*value, here);
    } else {
      out.parameters[name] = scalar(*value, here);
    }
  }
  out.placement = placement(message.placement(), below(place, "placement"));
  out.reference = reference(message, place);
  return out;
}

Edit edit(const v1::Edit& message, DocumentPlace place) {
  switch (message.edit_case()) {
    case v1::Edit::kSetParameter: {
      const auto& set = message.set_parameter();
      return SetParameter{text_of(set.name(), place),
                          scalar(set.value(), below(place, set.name()))};
    }
    case v1::Edit::kSetFeatureParameter: {
      const auto& set = message.set_feature_parameter();
      place.feature = text_of(set.feature(), place);
      SetFeatureParameter out{set.feature(), text_of(set.name(), place), 0.0};
      const DocumentPlace here = below(place, set.name());
      if (set.name() == "profile") {
        out.value = profile(set.value(), here);
      } else {
        out.value = scalar(set.value(), here);
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
    default:
      throw error::wrong_kind(place, "a kind of edit", "none");
  }
}

ModelSource model(const v1::FeatureModel& message) {
  ModelSource out;
  out.name = text_of(message.name(), {.feature = "", .path = "name"});
  out.unit = text_of(message.unit(), {.feature = "", .path = "unit"});
  for (const auto& [name, value] : sorted(message.parameters()))
    out.parameters[text_of(name, {.feature = "", .path = "parameters"})] =
        scalar(*value, {.feature = "", .path = "parameters." + name});
  for (int i = 0; i < message.features_size(); ++i)
    out.features.push_back(feature(message.features(i), {}, "features[" + std::to_string(i) + "]"));
  return out;
}

ModelEdit edits(const v1::ModelEdit& message) {
  ModelEdit out;
  for (int i = 0; i < message.edits_size(); ++i)
    out.edits.push_back(edit(message.edits(i), {.feature = "", .path = "", .edit_index = i}));
  return out;
}

/// What `read` makes; what it finds wrong comes out as an Error of the server.
template <typename Read>
auto checked(Read read) {
  try {
    return read();
  } catch (const DocumentError& failure) {
    const DocumentErrorInfo& info = failure.info();
    throw Error({.kind = ErrorKind::InvalidArgument,
                 .reason = info.reason,
                 .message = info.message,
                 .stage = "document",
                 .feature = info.feature,
                 .parameter = info.parameter,
                 .hint = info.hint,
                 .edit_index = info.edit_index});
  }
}

int threads(std::uint32_t wanted) {
  constexpr std::uint32_t kMost = std::numeric_limits<int>::max();
  return static_cast<int>(std::min(wanted, kMost));
}

}  // namespace

ModelSource decode(const v1::FeatureModel& message) {
  return checked([&] { return model(message); });
}

ModelEdit decode(const v1::ModelEdit& message) {
  return checked([&] { return edits(message); });
}

OptionsPatch decode(const v1::MeshOptions& message) {
  OptionsPatch out;
  if (message.target_case() == v1::MeshOptions::kNodes) out.nodes = message.nodes();
  if (message.target_case() == v1::MeshOptions::kSize) out.size = message.size();
  if (message.has_iterations()) out.iterations = message.iterations();
  if (message.has_seed()) out.seed = message.seed();
  switch (message.inside()) {
    case v1::INSIDE_TEST_UNSPECIFIED:
      break;
    case v1::INSIDE_TEST_MEMBERSHIP:
      out.inside = MeshOptions::Inside::Membership;
      break;
    case v1::INSIDE_TEST_CONTROL_MESH:
      out.inside = MeshOptions::Inside::ControlMesh;
      break;
    default:
      throw error::option_invalid("inside", "is no known enumerator");
  }
  switch (message.start()) {
    case v1::START_UNSPECIFIED:
      break;
    case v1::START_LATTICE:
      out.start = MeshOptions::Start::Lattice;
      break;
    case v1::START_RANDOM:
      out.start = MeshOptions::Start::Random;
      break;
    default:
      throw error::option_invalid("start", "is no known enumerator");
  }
  if (message.has_clean_up()) out.clean_up = message.clean_up();
  if (message.has_threshold()) out.threshold = message.threshold();
  return out;
}

HeadRule decode(const v1::HeadUpdate& message) {
  HeadRule out;
  if (message.has_advance()) out.advance = message.advance();
  out.expected = message.expected();
  return out;
}

CreateCommand decode(const v1::CreateRevisionRequest& message) {
  checked([&] {
    if (!message.has_model()) throw error::missing_field({}, "model");
  });
  return {.source = decode(message.model()),
          .options = decode(message.options()),
          .design = message.design(),
          .head = decode(message.head()),
          .threads = threads(message.threads())};
}

EditCommand decode(const v1::EditRevisionRequest& message) {
  checked([&] {
    if (!message.has_edit()) throw error::missing_field({}, "edit");
  });
  return {.base = message.base(),
          .edit = decode(message.edit()),
          .options = decode(message.options()),
          .design = message.design(),
          .head = decode(message.head()),
          .threads = threads(message.threads())};
}

ComparisonSide decode(const v1::ModelChoice& message, const char* side) {
  switch (message.choice_case()) {
    case v1::ModelChoice::kRevision:
      return message.revision();
    case v1::ModelChoice::kModel:
      return decode(message.model());
    case v1::ModelChoice::kEdit:
      return decode(message.edit());
    default:
      throw error::side_invalid(side, "is missing");
  }
}

}  // namespace remeshd

#include "server/service/decode_value.h"

#include <cmath>

namespace remeshd {
namespace {

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

template <std::size_t N>
std::array<Scalar, N> tuple(const Values& values, const DocumentPlace& place) {
  if (values.size() != static_cast<int>(N))
    throw error::wrong_kind(place, std::to_string(N) + " values", std::to_string(values.size()));
  std::array<Scalar, N> out;
  for (std::size_t i = 0; i < N; ++i) {
    const int index = static_cast<int>(i);
    out[i] = scalar_of(values[index], entry(place, index));
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

}  // namespace

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

Scalar scalar_of(const Value& value, const DocumentPlace& place) {
  if (value.kind_case() == Value::kStringValue) return text_of(value.string_value(), place);
  if (value.kind_case() != Value::kNumberValue)
    throw error::wrong_kind(place, "a number or an expression", kind_of(value));
  if (!std::isfinite(value.number_value())) throw error::not_finite(place);
  return value.number_value() + 0.0;  // -0 becomes 0, as in documents
}

std::array<Scalar, 3> triple_of(const Values& values, const DocumentPlace& place) {
  return tuple<3>(values, place);
}

BallSource ball_of(const google::protobuf::ListValue& values, const DocumentPlace& place) {
  return tuple<4>(values.values(), place);
}

BoxSource box_of(const google::protobuf::ListValue& values, const DocumentPlace& place) {
  return tuple<6>(values.values(), place);
}

std::vector<ProfileEntry> profile_of(const Value& value, const DocumentPlace& place) {
  if (value.kind_case() != Value::kListValue)
    throw error::wrong_kind(place, "a list of points and arcs", kind_of(value));
  std::vector<ProfileEntry> out;
  const Values& values = value.list_value().values();
  for (int i = 0; i < values.size(); ++i) out.push_back(profile_entry(values[i], entry(place, i)));
  return out;
}

}  // namespace remeshd

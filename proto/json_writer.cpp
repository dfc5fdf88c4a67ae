// SPDX-License-Identifier: Apache-2.0
#include "proto/json_writer.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/time_util.h>

#include <charconv>
#include <cmath>
#include <map>
#include <vector>

namespace remeshd {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::ListValue;
using google::protobuf::Message;
using google::protobuf::Reflection;
using google::protobuf::Struct;
using google::protobuf::Timestamp;
using google::protobuf::Value;

struct Item;

/// A piece of output whose layout is still open: a token, or brackets round items.
struct Piece {
  std::string token;  ///< a scalar, or the opening bracket
  bool brackets = false;
  std::vector<Item> items;
};
struct Item {
  std::string label;  ///< `"name": `, or empty
  Piece piece;
};

std::string quote(const std::string& text) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (byte < 0x20 || byte == 0x7F) {
      out += "\\u00";
      out += kHex[byte >> 4U];
      out += kHex[byte & 15U];
    } else {
      out += c;
    }
  }
  return out + '"';
}

template <typename Number>
std::string digits(Number number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number).ptr;
  return {text, end};
}

/// Zero has no sign: a document would be read again as another.
std::string real(double number) { return std::isfinite(number) ? digits(number + 0.0) : "null"; }

Piece token(std::string text) { return {std::move(text), false, {}}; }

Piece value_piece(const Value& value);

Piece list_piece(const ListValue& list) {
  Piece piece{"[", true, {}};
  for (const Value& item : list.values()) piece.items.push_back({"", value_piece(item)});
  return piece;
}

Piece struct_piece(const Struct& fields) {
  std::map<std::string, const Value*> sorted;
  for (const auto& [name, value] : fields.fields()) sorted[name] = &value;
  Piece piece{"{", true, {}};
  for (const auto& [name, value] : sorted)
    piece.items.push_back({quote(name) + ": ", value_piece(*value)});
  return piece;
}

Piece value_piece(const Value& value) {
  switch (value.kind_case()) {
    case Value::kNumberValue:
      return token(real(value.number_value()));
    case Value::kStringValue:
      return token(quote(value.string_value()));
    case Value::kBoolValue:
      return token(value.bool_value() ? "true" : "false");
    case Value::kListValue:
      return list_piece(value.list_value());
    case Value::kStructValue:
      return struct_piece(value.struct_value());
    default:
      return token("null");
  }
}

Piece message_piece(const Message& message, const JsonStyle& style);

/// One value of a field: the whole field, or the entry `index` of a repeated one.
Piece field_piece(const Message& message, const FieldDescriptor* field, int index,
                  const JsonStyle& style) {
  const Reflection* r = message.GetReflection();
  const bool many = field->is_repeated();
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return token(
          digits(many ? r->GetRepeatedInt32(message, field, index) : r->GetInt32(message, field)));
    case FieldDescriptor::CPPTYPE_INT64:
      return token(
          digits(many ? r->GetRepeatedInt64(message, field, index) : r->GetInt64(message, field)));
    case FieldDescriptor::CPPTYPE_UINT32:
      return token(digits(many ? r->GetRepeatedUInt32(message, field, index)
                               : r->GetUInt32(message, field)));
    case FieldDescriptor::CPPTYPE_UINT64:
      return token(digits(many ? r->GetRepeatedUInt64(message, field, index)
                               : r->GetUInt64(message, field)));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return token(
          real(many ? r->GetRepeatedDouble(message, field, index) : r->GetDouble(message, field)));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return token(
          real(many ? r->GetRepeatedFloat(message, field, index) : r->GetFloat(message, field)));
    case FieldDescriptor::CPPTYPE_BOOL:
      return token((many ? r->GetRepeatedBool(message, field, index) : r->GetBool(message, field))
                       ? "true"
                       : "false");
    case FieldDescriptor::CPPTYPE_ENUM:
      return token(quote(
          (many ? r->GetRepeatedEnum(message, field, index) : r->GetEnum(message, field))->name()));
    case FieldDescriptor::CPPTYPE_STRING:
      return token(
          quote(many ? r->GetRepeatedString(message, field, index) : r->GetString(message, field)));
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return message_piece(
          many ? r->GetRepeatedMessage(message, field, index) : r->GetMessage(message, field),
          style);
  }
  return token("null");
}

Piece map_piece(const Message& message, const FieldDescriptor* field, const JsonStyle& style) {
  const Reflection* r = message.GetReflection();
  const FieldDescriptor* key = field->message_type()->map_key();
  const FieldDescriptor* value = field->message_type()->map_value();
  std::map<std::string, Piece> sorted;
  for (int i = 0; i < r->FieldSize(message, field); ++i) {
    const Message& item = r->GetRepeatedMessage(message, field, i);
    sorted[item.GetReflection()->GetString(item, key)] = field_piece(item, value, 0, style);
  }
  Piece piece{"{", true, {}};
  for (auto& [name, item] : sorted) piece.items.push_back({quote(name) + ": ", std::move(item)});
  return piece;
}

/// The field that an element of a keyed list is written as where it has no other beside its name;
/// null for messages that are not written by name.
const FieldDescriptor* sole_field(const google::protobuf::Descriptor* element) {
  const std::string& type = element->full_name();
  if (type == "remesh.v1.Parameter" || type == "remesh.v1.FeatureParameter")
    return element->FindFieldByName("value");
  return type == "remesh.v1.Group" ? element->FindFieldByName("on") : nullptr;
}

/// A list of things that have names, as an object.
Piece keyed_piece(const Message& message, const FieldDescriptor* list, const JsonStyle& style) {
  const FieldDescriptor* name = list->message_type()->FindFieldByName("name");
  const FieldDescriptor* sole = sole_field(list->message_type());
  const std::string sole_label = quote(sole->json_name()) + ": ";
  Piece piece{"{", true, {}};
  for (int i = 0; i < message.GetReflection()->FieldSize(message, list); ++i) {
    const Message& element = message.GetReflection()->GetRepeatedMessage(message, list, i);
    Piece value = message_piece(element, style);
    const std::string name_label = quote(name->json_name()) + ": ";
    std::erase_if(value.items, [&](const Item& item) { return item.label == name_label; });
    if (value.items.size() == 1 && value.items.front().label == sole_label) {
      Piece alone = std::move(value.items.front().piece);
      value = std::move(alone);
    }
    const std::string label = quote(element.GetReflection()->GetString(element, name)) + ": ";
    piece.items.push_back({label, std::move(value)});
  }
  return piece;
}

/// Whether a field is an enumeration's that was set to nothing in particular, which documents have
/// no word for.
bool is_unspecified(const Message& message, const FieldDescriptor* field) {
  return !field->is_repeated() && field->cpp_type() == FieldDescriptor::CPPTYPE_ENUM &&
         message.GetReflection()->GetEnumValue(message, field) == 0;
}

Piece message_piece(const Message& message, const JsonStyle& style) {
  if (const auto* value = dynamic_cast<const Value*>(&message)) return value_piece(*value);
  if (const auto* list = dynamic_cast<const ListValue*>(&message)) return list_piece(*list);
  if (const auto* fields = dynamic_cast<const Struct*>(&message)) return struct_piece(*fields);
  if (const auto* time = dynamic_cast<const Timestamp*>(&message))
    return token(quote(google::protobuf::util::TimeUtil::ToString(*time)));

  const Reflection* r = message.GetReflection();
  Piece piece{"{", true, {}};
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor* field = message.GetDescriptor()->field(i);
    const bool empty =
        field->is_repeated() ? r->FieldSize(message, field) == 0 : !r->HasField(message, field);
    if (empty && (!style.write_zeros || field->has_presence())) continue;
    if (style.short_forms && is_unspecified(message, field)) continue;
    const std::string label = quote(style.camel_case ? field->json_name() : field->name()) + ": ";
    if (field->is_map()) {
      piece.items.push_back({label, map_piece(message, field, style)});
    } else if (style.short_forms && field->is_repeated() && field->message_type() != nullptr &&
               sole_field(field->message_type()) != nullptr) {
      piece.items.push_back({label, keyed_piece(message, field, style)});
    } else if (field->is_repeated()) {
      Piece list{"[", true, {}};
      for (int k = 0; k < r->FieldSize(message, field); ++k)
        list.items.push_back({"", field_piece(message, field, k, style)});
      piece.items.push_back({label, std::move(list)});
    } else {
      piece.items.push_back({label, field_piece(message, field, 0, style)});
    }
  }
  return piece;
}

/// Appends the piece on one line unless that passes `room` columns. Returns false and appends
/// nothing then.
bool write_flat(const Piece& piece, std::size_t room, std::string& out) {
  const std::size_t start = out.size();
  out += piece.token;
  for (std::size_t i = 0; i < piece.items.size(); ++i) {
    if (i > 0) out += ", ";
    out += piece.items[i].label;
    const std::size_t used = out.size() - start;
    if (used >= room || !write_flat(piece.items[i].piece, room - used, out)) {
      out.resize(start);
      return false;
    }
  }
  if (piece.brackets) out += piece.token == "[" ? ']' : '}';
  if (out.size() - start <= room) return true;
  out.resize(start);
  return false;
}

void write(const Piece& piece, std::size_t indent, std::size_t column, std::size_t width,
           std::string& out) {
  // 1 column is kept for the comma that may follow.
  if (column + 1 < width && write_flat(piece, width - column - 1, out)) return;
  out += piece.token;
  if (!piece.brackets) return;
  for (std::size_t i = 0; i < piece.items.size(); ++i) {
    out += '\n';
    out.append(indent + 2, ' ');
    out += piece.items[i].label;
    write(piece.items[i].piece, indent + 2, indent + 2 + piece.items[i].label.size(), width, out);
    if (i + 1 < piece.items.size()) out += ',';
  }
  if (!piece.items.empty()) {
    out += '\n';
    out.append(indent, ' ');
  }
  out += piece.token == "[" ? ']' : '}';
}

}  // namespace

std::string write_json(const Message& message, const JsonStyle& style) {
  const Piece piece = message_piece(message, style);
  std::string out = piece.token;
  // The outermost object is always opened out: one field a line.
  for (std::size_t i = 0; i < piece.items.size(); ++i) {
    out += "\n  " + piece.items[i].label;
    write(piece.items[i].piece, 2, 2 + piece.items[i].label.size(),
          static_cast<std::size_t>(style.width), out);
    if (i + 1 < piece.items.size()) out += ',';
  }
  if (!piece.items.empty()) out += '\n';
  return out + "}\n";
}

std::string write_document(const Message& message) {
  return write_json(message, {.camel_case = true, .write_zeros = false, .short_forms = true});
}

}  // namespace remeshd

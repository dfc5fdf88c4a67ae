// SPDX-License-Identifier: Apache-2.0
#include "proto/document_model.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

/// `4`, `"wall / 2"` or `{"value": 4, "lower": 1}`.
void read_parameter(const Entry& entry, v1::Parameter& out) {
  if (!entry.is_object()) return entry.scalar(*out.mutable_value());
  entry.require({"value"});
  entry.fields({{"value", [&](const Entry& e) { e.scalar(*out.mutable_value()); }},
                {"lower", [&](const Entry& e) { out.set_lower(e.number()); }},
                {"upper", [&](const Entry& e) { out.set_upper(e.number()); }},
                {"integer", [&](const Entry& e) { out.set_integer(e.boolean()); }},
                {"unit", Entry::into(out.mutable_unit())},
                {"description", Entry::into(out.mutable_description())}});
}

/// `"hole*.wall"` or `{"on": "hole*.wall", "policy": {...}}`.
void read_group(const Entry& entry, v1::Group& out) {
  if (entry.is_text()) {
    out.set_on(entry.text());
    return;
  }
  if (!entry.is_object()) throw entry.wrong_kind("a selector or an object", entry.kind());
  entry.require({"on"});
  entry.fields({{"on", Entry::into(out.mutable_on())},
                {"policy", [&](const Entry& e) { read_policy(e, *out.mutable_policy()); }}});
}

void read_region(const Entry& entry, v1::Region& out) {
  entry.exclude("ball", "box");
  if (!entry.find("ball")) entry.require({"box"});
  entry.fields({{"ball",
                 [&](const Entry& e) {
                   auto& values = *out.mutable_ball();
                   e.scalars(4, [&] { return values.add_values(); });
                 }},
                {"box", [&](const Entry& e) {
                   auto& values = *out.mutable_box();
                   e.scalars(6, [&] { return values.add_values(); });
                 }}});
}

void read_feature_parameters(const Entry& entry, v1::Feature& out) {
  entry.members([&](const std::string& name, const Entry& e) {
    v1::FeatureParameter& parameter = *out.add_parameters();
    parameter.set_name(name);
    // Its name is all the place that the reader of an error needs.
    const bool known = !e.place().feature.empty();
    (known ? e.at_path(name) : e).value(*parameter.mutable_value());
  });
}

}  // namespace

void read_placement(const Entry& entry, v1::Placement& out) {
  const auto triple = [](auto add) { return [add](const Entry& e) { e.scalars(3, add); }; };
  entry.fields({{"origin", triple([&] { return out.add_origin(); })},
                {"zAxis", triple([&] { return out.add_z_axis(); })},
                {"xAxis", triple([&] { return out.add_x_axis(); })}});
}

void read_feature(const Entry& feature, v1::Feature& out) {
  const auto id = feature.find("id");
  const Entry entry = id && id->is_text() ? feature.of_feature(id->text()) : feature;
  entry.require({"id", "nature", "type"});
  entry.exclude("reference", "referencePoint");
  entry.fields(
      {{"id", Entry::into(out.mutable_id())},
       {"nature",
        [&](const Entry& e) {
          out.set_nature(e.choice<v1::Feature::Nature>(
              "\"ADDITIVE\" or \"SUBTRACTIVE\"",
              {{"ADDITIVE", v1::Feature::ADDITIVE}, {"SUBTRACTIVE", v1::Feature::SUBTRACTIVE}}));
        }},
       {"type", Entry::into(out.mutable_type())},
       {"parameters", [&](const Entry& e) { read_feature_parameters(e, out); }},
       {"placement", [&](const Entry& e) { read_placement(e, *out.mutable_placement()); }},
       {"reference",
        [&](const Entry& e) {
          out.set_reference(e.choice<v1::Feature::Reference>(
              "\"ORIGIN\" or \"CENTRE\"",
              {{"ORIGIN", v1::Feature::ORIGIN}, {"CENTRE", v1::Feature::CENTRE}}));
        }},
       {"referencePoint", [&](const Entry& e) {
          auto& point = *out.mutable_reference_point();
          e.scalars(3, [&] { return point.add_values(); });
        }}});
}

void read_size(const Entry& entry, v1::SizeControl& out) {
  entry.require({"id"});
  entry.exclude("on", "in");
  entry.fields({{"id", Entry::into(out.mutable_id())},
                {"on", [&](const Entry& e) { out.set_on(e.text()); }},
                {"in", [&](const Entry& e) { read_region(e, *out.mutable_region()); }},
                {"size", [&](const Entry& e) { e.scalar(*out.mutable_size()); }}});
}

void read_policy(const Entry& entry, v1::GroupPolicy& out) {
  entry.fields({{"maxAreaChange", [&](const Entry& e) { out.set_max_area_change(e.number()); }},
                {"onEmptied", Entry::into(out.mutable_on_emptied())}});
}

void read_model(const Entry& entry, v1::FeatureModel& out) {
  entry.require({"features"});
  entry.fields({{"name", Entry::into(out.mutable_name())},
                {"unit", Entry::into(out.mutable_unit())},
                {"parameters",
                 [&](const Entry& e) {
                   e.members([&](const std::string& name, const Entry& parameter) {
                     v1::Parameter& added = *out.add_parameters();
                     added.set_name(name);
                     read_parameter(parameter, added);
                   });
                 }},
                {"features",
                 [&](const Entry& e) {
                   e.each(
                       [&](const Entry& feature) { read_feature(feature, *out.add_features()); });
                 }},
                {"sizes",
                 [&](const Entry& e) {
                   e.each([&](const Entry& size) {
                     if (!size.find("on")) size.require({"in"});
                     size.require({"size"});
                     read_size(size, *out.add_sizes());
                   });
                 }},
                {"groups", [&](const Entry& e) {
                   e.members([&](const std::string& name, const Entry& group) {
                     v1::Group& added = *out.add_groups();
                     added.set_name(name);
                     read_group(group, added);
                   });
                 }}});
}

}  // namespace remeshd

// SPDX-License-Identifier: Apache-2.0
#include "proto/document_edit.h"

#include "proto/document_model.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

/// What an edit is about is named before its fields are read, for the sake of their errors.
Entry about_feature(const Entry& entry) {
  const auto id = entry.find("feature");
  return entry.of_feature(id && id->is_text() ? id->text() : "");
}

void read_set_parameter(const Entry& entry, v1::SetParameter& out) {
  entry.require({"name", "value"});
  entry.fields({{"name", Entry::into(out.mutable_name())},
                {"value", [&](const Entry& e) { e.scalar(*out.mutable_value()); }}});
}

void read_set_feature_parameter(const Entry& entry, v1::SetFeatureParameter& out) {
  entry.require({"feature", "name", "value"});
  about_feature(entry).fields({{"feature", Entry::into(out.mutable_feature())},
                               {"name", Entry::into(out.mutable_name())},
                               {"value", [&](const Entry& e) { e.value(*out.mutable_value()); }}});
}

void read_set_placement(const Entry& entry, v1::SetPlacement& out) {
  entry.require({"feature", "placement"});
  about_feature(entry).fields(
      {{"feature", Entry::into(out.mutable_feature())},
       {"placement", [&](const Entry& e) { read_placement(e, *out.mutable_placement()); }}});
}

void read_add_feature(const Entry& entry, v1::AddFeature& out) {
  entry.require({"feature"});
  entry.fields({{"feature", [&](const Entry& e) { read_feature(e, *out.mutable_feature()); }},
                {"after", Entry::into(out.mutable_after())}});
}

void read_set_group(const Entry& entry, v1::Group& out) {
  entry.require({"name"});
  entry.fields({{"name", Entry::into(out.mutable_name())},
                {"on", Entry::into(out.mutable_on())},
                {"policy", [&](const Entry& e) { read_policy(e, *out.mutable_policy()); }}});
}

/// An edit that says no more than what is to go.
void read_removal(const Entry& entry, std::string_view field, std::string* out) {
  entry.require({field});
  entry.fields({{field, Entry::into(out)}});
}

void read_edit(const Entry& entry, v1::Edit& out) {
  int kinds = 0;
  entry.members([&](const std::string&, const Entry&) { ++kinds; });
  if (kinds != 1)
    throw entry.wrong_kind("an object with one kind of edit", std::to_string(kinds) + " fields");
  entry.fields(
      {{"setParameter",
        [&](const Entry& e) { read_set_parameter(e, *out.mutable_set_parameter()); }},
       {"setFeatureParameter",
        [&](const Entry& e) {
          read_set_feature_parameter(e, *out.mutable_set_feature_parameter());
        }},
       {"setPlacement",
        [&](const Entry& e) { read_set_placement(e, *out.mutable_set_placement()); }},
       {"addFeature", [&](const Entry& e) { read_add_feature(e, *out.mutable_add_feature()); }},
       {"removeFeature",
        [&](const Entry& e) {
          read_removal(about_feature(e), "feature",
                       out.mutable_remove_feature()->mutable_feature());
        }},
       {"setSize", [&](const Entry& e) { read_size(e, *out.mutable_set_size()); }},
       {"removeSize",
        [&](const Entry& e) { read_removal(e, "id", out.mutable_remove_size()->mutable_id()); }},
       {"setGroup", [&](const Entry& e) { read_set_group(e, *out.mutable_set_group()); }},
       {"removeGroup", [&](const Entry& e) {
          read_removal(e, "name", out.mutable_remove_group()->mutable_name());
        }}});
}

}  // namespace

void read_edits(const Entry& entry, v1::ModelEdit& out) {
  entry.require({"edits"});
  entry.fields({{"edits", [&](const Entry& edits) {
                   edits.each([&](const Entry& edit) {
                     const Entry numbered = edit.of_edit(out.edits_size());
                     read_edit(numbered, *out.add_edits());
                   });
                   if (out.edits().empty()) throw error::no_edits(edits.place().at);
                 }}});
}

}  // namespace remeshd

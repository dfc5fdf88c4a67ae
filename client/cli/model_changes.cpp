#include "client/cli/model_changes.h"

#include <google/protobuf/util/message_differencer.h>

#include <algorithm>
#include <unordered_map>

#include "client/cli/table.h"

namespace remeshd::cli {
namespace {

using google::protobuf::Value;
using google::protobuf::util::MessageDifferencer;
using remesh::v1::Feature;
using remesh::v1::FeatureModel;
using remesh::v1::FeatureParameter;
using remesh::v1::Group;
using remesh::v1::Parameter;
using remesh::v1::SizeControl;
using Words = std::vector<std::string>;

template <class Message>
bool is_same(const Message& a, const Message& b) {
  return MessageDifferencer::Equals(a, b);
}

const std::string& key_of(const Parameter& p) { return p.name(); }
const std::string& key_of(const FeatureParameter& p) { return p.name(); }
const std::string& key_of(const Feature& f) { return f.id(); }
const std::string& key_of(const SizeControl& s) { return s.id(); }
const std::string& key_of(const Group& g) { return g.name(); }

/// Adds the items that came or went, of a list whose items have names; calls `changed` for those in
/// both that differ.
template <class List, class Changed>
void compare(const List& before, const List& after, const std::string& prefix, Words& words,
             const Changed& changed) {
  std::unordered_map<std::string, const typename List::value_type*> then;
  for (const auto& item : before) then.emplace(key_of(item), &item);
  for (const auto& item : after) {
    const auto was = then.find(key_of(item));
    if (was == then.end()) {
      words.push_back("+ " + prefix + key_of(item));
    } else {
      if (!is_same(*was->second, item)) changed(*was->second, item);
      then.erase(was);
    }
  }
  for (const auto& item : before)
    if (then.contains(key_of(item))) words.push_back("- " + prefix + key_of(item));
}

/// A number or an expression; nothing for a profile.
std::string text_of(const Value& value) {
  if (value.has_number_value()) return exact(value.number_value());
  return value.string_value();
}

std::string change_of(const std::string& name, const Value& before, const Value& after) {
  if (is_same(before, after)) return name + " changed";  // something else than its value
  const std::string was = text_of(before), is = text_of(after);
  if (was.empty() || is.empty()) return name + " changed";
  return name + " " + was + " -> " + is;
}

/// A feature without its parameters and placement, whose changes are told separately.
Feature rest_of(Feature feature) {
  feature.clear_parameters();
  feature.clear_placement();
  return feature;
}

void compare_features(const Feature& before, const Feature& after, Words& words) {
  const std::string& id = after.id();
  if (!is_same(rest_of(before), rest_of(after))) words.push_back(id + " changed");
  compare(before.parameters(), after.parameters(), id + ".", words,
          [&](const FeatureParameter& was, const FeatureParameter& is) {
            words.push_back(change_of(id + "." + is.name(), was.value(), is.value()));
          });
  if (!is_same(before.placement(), after.placement())) words.push_back(id + " moved");
}

void compare_sizes(const SizeControl& before, const SizeControl& after, Words& words) {
  const std::string name = "size " + after.id();
  if (!is_same(before.size(), after.size()))
    words.push_back(change_of(name, before.size(), after.size()));
  if (before.on() != after.on() && before.has_on() && after.has_on())
    words.push_back(name + " on " + before.on() + " -> " + after.on());
  else if (!is_same(before.region(), after.region()))
    words.push_back(name + " at another place");
}

/// Whether features that are in both models come in another order.
bool is_reordered(const FeatureModel& before, const FeatureModel& after) {
  const auto common = [](const FeatureModel& of, const FeatureModel& with) {
    std::vector<std::string> ids;
    for (const Feature& feature : of.features())
      if (std::ranges::any_of(with.features(),
                              [&](const Feature& other) { return other.id() == feature.id(); }))
        ids.push_back(feature.id());
    return ids;
  };
  return common(before, after) != common(after, before);
}

}  // namespace

std::vector<std::string> model_changes(const FeatureModel& before, const FeatureModel& after) {
  Words words;
  compare(before.parameters(), after.parameters(), "", words,
          [&](const Parameter& was, const Parameter& is) {
            words.push_back(change_of(is.name(), was.value(), is.value()));
          });
  compare(before.features(), after.features(), "", words,
          [&](const Feature& was, const Feature& is) { compare_features(was, is, words); });
  if (is_reordered(before, after)) words.emplace_back("order of features changed");
  compare(before.sizes(), after.sizes(), "size ", words,
          [&](const SizeControl& was, const SizeControl& is) { compare_sizes(was, is, words); });
  compare(before.groups(), after.groups(), "group ", words, [&](const Group&, const Group& is) {
    words.push_back("group " + is.name() + " changed");
  });
  return words;
}

std::string changes_in_words(const FeatureModel& before, const FeatureModel& after) {
  std::string text;
  for (const std::string& change : model_changes(before, after))
    text += (text.empty() ? "" : ", ") + change;
  return text.empty() ? "same model" : text;
}

}  // namespace remeshd::cli

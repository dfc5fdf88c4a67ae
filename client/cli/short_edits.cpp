#include "client/cli/short_edits.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "client/cli/exit_code.h"

namespace remeshd::cli {
namespace {

/// The number that the whole text is; nothing where it is none, or not finite.
std::optional<double> number_in(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return {};
  return number;
}

}  // namespace

void add_set_parameter(remesh::v1::ModelEdit& edit, const std::string& name,
                       google::protobuf::Value value) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) {
    auto* set = edit.add_edits()->mutable_set_parameter();
    set->set_name(name);
    *set->mutable_value() = std::move(value);
  } else {
    auto* set = edit.add_edits()->mutable_set_feature_parameter();
    set->set_feature(name.substr(0, dot));
    set->set_name(name.substr(dot + 1));
    *set->mutable_value() = std::move(value);
  }
}

void add_assignment(remesh::v1::ModelEdit& edit, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == assignment.size())
    throw UsageError("--set " + assignment + ": wanted is parameter=value or " +
                     "feature.parameter=value");
  const std::string text = assignment.substr(equals + 1);
  google::protobuf::Value value;
  if (const auto number = number_in(text))
    value.set_number_value(*number);
  else
    value.set_string_value(text);
  add_set_parameter(edit, assignment.substr(0, equals), std::move(value));
}

}  // namespace remeshd::cli

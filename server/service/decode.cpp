#include "server/service/decode.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "proto/json_writer.h"
#include "server/service/located.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

int threads(std::uint32_t wanted) {
  constexpr std::uint32_t kMost = std::numeric_limits<int>::max();
  return static_cast<int>(std::min(wanted, kMost));
}

ModelSource model_of_document(const std::string& text, const DocumentLimits& limits) {
  return located(text, [&] { return decode(checked([&] { return parse_model(text, limits); })); });
}

Locate locate_in(const std::string& document) {
  if (document.empty()) return {};
  return [document](ErrorInfo& error) { add_place(error, document); };
}

/// The model of any request that has it as a message or as text.
template <typename Request>
ModelSource model_of(const Request& request, const DocumentLimits& limits) {
  switch (request.model_choice_case()) {
    case Request::kModel:
      return decode(request.model());
    case Request::kDocument:
      return model_of_document(request.document(), limits);
    default:
      throw to_error(error::missing_field({}, "model").info());
  }
}

/// The edit, as a message, of any request that has it as a message or as text.
template <typename Request>
v1::ModelEdit edit_of(const Request& request, const DocumentLimits& limits) {
  switch (request.edit_choice_case()) {
    case Request::kEdit:
      return request.edit();
    case Request::kDocument:
      return checked([&] { return parse_edit(request.document(), limits); });
    default:
      throw to_error(error::missing_field({}, "edit").info());
  }
}

std::optional<MeshOptions::Inside> inside_of(v1::InsideTest inside) {
  switch (inside) {
    case v1::INSIDE_TEST_UNSPECIFIED:
      return std::nullopt;
    case v1::INSIDE_TEST_MEMBERSHIP:
      return MeshOptions::Inside::Membership;
    case v1::INSIDE_TEST_CONTROL_MESH:
      return MeshOptions::Inside::ControlMesh;
    default:
      throw error::option_invalid("inside", "is no known enumerator");
  }
}

std::optional<MeshOptions::Start> start_of(v1::Start start) {
  switch (start) {
    case v1::START_UNSPECIFIED:
      return std::nullopt;
    case v1::START_LATTICE:
      return MeshOptions::Start::Lattice;
    case v1::START_RANDOM:
      return MeshOptions::Start::Random;
    default:
      throw error::option_invalid("start", "is no known enumerator");
  }
}

SizingPatch decode(const v1::Sizing& message) {
  SizingPatch out;
  if (message.has_even()) out.even = message.even();
  if (message.has_edges_per_circle()) out.edges_per_circle = message.edges_per_circle();
  if (message.has_layers()) out.layers = message.layers();
  if (message.has_min_size()) out.min_size = message.min_size();
  if (message.has_growth()) out.growth = message.growth();
  return out;
}

}  // namespace

std::vector<WarningCode> fail_on_of(const v1::MeshOptions& message) {
  std::vector<WarningCode> out;
  for (const int code : message.fail_on()) {
    if (!v1::Warning::Code_IsValid(code) || code == v1::Warning::CODE_UNSPECIFIED)
      throw error::option_invalid("fail_on", "names no warning");
    out.push_back(static_cast<WarningCode>(code - 1));
  }
  return out;
}

OptionsPatch decode(const v1::MeshOptions& message) {
  fail_on_of(message);
  OptionsPatch out;
  if (message.target_case() == v1::MeshOptions::kNodes) out.nodes = message.nodes();
  if (message.target_case() == v1::MeshOptions::kSize) out.size = message.size();
  if (message.has_iterations()) out.iterations = message.iterations();
  if (message.has_seed()) out.seed = message.seed();
  if (message.has_clean_up()) out.clean_up = message.clean_up();
  if (message.has_threshold()) out.threshold = message.threshold();
  if (message.has_order()) out.order = message.order();
  if (message.has_hold()) out.hold = message.hold();
  out.inside = inside_of(message.inside());
  out.start = start_of(message.start());
  out.sizing = decode(message.sizing());
  return out;
}

HeadRule decode(const v1::HeadUpdate& message) {
  HeadRule out;
  if (message.has_advance()) out.advance = message.advance();
  out.expected = message.expected();
  out.require = message.require();
  if (message.has_file()) out.file = message.file();
  return out;
}

CreateCommand decode(const v1::CreateRevisionRequest& message, const DocumentLimits& limits) {
  return {.source = model_of(message, limits),
          .options = decode(message.options()),
          .design = message.design(),
          .head = decode(message.head()),
          .fail_on = fail_on_of(message.options()),
          .threads = threads(message.threads()),
          .locate = locate_in(message.document())};
}

EditCommand decode(const v1::EditRevisionRequest& message, const DocumentLimits& limits) {
  const v1::ModelEdit edit = edit_of(message, limits);
  return {.base = message.base(),
          .edit = located(message.document(), [&] { return decode(edit); }),
          .document = write_document(edit),
          .options = decode(message.options()),
          .design = message.design(),
          .head = decode(message.head()),
          .fail_on = fail_on_of(message.options()),
          .threads = threads(message.threads()),
          .locate = locate_in(message.document())};
}

ComparisonSide decode(const v1::ModelChoice& message, const char* side,
                      const DocumentLimits& limits) {
  switch (message.choice_case()) {
    case v1::ModelChoice::kRevision:
      return message.revision();
    case v1::ModelChoice::kModel:
      return decode(message.model());
    case v1::ModelChoice::kEdit:
      return decode(message.edit());
    case v1::ModelChoice::kDocument:
      return std::visit([](const auto& document) { return ComparisonSide(decode(document)); },
                        checked([&] { return parse_document(message.document(), limits); }));
    default:
      throw error::side_invalid(side, "is missing");
  }
}

ModelSource decode(const v1::ValidateModelRequest& message, const DocumentLimits& limits) {
  return model_of(message, limits);
}

EditToValidate decode(const v1::ValidateEditRequest& message, const DocumentLimits& limits) {
  EditToValidate out{.base = message.base(), .edit = located(message.document(), [&] {
                                               return decode(edit_of(message, limits));
                                             })};
  if (message.has_base_model()) out.base = decode(message.base_model());
  if (message.has_base_document()) out.base = model_of_document(message.base_document(), limits);
  return out;
}

}  // namespace remeshd

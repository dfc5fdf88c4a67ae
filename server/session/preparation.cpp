#include "server/session/preparation.h"

#include <algorithm>
#include <utility>

#include "server/session/mesh_options.h"
#include "server/session/revision_id.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

/// Whether the rule asks that a head be moved or checked.
bool concerns_head(const HeadRule& rule) {
  return rule.advance.value_or(false) || rule.require || !rule.expected.empty();
}

/// Refuses a rule that files in no design and asks for what only a design has. `design`: that the
/// command names.
void check_unfiled(const HeadRule& rule, const std::string& design) {
  if (!design.empty())
    throw error::option_invalid("head.file", "is false, so that a design cannot be named");
  if (concerns_head(rule))
    throw error::option_invalid("head.file", "is false, and a revision in no design moves no head");
}

}  // namespace

std::optional<EditBase> Preparation::base_of(const Command& command) const {
  const auto* edit = std::get_if<EditCommand>(&command);
  if (edit == nullptr) return std::nullopt;
  if (edit->base.empty()) throw error::reference_missing("base");
  const Reference reference = archive_.resolve(edit->base);
  if (edit->head.file == false) {
    check_unfiled(edit->head, edit->design);
    return EditBase{.id = reference.id, .design = ""};
  }
  EditBase base{.id = reference.id,
                .design = edit->design.empty() ? reference.design : edit->design};
  if (base.design.empty()) base.design = archive_.design_of(base.id, edit->last_design);
  if (!base.design.empty()) {
    check_design_name(base.design);
    archive_.check_home(base.design);
  } else if (edit->head.file.value_or(false) || concerns_head(edit->head)) {
    throw error::field_missing("design", "the base is in none");
  }
  return base;
}

Prepared Preparation::prepare(const Command& command, const std::optional<EditBase>& base,
                              const HeldRevisionPtr& revision, std::stop_token stop) const {
  const Run run{.stop = std::move(stop), .on_progress = {}, .dumps = {}, .max_nodes = max_nodes_};
  try {
    if (const auto* create = std::get_if<CreateCommand>(&command))
      return prepare_create(*create, run);
    return prepare_edit(std::get<EditCommand>(command), *base, revision, run);
  } catch (Error& failure) {
    std::visit(
        [&](const auto& c) {
          if (c.locate) c.locate(failure.info());
        },
        command);
    throw;
  }
}

Prepared Preparation::prepare_create(const CreateCommand& command, const Run& run) const {
  Prepared prepared;
  prepared.options = first_options(command.options);
  std::string design = command.design.empty() ? command.source.name : command.design;
  if (design.empty()) design = "model";
  // Where the request names no design, and the home of this one is elsewhere, it is filed in none.
  const bool file =
      !command.design.empty() || concerns_head(command.head) || archive_.is_home_of(design);
  if (command.head.file.value_or(file)) {
    check_design_name(design);
    archive_.check_home(design);
    prepared.design = design;
  } else {
    check_unfiled(command.head, command.design);
  }
  prepared.nodes =
      engine_.check_node_limit(nullptr, engine_.evaluate(command.source), prepared.options, run);
  prepared.source = command.source;
  prepared.head = command.head;
  prepared.fail_on = command.fail_on;
  prepared.threads = std::clamp(command.threads, 1, threads_);
  prepared.id = revision_id(prepared.source, prepared.options, "", engine_.algorithm_version);
  return prepared;
}

Prepared Preparation::prepare_edit(const EditCommand& command, const EditBase& base,
                                   const HeldRevisionPtr& revision, const Run& run) const {
  run.poll();  // reading the base takes a while
  Prepared prepared;
  prepared.design = base.design;
  prepared.base = revision;
  const Revision& original = prepared.base->revision;
  prepared.edit = command.document;
  EvaluatedModel edited = engine_.evaluate_edited(original.source, command.edit);
  prepared.options = edit_options(command.options, original.options);
  prepared.nodes = engine_.check_node_limit(&original, edited.model, prepared.options, run);
  prepared.source = std::move(edited.source);
  prepared.head = command.head;
  if (prepared.head.expected.empty()) prepared.head.expected = base.id;
  prepared.fail_on = command.fail_on;
  prepared.threads = std::clamp(command.threads, 1, threads_);
  prepared.id = revision_id(prepared.source, prepared.options, base.id, engine_.algorithm_version);
  return prepared;
}

RevisionRecord Preparation::record_of(const Prepared& prepared) const {
  RevisionRecord record{.id = prepared.id,
                        .root = prepared.id,
                        .model_name = prepared.source.name,
                        .model = model_digest(prepared.source),
                        .algorithm_version = engine_.algorithm_version};
  if (prepared.base) {
    record.parent = prepared.base->record.id;
    record.root = prepared.base->record.root;
  }
  return record;
}

}  // namespace remeshd

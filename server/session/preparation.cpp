#include "server/session/preparation.h"

#include <algorithm>
#include <utility>

#include "server/session/mesh_options.h"
#include "server/session/revision_id.h"
#include "server/session/session_error.h"

namespace remeshd {

std::optional<EditBase> Preparation::base_of(const Command& command) const {
  const auto* edit = std::get_if<EditCommand>(&command);
  if (edit == nullptr) return std::nullopt;
  if (edit->base.empty()) throw error::reference_missing("base");
  const Reference reference = archive_.resolve(edit->base);
  EditBase base{.id = reference.id,
                .design = edit->design.empty() ? reference.design : edit->design};
  if (base.design.empty()) {
    const auto places =
        archive_.store().read([&](Catalogue& catalogue) { return catalogue.places(base.id); });
    if (!places.empty()) base.design = places.front().design;
  }
  check_design_name(base.design);
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
  prepared.design = command.design.empty() ? command.source.name : command.design;
  if (prepared.design.empty()) prepared.design = "model";
  check_design_name(prepared.design);
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
  prepared.source = engine_.apply(original.source, command.edit);
  prepared.options = edit_options(command.options, original.options);
  prepared.nodes =
      engine_.check_node_limit(&original, engine_.evaluate(prepared.source), prepared.options, run);
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

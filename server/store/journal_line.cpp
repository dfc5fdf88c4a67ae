#include "server/store/journal_line.h"

#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "server/store/checked_line.h"
#include "server/store/json_number.h"
#include "server/store/packed_text.h"

namespace remeshd {
namespace {

using nlohmann::json;

constexpr int kVersion = 2;

struct ToJson {
  json operator()(const AddRevision& op) const {
    const RevisionRecord& r = op.record;
    json j{{"add_revision", r.id},
           {"parent", r.parent},
           {"root", r.root},
           {"model_name", r.model_name},
           {"model", r.model},
           {"algorithm_version", r.algorithm_version},
           {"created_ns", r.created_ns},
           {"nodes", r.nodes},
           {"tets", r.tets},
           {"bytes", r.bytes},
           {"base", r.base},
           {"seconds", r.seconds},
           {"pinned", r.pinned}};
    if (r.mid_nodes > 0) j["mid_nodes"] = r.mid_nodes;
    if (!op.recipe.empty()) j["recipe"] = base64(op.recipe.bytes);
    return j;
  }
  json operator()(const AddPlace& op) const {
    return {{"add_place", op.design}, {"number", op.number}, {"id", op.id}};
  }
  json operator()(const SetHead& op) const { return {{"set_head", op.design}, {"id", op.id}}; }
  json operator()(const RemovePlace& op) const {
    return {{"remove_place", op.design}, {"number", op.number}};
  }
  json operator()(const RemoveRevision& op) const { return {{"remove_revision", op.id}}; }
  json operator()(const AddDesign& op) const {
    return {{"add_design", op.name},
            {"next_number", op.next_number},
            {"changed_ns", op.changed_ns},
            {"listed", op.listed}};
  }
  json operator()(const KeepRecipe& op) const {
    return {{"keep_recipe", op.id}, {"parent", op.parent}, {"recipe", base64(op.recipe.bytes)}};
  }
  json operator()(const DropMesh& op) const { return {{"drop_mesh", op.id}}; }
  json operator()(const SetPin& op) const { return {{"set_pin", op.id}, {"pinned", op.pinned}}; }
  json operator()(const StartAnew&) const { return {{"start_anew", true}}; }
};

/// What the first versions did not write is optional. Throws json::exception for an operation that
/// is not known.
Operation from_json(const json& j) {
  if (j.contains("add_revision")) {
    RevisionRecord r;
    j.at("add_revision").get_to(r.id);
    j.at("parent").get_to(r.parent);
    r.root = j.value("root", r.parent.empty() ? r.id : "");
    j.at("model_name").get_to(r.model_name);
    r.model = j.value("model", "");
    r.algorithm_version = number_or(j, "algorithm_version", 0U);
    read_number(j, "created_ns", r.created_ns);
    read_number(j, "nodes", r.nodes);
    read_number(j, "tets", r.tets);
    r.mid_nodes = number_or(j, "mid_nodes", 0U);
    read_number(j, "bytes", r.bytes);
    r.base = j.value("base", "");
    r.seconds = j.value("seconds", std::vector<double>());
    r.pinned = j.value("pinned", false);
    return AddRevision{r, from_base64(j.value("recipe", ""))};
  }
  if (j.contains("add_place"))
    return AddPlace{j.at("add_place"), whole_number<std::uint32_t>(j.at("number")), j.at("id")};
  if (j.contains("set_head")) return SetHead{j.at("set_head"), j.at("id")};
  if (j.contains("remove_place"))
    return RemovePlace{j.at("remove_place"), whole_number<std::uint32_t>(j.at("number"))};
  if (j.contains("add_design"))
    return AddDesign{j.at("add_design"), whole_number<std::uint32_t>(j.at("next_number")),
                     number_or(j, "changed_ns", std::int64_t{0}), j.value("listed", true)};
  if (j.contains("keep_recipe"))
    return KeepRecipe{j.at("keep_recipe"), j.at("parent"),
                      from_base64(j.at("recipe").get<std::string>())};
  if (j.contains("drop_mesh")) return DropMesh{j.at("drop_mesh")};
  if (j.contains("set_pin")) return SetPin{j.at("set_pin"), j.at("pinned")};
  if (j.contains("start_anew")) return StartAnew{};
  return RemoveRevision{j.at("remove_revision")};
}

}  // namespace

std::string write_journal_line(const JournalLine& line) {
  json operations = json::array();
  for (const Operation& operation : line.transaction)
    operations.push_back(std::visit(ToJson{}, operation));
  return checked_line(
      json{{"version", kVersion}, {"number", line.number}, {"operations", std::move(operations)}}
          .dump());
}

std::optional<JournalLine> read_journal_line(std::string_view line) {
  const auto text = checked_text(line);
  if (!text) return std::nullopt;
  try {
    const json content = json::parse(*text);
    const bool first_version = content.is_array();
    if (!first_version && content.at("version") != kVersion) return std::nullopt;
    JournalLine out;
    if (!first_version) read_number(content, "number", out.number);
    for (const json& operation : first_version ? content : content.at("operations"))
      out.transaction.push_back(from_json(operation));
    return out;
  } catch (const json::exception&) {
    return std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace remeshd

#include "server/store/pack_head.h"

#include <nlohmann/json.hpp>

#include "server/store/checked_line.h"
#include "server/store/json_number.h"
#include "server/store/store_format.h"

namespace remeshd {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "remeshd-pack";
// The first layout's line is bare JSON.
constexpr const char* kFirstFormat = "remeshd-revision-1";

struct Line {
  json content;
  std::size_t size = 0;
  bool checked = false;
};

std::optional<Line> read_line(std::string_view start) {
  const std::size_t end = start.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const auto text = checked_text(start.substr(0, end));
  Line line{.content = json::parse(text.value_or(start.substr(0, end)), nullptr, false),
            .size = end + 1,
            .checked = text.has_value()};
  if (!line.content.is_object()) return std::nullopt;
  return line;
}

std::optional<int> version_of(const Line& line) {
  try {
    const std::string format = line.content.at("format");
    if (format == kFirstFormat) return 0;
    if (format != kFormat || !line.checked) return std::nullopt;
    return whole_number<int>(line.content.at("store"));
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::string write_pack_head(const PackHead& head) {
  const RevisionRecord& r = head.record;
  json arrays = json::array();
  for (const EncodedArray& a : head.arrays)
    arrays.push_back({{"name", a.name},
                      {"base", a.base},
                      {"type", static_cast<int>(a.type)},
                      {"components", a.components},
                      {"bytes", a.bytes},
                      {"page", a.piece_bytes},
                      {"encoding", static_cast<int>(a.encoding)},
                      {"data", a.data_bytes}});
  json line{{"format", kFormat},
            {"store", kStoreVersion},
            {"id", r.id},
            {"parent", r.parent},
            {"root", r.root},
            {"model_name", r.model_name},
            {"model", r.model},
            {"algorithm_version", r.algorithm_version},
            {"base", r.base},
            {"nodes", r.nodes},
            {"tets", r.tets},
            {"design", head.first.design},
            {"number", head.first.number},
            {"base_content", head.base_content},
            {"chain", head.chain},
            {"chain_bytes", head.chain_bytes},
            {"full_bytes", head.full_bytes},
            {"arrays", std::move(arrays)},
            {"content", head.content},
            {"recipe", head.recipe.size()},
            {"recipe_hash", content_hash(head.recipe)},
            {"data", head.data}};
  if (r.mid_nodes > 0) line["mid_nodes"] = r.mid_nodes;
  return checked_line(line.dump()) + head.recipe;
}

std::optional<PackHead> read_pack_head(std::string_view start) {
  const auto line = read_line(start);
  if (!line) return std::nullopt;
  const auto version = version_of(*line);
  if (!version || *version > kStoreVersion) return std::nullopt;
  try {
    const json& j = line->content;
    PackHead head{.store_version = *version, .size = line->size};
    head.record = {.id = j.at("id"),
                   .parent = j.at("parent"),
                   .root = j.value("root", ""),
                   .model_name = j.at("model_name"),
                   .model = j.value("model", ""),
                   .algorithm_version = number_or(j, "algorithm_version", 0U),
                   .nodes = whole_number<std::uint32_t>(j.at("nodes")),
                   .tets = whole_number<std::uint32_t>(j.at("tets")),
                   .mid_nodes = number_or(j, "mid_nodes", 0U)};
    if (head.record.parent.empty()) head.record.root = head.record.id;
    head.first = {.design = j.at("design"),
                  .number = whole_number<std::uint32_t>(j.at("number")),
                  .id = head.record.id};
    if (*version < kFirstWithArrays) {
      read_number(j, "created_ns", head.record.created_ns);
      if (*version > 0) j.at("sha256").get_to(head.data);
      return head;
    }
    j.at("base").get_to(head.record.base);
    j.at("base_content").get_to(head.base_content);
    read_number(j, "chain", head.chain);
    read_number(j, "chain_bytes", head.chain_bytes);
    read_number(j, "full_bytes", head.full_bytes);
    for (const json& a : j.at("arrays"))
      head.arrays.push_back(
          {.name = a.at("name"),
           .base = a.at("base"),
           .type = StoredType{whole_number<std::uint8_t>(a.at("type"))},
           .components = whole_number<std::uint32_t>(a.at("components")),
           .bytes = whole_number<std::uint64_t>(a.at("bytes")),
           .piece_bytes = whole_number<std::uint64_t>(a.at("page")),
           .encoding = ArrayEncoding{whole_number<std::uint8_t>(a.at("encoding"))},
           .data_bytes = whole_number<std::uint64_t>(a.at("data"))});
    j.at("content").get_to(head.content);
    read_number(j, "recipe", head.recipe_size);
    if (start.size() - line->size >= head.recipe_size) {
      const std::string_view recipe = start.substr(line->size, head.recipe_size);
      if (j.at("recipe_hash") == content_hash(recipe)) head.recipe = recipe;
    }
    j.at("data").get_to(head.data);
    return head;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::optional<std::size_t> size_of_pack_head(std::string_view start) {
  const auto line = read_line(start);
  if (!line || !line->checked) return std::nullopt;
  const auto recipe = line->content.find("recipe");
  if (recipe == line->content.end() || !recipe->is_number_unsigned()) return line->size;
  return line->size + recipe->get<std::size_t>();
}

std::optional<int> store_version_of(std::string_view start) {
  const auto line = read_line(start);
  return line ? version_of(*line) : std::nullopt;
}

}  // namespace remeshd

#include "server/store/pack_head.h"

#include <nlohmann/json.hpp>

#include "server/store/checked_line.h"
#include "server/store/store_format.h"

namespace remeshd {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "remeshd-pack";
// The first layout's line is bare JSON; the hash of the whole file was its name.
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
    return line.content.at("store").get<int>();
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::string write_pack_head(const PackHead& head) {
  const RevisionRecord& r = head.record;
  return checked_line(json{
      {"format", kFormat},
      {"store", kStoreVersion},
      {"id", r.id},
      {"parent", r.parent},
      {"root", r.root},
      {"model_name", r.model_name},
      {"model", r.model},
      {"algorithm_version", r.algorithm_version},
      {"created_ns", r.created_ns},
      {"nodes", r.nodes},
      {"tets", r.tets},
      {"design", head.first.design},
      {"number", head.first.number},
      {"sha256",
       head.sha256}}.dump());
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
                   .algorithm_version = j.value("algorithm_version", 0U),
                   .created_ns = j.at("created_ns"),
                   .nodes = j.at("nodes"),
                   .tets = j.at("tets")};
    if (head.record.parent.empty()) head.record.root = head.record.id;
    head.first = {.design = j.at("design"), .number = j.at("number"), .id = head.record.id};
    if (*version > 0) j.at("sha256").get_to(head.sha256);
    return head;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::optional<int> store_version_of(std::string_view start) {
  const auto line = read_line(start);
  return line ? version_of(*line) : std::nullopt;
}

}  // namespace remeshd

#include "server/store/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <optional>

#include "proto/checksum.h"
#include "server/store/store_error.h"

namespace remeshd {
namespace {

using nlohmann::json;

struct ToJson {
  json operator()(const AddRevision& op) const {
    const RevisionRecord& r = op.record;
    return {{"add_revision", r.id},
            {"parent", r.parent},
            {"model_name", r.model_name},
            {"object", r.object},
            {"created_ns", r.created_ns},
            {"nodes", r.nodes},
            {"tets", r.tets},
            {"bytes", r.bytes}};
  }
  json operator()(const AddPlace& op) const {
    return {{"add_place", op.design}, {"number", op.number}, {"id", op.id}};
  }
  json operator()(const SetHead& op) const { return {{"set_head", op.design}, {"id", op.id}}; }
  json operator()(const RemovePlace& op) const {
    return {{"remove_place", op.design}, {"number", op.number}};
  }
  json operator()(const RemoveRevision& op) const { return {{"remove_revision", op.id}}; }
};

Operation from_json(const json& j) {
  if (j.contains("add_revision")) {
    RevisionRecord r;
    j.at("add_revision").get_to(r.id);
    j.at("parent").get_to(r.parent);
    j.at("model_name").get_to(r.model_name);
    j.at("object").get_to(r.object);
    j.at("created_ns").get_to(r.created_ns);
    j.at("nodes").get_to(r.nodes);
    j.at("tets").get_to(r.tets);
    j.at("bytes").get_to(r.bytes);
    return AddRevision{r};
  }
  if (j.contains("add_place")) return AddPlace{j.at("add_place"), j.at("number"), j.at("id")};
  if (j.contains("set_head")) return SetHead{j.at("set_head"), j.at("id")};
  if (j.contains("remove_place")) return RemovePlace{j.at("remove_place"), j.at("number")};
  return RemoveRevision{j.at("remove_revision")};
}

std::string checksum_text(std::string_view text) {
  const std::uint32_t crc = crc32c(text);
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(crc >> shift & 255U);
  return to_hex(bytes);
}

std::optional<Transaction> parse_line(std::string_view line) {
  if (line.size() < 10 || line[8] != ' ') return std::nullopt;
  const std::string_view text = line.substr(9);
  if (line.substr(0, 8) != checksum_text(text)) return std::nullopt;
  try {
    Transaction transaction;
    for (const json& operation : json::parse(text)) transaction.push_back(from_json(operation));
    return transaction;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

Journal::Journal(std::filesystem::path file)
    : file_(std::move(file)), out_(file_, O_WRONLY | O_CREAT | O_APPEND) {
  const std::string text = read_whole(file_);
  const std::size_t end = text.rfind('\n');
  size_ = end == std::string::npos ? 0 : end + 1;
  if (size_ != text.size() && ::ftruncate(out_.descriptor(), static_cast<off_t>(size_)) != 0)
    throw error::store_failed("mending", file_.string(), errno);
  out_.sync();
  sync_folder(file_.parent_path());
}

void Journal::append(const Transaction& transaction) {
  json operations = json::array();
  for (const Operation& operation : transaction)
    operations.push_back(std::visit(ToJson{}, operation));
  const std::string text = operations.dump();
  const std::string line = checksum_text(text) + " " + text + "\n";
  // A line that a failure left unfinished must not stand before this one.
  if (torn_ && ::ftruncate(out_.descriptor(), static_cast<off_t>(size_)) != 0)
    throw error::store_failed("mending", file_.string(), errno);
  torn_ = true;
  out_.write(line);
  out_.sync();
  torn_ = false;
  size_ += line.size();
  last_mark_ = crc32c(line);
}

std::uint64_t Journal::replay(std::uint64_t from,
                              const std::function<void(const Transaction&)>& visit) const {
  const std::string text = read_whole(file_);
  std::uint64_t bad = 0;
  for (std::size_t start = from, end = 0; start < text.size(); start = end + 1) {
    end = text.find('\n', start);
    if (end == std::string::npos) break;
    const auto transaction = parse_line(std::string_view(text).substr(start, end - start));
    if (transaction) {
      visit(*transaction);
    } else {
      ++bad;
    }
  }
  return bad;
}

std::uint32_t Journal::mark(std::uint64_t end) const {
  if (end == size_ && last_mark_ != 0) return last_mark_;
  const std::string text = read_whole(file_);
  if (end == 0 || end > text.size() || text[end - 1] != '\n') return 0;
  const std::size_t before = end < 2 ? std::string::npos : text.rfind('\n', end - 2);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  return crc32c(std::string_view(text).substr(start, end - start));
}

}  // namespace remeshd

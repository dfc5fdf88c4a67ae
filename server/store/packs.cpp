#include "server/store/packs.h"

#include <algorithm>
#include <chrono>
#include <functional>

#include "engine/base/error.h"
#include "proto/checksum.h"
#include "server/store/files.h"
#include "server/store/side_by_side.h"
#include "server/store/store_error.h"
#include "server/store/store_format.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kFolderDigits = 2;
// Limits on a chain of bases: packs read for a revision's arrays, and bytes of differences per byte
// of the pack without a base. Reading takes 12 ms a megabyte.
constexpr std::uint32_t kMostChain = 64;
constexpr std::uint64_t kMostChainShare = 2;
constexpr std::size_t kMostBytesOfHead = std::size_t{1} << 28;  // with the recipe
// Bytes of arrays from which on threads are worth starting.
constexpr std::size_t kWorthThreads = std::size_t{1} << 18;
constexpr std::size_t kStates = 64;  // of packs that the next edits are likely to be based on

/// Calls `visit` with each entry two levels down and the id that its path spells; also with what is
/// not a folder of such entries, and no id.
template <typename Visit>
void for_each_entry(const fs::path& folder, Visit&& visit) {
  for (const auto& outer : fs::directory_iterator(folder)) {
    const std::string prefix = outer.path().filename().string();
    if (!outer.is_directory() || prefix.size() != kFolderDigits) {
      visit(outer, std::string());
      continue;
    }
    for (const auto& inner : fs::directory_iterator(outer.path()))
      visit(inner, prefix + inner.path().filename().string());
  }
}

}  // namespace

bool is_full_id(std::string_view text) {
  return text.size() == 64 && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

Packs::Packs(fs::path folder, fs::path scratch)
    : folder_(std::move(folder)), scratch_(std::move(scratch)) {}

fs::path Packs::path_of(const std::string& id) const {
  return folder_ / id.substr(0, kFolderDigits) / id.substr(kFolderDigits);
}

Packs::StatePtr Packs::usable_state(const Base& base) {
  const StatePtr state = state_of(base.id);
  if (!state || state->chain >= kMostChain ||
      state->chain_bytes > kMostChainShare * state->full_bytes)
    return nullptr;
  return state;
}

namespace {

/// An array to be written, the base's array that it is encoded against, and the result.
struct Encoding {
  const StoredArray* array = nullptr;
  DecodedArray like;  ///< without a name: none
  EncodedArray encoded;
  PageDepths depths;

  void run() {
    encoded = encode(*array, like.array.name.empty() ? nullptr : &like, depths);
    if (encoded.encoding != ArrayEncoding::Full) encoded.base = like.array.name;
    encoded.data_bytes = encoded.data.size();
  }
};

/// Jobs that encode the arrays, the largest first, so that none is started last and runs on alone.
std::vector<std::function<void()>> jobs_of(std::vector<Encoding>& encodings) {
  std::vector<Encoding*> by_size;
  for (Encoding& encoding : encodings) by_size.push_back(&encoding);
  std::ranges::stable_sort(by_size, std::greater<>(),
                           [](const Encoding* e) { return e->array->size(); });
  std::vector<std::function<void()>> jobs;
  for (Encoding* const encoding : by_size) jobs.emplace_back([encoding] { encoding->run(); });
  return jobs;
}

}  // namespace

Packs::Written Packs::put(const RevisionRecord& record, const PlaceRecord& first,
                          const std::string& recipe, const StoredArrays& arrays, const Base* base) {
  StatePtr before;
  if (base != nullptr && base->id != record.id) before = usable_state(*base);

  std::vector<Encoding> encodings;
  for (const StoredArray& array : arrays.arrays) {
    Encoding& encoding = encodings.emplace_back(Encoding{.array = &array});
    if (!before) continue;
    const StoredArray* found = base->arrays->find(array.name);
    if (found == nullptr && !array.like.empty()) found = base->arrays->find(array.like);
    if (found == nullptr) continue;
    encoding.like.array = *found;
    if (const auto depths = before->depths.find(found->name); depths != before->depths.end())
      encoding.like.depths = depths->second;
  }
  auto after = std::make_shared<State>();
  std::string content_of_base;
  std::vector<std::function<void()>> jobs = jobs_of(encodings);
  jobs.emplace_back([&] { after->content = content_hash(arrays); });
  if (before) jobs.emplace_back([&] { content_of_base = content_hash(*base->arrays); });
  if (arrays.size() < kWorthThreads) {
    for (const auto& job : jobs) job();
  } else {
    do_side_by_side(jobs);
  }
  // The caller's base is not what its pack holds: differences to it could not be decoded.
  if (before && content_of_base != before->content)
    return put(record, first, recipe, arrays, nullptr);

  PackHead head{.record = record, .first = first, .recipe = recipe};
  std::string data;
  bool differs = false;
  for (Encoding& encoding : encodings) {
    differs = differs || encoding.encoded.encoding != ArrayEncoding::Full;
    data += encoding.encoded.data;
    after->depths[encoding.array->name] = std::move(encoding.depths);
    head.arrays.push_back(std::move(encoding.encoded));
  }
  if (!differs) before = nullptr;
  head.content = after->content;
  head.data = content_hash(recipe + data);
  head.record.base = before ? base->id : "";
  head.base_content = before ? before->content : "";
  head.chain = after->chain = before ? before->chain + 1 : 1;
  head.chain_bytes = after->chain_bytes = before ? before->chain_bytes + data.size() : 0;
  head.full_bytes = after->full_bytes = before ? before->full_bytes : data.size();

  const std::string file = write_pack_head(head) + data;
  write(record, file);
  remember(record.id, std::move(after));
  return {.bytes = file.size(), .base = head.record.base};
}

void Packs::write(const RevisionRecord& record, std::string_view file) {
  const fs::path path = path_of(record.id);
  const std::string prefix = record.id.substr(0, kFolderDigits);
  const auto known = [&] {
    const std::scoped_lock lock(mutex_);
    return folders_.contains(prefix);
  };
  std::error_code unsure;
  if (fs::exists(path, unsure) || unsure) {
    write_durably(path, file, scratch_, record.created_ns);
    return;
  }
  std::vector<fs::path> unsynced{path.parent_path()};
  if (!known()) {
    make_unsynced_folder(path.parent_path());
    unsynced.push_back(folder_);
  }
  write_in_place(path, file, record.created_ns, unsynced);
  const std::scoped_lock lock(mutex_);
  folders_.insert(prefix);
}

Packs::File Packs::read_file(const std::string& id) const {
  const fs::path path = path_of(id);
  if (!fs::exists(path)) throw error::store_corrupted(id, "it is gone");
  return checked(id, read_whole(path));
}

Packs::File Packs::checked(const std::string& id, std::string bytes) {
  const auto damaged = [&](const char* what) { return error::store_corrupted(id, what); };
  File file;
  file.bytes = std::move(bytes);
  auto head = read_pack_head(std::string_view(file.bytes).substr(0, kMostHeadBytes));
  if (!head || head->store_version == 0) throw damaged("its head cannot be read");
  if (head->record.id != id) throw damaged("it is another revision");
  if (!head->record.base.empty() && !is_full_id(head->record.base))
    throw damaged("its base is no revision");
  const std::string_view rest = std::string_view(file.bytes).substr(head->size);
  if (rest.size() < head->recipe_size) throw damaged("it is cut off");
  const bool in_one_piece = head->store_version < kFirstWithArrays;
  if ((in_one_piece ? sha256_hex(rest) : content_hash(rest)) != head->data)
    throw damaged("its content does not have its checksum");
  if (in_one_piece)
    head->arrays.push_back({.name = kOlderBytes, .bytes = rest.size(), .data_bytes = rest.size()});
  file.head = std::move(*head);
  return file;
}

std::string Packs::file(const std::string& id) const { return read_file(id).bytes; }

std::optional<PackHead> Packs::head_in(std::string_view file) {
  auto head = read_pack_head(file);
  if (head && head->store_version < kFirstWithArrays) head.reset();
  return head;
}

Packs::Written Packs::take_in(const RevisionRecord& record, std::string_view file) {
  const PackHead given = checked(record.id, std::string(file)).head;
  const std::string& on = given.record.base;
  if (!on.empty()) {
    const auto base = head(on);
    if (!base || base->content != given.base_content)
      throw error::store_corrupted(record.id, "its base is not what it was");
  }
  write(record, file);
  return {.bytes = file.size(), .base = on};
}

bool Packs::is_whole(const std::string& id) const {
  try {
    static_cast<void>(read_file(id));
    return true;
  } catch (const Error& failure) {
    if (failure.info().reason != "STORE_CORRUPTED") throw;
    return false;
  }
}

std::string Packs::fault_of(const std::string& id) const {
  try {
    const PackHead own = read_file(id).head;
    if (own.record.base.empty()) return {};
    const auto base = head(own.record.base);
    return base && base->content == own.base_content ? "" : "the pack that it stands on is damaged";
  } catch (const Error& failure) {
    return failure.info().message;
  }
}

Packs::Decoded Packs::decode_chain(const std::string& id) const {
  std::vector<File> chain{read_file(id)};
  while (!chain.back().head.record.base.empty()) {
    const PackHead& head = chain.back().head;
    if (chain.size() > kMostChain) throw error::store_corrupted(id, "its bases have no end");
    File base = read_file(head.record.base);
    if (base.head.content != head.base_content)
      throw error::store_corrupted(id, "its base is not what it was");
    chain.push_back(std::move(base));
  }
  Decoded decoded;
  for (auto file = chain.rbegin(); file != chain.rend(); ++file) {
    std::map<std::string, DecodedArray> arrays;
    std::string_view rest =
        std::string_view(file->bytes).substr(file->head.size + file->head.recipe_size);
    for (EncodedArray& encoded : file->head.arrays) {
      if (encoded.data_bytes > rest.size()) throw error::store_corrupted(id, "it is cut off");
      encoded.data = rest.substr(0, encoded.data_bytes);
      rest.remove_prefix(encoded.data_bytes);
      if (file->head.store_version < kFirstWithArrays) {
        arrays[encoded.name].array.name = encoded.name;
        arrays[encoded.name].array.own(std::move(encoded.data));
        continue;
      }
      const auto base = decoded.arrays.find(encoded.base);
      arrays[encoded.name] =
          decode(encoded, base == decoded.arrays.end() ? nullptr : &base->second);
      encoded.data.clear();
    }
    decoded.arrays = std::move(arrays);
  }
  const PackHead& head = chain.front().head;
  for (const EncodedArray& encoded : head.arrays) decoded.names.push_back(encoded.name);
  if (head.store_version < kFirstWithArrays) return decoded;
  auto state = std::make_shared<State>(State{.content = head.content,
                                             .chain = head.chain,
                                             .chain_bytes = head.chain_bytes,
                                             .full_bytes = head.full_bytes});
  for (const auto& [name, array] : decoded.arrays) state->depths[name] = array.depths;
  decoded.state = std::move(state);
  return decoded;
}

StoredArrays Packs::get(const std::string& id) {
  Decoded decoded = decode_chain(id);
  StoredArrays arrays;
  for (const std::string& name : decoded.names)
    arrays.arrays.push_back(std::move(decoded.arrays[name].array));
  if (!decoded.state) return arrays;  // of store version 1: read_file has checked the bytes
  if (content_hash(arrays) != decoded.state->content)
    throw error::store_corrupted(id, "its content does not have its checksum");
  remember(id, std::move(decoded.state));
  return arrays;
}

Packs::StatePtr Packs::state_of(const std::string& id) {
  {
    const std::scoped_lock lock(mutex_);
    const auto known =
        std::find_if(states_.begin(), states_.end(), [&](const auto& s) { return s.first == id; });
    if (known != states_.end()) {
      states_.splice(states_.begin(), states_, known);
      // The pack may be gone all the same.
      if (fs::exists(path_of(id))) return known->second;
    }
  }
  try {
    StatePtr state = decode_chain(id).state;
    remember(id, state);
    return state;
  } catch (const Error&) {
    return nullptr;
  }
}

void Packs::remember(const std::string& id, StatePtr state) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(states_, [&](const auto& s) { return s.first == id; });
  states_.emplace_front(id, std::move(state));
  if (states_.size() > kStates) states_.pop_back();
}

std::optional<PackHead> Packs::head(const std::string& id) const {
  const fs::path path = path_of(id);
  try {
    if (!fs::exists(path)) return std::nullopt;
    std::string start = read_start(path, kMostHeadBytes);
    const auto size = size_of_pack_head(start);
    if (size && *size > start.size()) start = read_start(path, std::min(*size, kMostBytesOfHead));
    auto head = read_pack_head(start);
    if (!head) return std::nullopt;
    head->record.bytes = fs::file_size(path);
    if (head->store_version >= kFirstWithArrays)
      head->record.created_ns =
          std::chrono::nanoseconds(
              std::chrono::file_clock::to_sys(fs::last_write_time(path)).time_since_epoch())
              .count();
    return head;
  } catch (const fs::filesystem_error& failure) {
    throw error::store_failed("reading", path.string(), failure.code().value());
  }
}

void Packs::remove(const std::string& id) {
  {
    const std::scoped_lock lock(mutex_);
    std::erase_if(states_, [&](const auto& s) { return s.first == id; });
  }
  remove_file(path_of(id));
}

std::uint64_t Packs::bytes_of(const std::string& id) const {
  std::error_code failure;
  const std::uintmax_t bytes = fs::file_size(path_of(id), failure);
  return failure ? 0 : bytes;
}

std::vector<std::string> Packs::list() const {
  std::vector<std::string> ids;
  for_each_entry(folder_, [&](const fs::directory_entry& entry, const std::string& id) {
    if (is_full_id(id) && entry.is_regular_file()) ids.push_back(id);
  });
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<fs::path> Packs::strangers() const {
  std::vector<fs::path> paths;
  for_each_entry(folder_, [&](const fs::directory_entry& entry, const std::string& id) {
    if (!is_full_id(id) || !entry.is_regular_file()) paths.push_back(entry.path());
  });
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace remeshd

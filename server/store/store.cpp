#include "server/store/store.h"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "server/store/store_error.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

// A stored revision is one line that says whose bytes follow, and the bytes.
constexpr const char* kMagic = "remeshd-revision-1";

std::string seal(const RevisionRecord& record, const PlaceRecord& first, std::string_view bytes) {
  const json head = {{"format", kMagic},
                     {"id", record.id},
                     {"parent", record.parent},
                     {"model_name", record.model_name},
                     {"created_ns", record.created_ns},
                     {"nodes", record.nodes},
                     {"tets", record.tets},
                     {"design", first.design},
                     {"number", first.number}};
  std::string sealed = head.dump() + "\n";
  sealed += bytes;
  return sealed;
}

struct Unsealed {
  RevisionRecord record;
  PlaceRecord first;
};

std::optional<Unsealed> read_seal(const std::string& object, const std::string& sealed) {
  const json head = json::parse(sealed.substr(0, sealed.find('\n')), nullptr, false);
  if (head.is_discarded() || head.value("format", "") != kMagic) return std::nullopt;
  Unsealed out;
  out.record = {.id = head.at("id"),
                .parent = head.at("parent"),
                .model_name = head.at("model_name"),
                .object = object,
                .created_ns = head.at("created_ns"),
                .nodes = head.at("nodes"),
                .tets = head.at("tets"),
                .bytes = sealed.size()};
  out.first = {.design = head.at("design"), .number = head.at("number"), .id = out.record.id};
  return out;
}

}  // namespace

Store::Store() : catalogue_(std::make_unique<Catalogue>(":memory:")) {}

Store::~Store() = default;

Store::Store(const fs::path& folder, double wait) : folder_(fs::absolute(folder)) {
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (failure) throw error::store_failed("making", folder_.string(), failure.value());
  lock_folder(wait);
  objects_ = std::make_unique<Objects>(folder_ / "objects");
  const bool journal_lost = !fs::exists(folder_ / "journal");
  journal_ = std::make_unique<Journal>(folder_ / "journal");
  open_index(folder_ / "index.sqlite");
  if (journal_lost) {
    adopt_objects();
  } else {
    drop_orphans();
  }
}

void Store::lock_folder(double wait) {
  using std::chrono::steady_clock;
  const auto until = steady_clock::now() + std::chrono::duration<double>(wait);
  lock_ = File(folder_ / "lock", O_RDWR | O_CREAT);
  while (::flock(lock_.descriptor(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR)
      throw error::store_failed("locking", folder_.string(), errno);
    if (steady_clock::now() >= until) throw error::store_locked(folder_.string());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void Store::open_index(const fs::path& file) {
  const auto discard = [&](const std::string& why) {
    notes_.push_back("index made again from the journal: " + why);
    catalogue_.reset();
    for (const char* ending : {"", "-wal", "-shm"}) fs::remove(file.string() + ending);
    catalogue_ = std::make_unique<Catalogue>(file.string());
  };
  const bool had_index = fs::exists(file);
  try {
    catalogue_ = std::make_unique<Catalogue>(file.string());
    const std::uint64_t covered = catalogue_->journal_size();
    if (covered > journal_->size() || catalogue_->journal_mark() != journal_->mark(covered))
      discard("it belongs to another journal");
    else if (!had_index && journal_->size() > 0)
      notes_.emplace_back("index made again from the journal: it was missing");
  } catch (const Error& failure) {
    discard(failure.what());
  }
  const std::uint64_t end = journal_->size();
  if (catalogue_->journal_size() == end) return;
  Transaction all;
  const std::uint64_t bad =
      journal_->replay(catalogue_->journal_size(), [&](const Transaction& transaction) {
        all.insert(all.end(), transaction.begin(), transaction.end());
      });
  catalogue_->apply(all, end, journal_->mark(end));
  if (bad > 0) notes_.push_back(std::to_string(bad) + " damaged lines of the journal left out");
}

void Store::adopt_objects() {
  std::map<std::pair<std::string, std::uint32_t>, Unsealed> found;
  for (const std::string& object : objects_->list()) {
    try {
      if (auto unsealed = read_seal(object, objects_->get(object)))
        found.insert_or_assign({unsealed->first.design, unsealed->first.number}, *unsealed);
    } catch (const Error& failure) {
      notes_.emplace_back(failure.what());
    }
  }
  if (found.empty()) return;
  Transaction transaction;
  for (const auto& [key, revision] : found) {
    transaction.emplace_back(AddRevision{revision.record});
    transaction.emplace_back(AddPlace{key.first, key.second, revision.record.id});
    transaction.emplace_back(SetHead{key.first, revision.record.id});
  }
  commit([&](Catalogue&) { return transaction; });
  notes_.push_back("journal made again from " + std::to_string(found.size()) + " revisions");
}

void Store::drop_orphans() {
  for (const std::string& object : objects_->list())
    if (!catalogue_->has_object(object)) objects_->remove(object);
}

void Store::put(RevisionRecord& record, const PlaceRecord& first, std::string_view bytes) {
  if (!persistent()) return;
  const std::string sealed = seal(record, first, bytes);
  record.object = objects_->put(sealed);
  record.bytes = sealed.size();
}

std::string Store::get(const RevisionRecord& record) {
  const std::string sealed = objects_->get(record.object);
  const auto unsealed = read_seal(record.object, sealed);
  if (!unsealed || unsealed->record.id != record.id)
    throw error::store_corrupted(objects_->path_of(record.object).string(),
                                 "it is not the revision it should be");
  return sealed.substr(sealed.find('\n') + 1);
}

void Store::commit(const std::function<Transaction(Catalogue&)>& make) {
  const std::scoped_lock lock(mutex_);
  const Transaction transaction = make(*catalogue_);
  if (transaction.empty()) return;
  std::vector<std::string> objects;
  for (const Operation& operation : transaction) {
    const auto* gone = std::get_if<RemoveRevision>(&operation);
    if (gone == nullptr) continue;
    if (const auto record = catalogue_->revision(gone->id)) objects.push_back(record->object);
  }
  std::uint64_t size = 0;
  std::uint32_t mark = 0;
  if (journal_) {
    journal_->append(transaction);
    size = journal_->size();
    mark = journal_->mark(size);
  }
  catalogue_->apply(transaction, size, mark);
  if (!persistent()) return;
  for (const std::string& object : objects) {
    if (object.empty() || catalogue_->has_object(object)) continue;
    try {
      objects_->remove(object);
    } catch (const Error&) {
      // The transaction has happened all the same; the next opening drops the orphan.
    }
  }
}

}  // namespace remeshd

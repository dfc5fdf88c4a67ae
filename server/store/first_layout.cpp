#include "server/store/first_layout.h"

#include <algorithm>

#include "engine/base/error.h"
#include "proto/checksum.h"
#include "server/store/files.h"
#include "server/store/journal_line.h"
#include "server/store/pack_head.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFiles[] = {"journal", "index.sqlite", "index.sqlite-wal",
                                  "index.sqlite-shm"};

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

bool FirstLayout::present() const {
  return std::any_of(std::begin(kFiles), std::end(kFiles),
                     [&](const char* name) { return fs::exists(folder_ / name); }) ||
         fs::exists(folder_ / "objects");
}

std::vector<Transaction> FirstLayout::transactions() const {
  std::vector<Transaction> all;
  if (!fs::is_regular_file(folder_ / "journal")) return all;
  const std::string text = read_whole(folder_ / "journal");
  for (std::size_t start = 0, end = 0; start < text.size(); start = end + 1) {
    end = std::min(text.find('\n', start), text.size());
    if (auto line = read_journal_line(std::string_view(text).substr(start, end - start)))
      all.push_back(std::move(line->transaction));
  }
  return all;
}

void FirstLayout::bring_in(Packs& packs, Quarantine& quarantine) const {
  for (const fs::path& file : files_below(folder_ / "objects")) {
    const std::string hash = file.parent_path().filename().string() + file.filename().string();
    const std::string bytes = read_whole(file);
    const auto head = read_pack_head(std::string_view(bytes).substr(0, kMostHeadBytes));
    if (!head || !is_full_id(head->record.id)) {
      quarantine.take(file, "it is no revision");
    } else if (sha256_hex(bytes) != hash) {
      quarantine.take(file, "it is damaged");
    } else if (packs.is_whole(head->record.id)) {
      quarantine.take(file, "there is another copy of its revision");
    } else {
      StoredArray whole{.name = kOlderBytes};
      whole.own(bytes.substr(head->size));
      packs.put(head->record, head->first, "", {{std::move(whole)}}, nullptr);
      remove_file(file);
    }
  }
}

void FirstLayout::put_away(Quarantine& quarantine) const {
  for (const char* name : kFiles)
    if (fs::exists(folder_ / name)) quarantine.take(folder_ / name, "it is of an older layout");
  if (fs::exists(folder_ / "objects"))
    quarantine.take(folder_ / "objects", "it is of an older layout");
}

}  // namespace remeshd

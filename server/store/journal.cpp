#include "server/store/journal.h"

#include <fcntl.h>

#include <map>
#include <utility>

#include "engine/base/error.h"
#include "server/store/journal_line.h"
#include "server/store/line_reader.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;  // bytes written at a time

/// What one of the two files holds.
struct Reading {
  std::map<std::uint64_t, Transaction> lines;  ///< by number
  std::string unreadable;
  std::uint64_t size = 0;
  bool whole = true;  ///< every line can be read, and ends with a line break
};

/// Replaces the recipes of a transaction by the place of its line.
void leave_recipes(Transaction& transaction, const JournalPlace& place) {
  for (Operation& operation : transaction)
    if (KeptRecipe* recipe = recipe_in(operation).recipe) *recipe = KeptRecipe(place);
}

/// Throws Error(STORE_FAILED).
Reading read_lines(const File& file, bool with_recipes) {
  Reading reading;
  LineReader lines(file);
  while (const auto line = lines.next()) {
    const std::uint64_t start = lines.place() - line->size();
    auto read = read_journal_line(*line);
    if (read) {
      if (!with_recipes) leave_recipes(read->transaction, {start, line->size()});
      reading.lines.insert_or_assign(read->number, std::move(read->transaction));
    } else {
      reading.unreadable += *line;
      if (!line->ends_with('\n')) reading.unreadable += '\n';
    }
    reading.whole &= read && line->ends_with('\n');
  }
  reading.size = lines.place();
  return reading;
}

/// The recipe of `id` in the line that stands there; empty where there is none.
std::string recipe_in(const std::optional<File>& file, const JournalPlace& place,
                      const std::string& id) {
  if (!file) return {};
  auto line = read_journal_line(file->read(place.start, place.length));
  if (!line) return {};
  for (Operation& operation : line->transaction)
    if (const BroughtRecipe brought = recipe_in(operation);
        brought.id != nullptr && *brought.id == id)
      return std::move(brought.recipe->bytes);
  return {};
}

}  // namespace

Journal::Journal(const fs::path& folder, fs::path scratch)
    : file_(folder / "journal.a"), copy_(folder / "journal.b"), scratch_(std::move(scratch)) {
  read_both();
}

void Journal::read_both() {
  // Nothing is used of a file that the disk does not give in full.
  const auto read = [&](const fs::path& path, std::optional<File>& file, const auto& what) {
    whole_ = whole_ && fs::exists(path);
    if (!fs::exists(path)) return;
    try {
      file.emplace(path, O_RDONLY);
      what();
    } catch (const Error&) {
      whole_ = false;
      failed_files_.push_back(path);
      file.reset();
    }
  };
  Reading first, copy;
  read(file_, in_, [&] { first = read_lines(*in_, false); });
  read(copy_, copy_in_, [&] {
    if (in_ && same_content(*in_, *copy_in_)) return;
    whole_ = false;
    copy = read_lines(*copy_in_, true);
  });
  unreadable_ = first.unreadable;
  // The copy was not synced, so anything may be on the disk: its damaged lines count only where the
  // first file is not whole.
  if (!in_ || !first.whole) unreadable_ += copy.unreadable;
  whole_ = whole_ && first.whole;
  size_ = first.size;
  first.lines.merge(copy.lines);
  std::uint64_t before = 0;
  for (auto& [number, transaction] : first.lines) {
    if (before > 0) lost_ += number - before - 1;
    before = number;
    transactions_.push_back(std::move(transaction));
  }
  last_number_ = before;
  lines_ = first.lines.size();
}

std::string Journal::recipe(const std::string& id, const JournalPlace& line) const {
  std::string found;
  try {
    found = recipe_in(in_, line, id);
  } catch (const Error&) {
    found = recipe_in(copy_in_, line, id);
    if (found.empty()) throw;
    return found;
  }
  return found.empty() ? recipe_in(copy_in_, line, id) : found;
}

JournalPlace Journal::append(const Transaction& transaction) {
  const std::string line = line_of(transaction, last_number_ + 1);
  if (!out_) out_.emplace(file_, O_WRONLY | O_APPEND);
  uncertain_ = true;
  try {
    out_->write(line);
  } catch (const Error&) {
    // No part of the line may stay before the next one. Where cutting it off fails too, the journal
    // stays `uncertain`, and `rewrite` is due.
    out_->truncate(size_);
    uncertain_ = false;
    throw;
  }
  out_->sync();
  uncertain_ = false;
  const JournalPlace place{.start = size_, .length = line.size()};
  ++last_number_;
  ++lines_;
  size_ += line.size();
  append_to_copy(line);
  return place;
}

void Journal::append_to_copy(std::string_view line) {
  try {
    if (!copy_out_) copy_out_.emplace(copy_, O_WRONLY | O_APPEND);
    copy_out_->write(line);
  } catch (const Error&) {
    // The copy is a second chance, not a promise. It has to be whole lines all the same, which
    // rewriting both sees to.
    uncertain_ = true;
  }
}

std::string Journal::line_of(Transaction transaction, std::uint64_t number) const {
  for (Operation& operation : transaction) {
    const auto [id, recipe] = recipe_in(operation);
    if (id != nullptr && recipe->place) *recipe = KeptRecipe(this->recipe(*id, *recipe->place));
  }
  return write_journal_line({.number = number, .transaction = std::move(transaction)});
}

void Journal::rewrite(const std::vector<Transaction>& transactions,
                      const std::function<void(const std::vector<RecipePlace>&)>& moved) {
  std::uint64_t number = last_number_, size = 0;
  std::vector<RecipePlace> places;
  const auto write_lines = [&](File& out) {
    std::string piece;
    for (Transaction transaction : transactions) {
      const std::string line = line_of(transaction, ++number);
      for (Operation& operation : transaction)
        if (const std::string* id = recipe_in(operation).id)
          places.push_back({*id, {.start = size, .length = line.size()}});
      size += line.size();
      piece += line;
      if (piece.size() < kChunk) continue;
      out.write(piece);
      piece.clear();
    }
    out.write(piece);
  };
  out_.reset();
  copy_out_.reset();
  uncertain_ = true;
  write_durably(file_, write_lines, scratch_);
  last_number_ = number;
  lines_ = transactions.size();
  size_ = size;
  File in(file_, O_RDONLY);
  const auto write_copy = [&](File& out) {
    for (std::uint64_t start = 0; start < size; start += kChunk) out.write(in.read(start, kChunk));
  };
  write_durably(copy_, write_copy, scratch_);
  File copy_in(copy_, O_RDONLY);
  moved(places);
  in_ = std::move(in);
  copy_in_ = std::move(copy_in);
  uncertain_ = false;
  whole_ = true;
}

}  // namespace remeshd

#include "server/store/journal.h"

#include <fcntl.h>

#include <map>
#include <utility>

#include "engine/base/error.h"
#include "server/store/journal_line.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

/// What one of the two files holds.
struct Reading {
  std::map<std::uint64_t, Transaction> lines;  ///< by number
  std::string unreadable;
  bool whole = true;  ///< every line can be read, and ends
};

Reading read_lines(std::string_view text) {
  Reading reading;
  for (std::size_t start = 0, end = 0; start < text.size(); start = end) {
    end = text.find('\n', start);
    end = end == std::string::npos ? text.size() : end + 1;
    const std::string_view line = text.substr(start, end - start);
    auto read = read_journal_line(line);
    if (read) {
      reading.lines.insert_or_assign(read->number, std::move(read->transaction));
    } else {
      reading.unreadable += line;
      if (!line.ends_with('\n')) reading.unreadable += '\n';
    }
    reading.whole &= read && line.ends_with('\n');
  }
  return reading;
}

}  // namespace

Journal::Journal(const fs::path& folder, fs::path scratch)
    : file_(folder / "journal.a"), copy_(folder / "journal.b"), scratch_(std::move(scratch)) {
  read_both();
}

std::string Journal::read_file(const fs::path& file) {
  if (!fs::exists(file)) {
    whole_ = false;
    return {};
  }
  try {
    return read_whole(file);
  } catch (const Error&) {
    whole_ = false;
    failed_files_.push_back(file);
    return {};
  }
}

void Journal::read_both() {
  const std::string first_text = read_file(file_);
  const std::string copy_text = read_file(copy_);
  size_ = first_text.size();
  Reading first = read_lines(first_text);
  unreadable_ = first.unreadable;
  whole_ = whole_ && first.whole && copy_text == first_text;
  if (copy_text != first_text) {
    Reading copy = read_lines(copy_text);
    // Of a copy that was not waited for anything may be on the disk.
    if (!first.whole) unreadable_ += copy.unreadable;
    first.lines.merge(copy.lines);
  }
  std::uint64_t before = 0;
  for (auto& [number, transaction] : first.lines) {
    if (before > 0) lost_ += number - before - 1;
    before = number;
    transactions_.push_back(std::move(transaction));
  }
  last_number_ = before;
  lines_ = first.lines.size();
}

void Journal::append(const Transaction& transaction) {
  const std::string line =
      write_journal_line({.number = last_number_ + 1, .transaction = transaction});
  if (!out_) out_.emplace(file_, O_WRONLY | O_APPEND);
  uncertain_ = true;
  try {
    out_->write(line);
  } catch (const Error&) {
    // Not even half a line may stay before the next one. Where it does, `rewrite` is due.
    out_->truncate(size_);
    uncertain_ = false;
    throw;
  }
  out_->sync();
  uncertain_ = false;
  ++last_number_;
  ++lines_;
  size_ += line.size();
  append_to_copy(line);
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

void Journal::rewrite(const std::vector<Transaction>& transactions) {
  std::string text;
  std::uint64_t number = last_number_;
  for (const Transaction& transaction : transactions)
    text += write_journal_line({.number = ++number, .transaction = transaction});
  out_.reset();
  copy_out_.reset();
  uncertain_ = true;
  write_durably(file_, text, scratch_);
  last_number_ = number;
  lines_ = transactions.size();
  size_ = text.size();
  write_durably(copy_, text, scratch_);
  uncertain_ = false;
  whole_ = true;
}

}  // namespace remeshd

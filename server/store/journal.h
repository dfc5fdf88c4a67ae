#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/store/files.h"
#include "server/store/records.h"

namespace remeshd {

/// The transactions of a store in their order. One a line, numbered, with a version and a checksum;
/// in two files of the same content, so that damage to either loses none. A transaction is in the
/// store once its line is on the disk in the first file, `journal.a`; the second, `journal.b`, is
/// written after it and not waited for.
///
/// Recipes, which are most of it, are left in the files: transactions that were read tell where.
///
/// Opening changes no file.
class Journal {
 public:
  /// Reads both files, which may be missing, damaged, cut off anywhere or of different age.
  /// Scratch files go to `scratch`.
  Journal(const std::filesystem::path& folder, std::filesystem::path scratch);

  /// What was in the files, in order; recipes by the lines that have them, but for those that only
  /// the second file has. Given once.
  std::vector<Transaction> take_transactions() { return std::move(transactions_); }
  /// Lines of which neither copy could be read; those of an operation that this version does not
  /// know count.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  /// Every line that could not be read, as it stands in the files.
  [[nodiscard]] const std::string& unreadable() const { return unreadable_; }
  /// Files that are there and that the disk does not give: `rewrite` would replace them.
  [[nodiscard]] const std::vector<std::filesystem::path>& failed_files() const {
    return failed_files_;
  }
  /// Whether every line that was ever acknowledged can be read.
  [[nodiscard]] bool intact() const {
    return lost_ == 0 && lines_ > 0 && unreadable_.empty() && failed_files_.empty();
  }
  /// Whether the files are what this version writes, both whole. Else they are to be rewritten.
  [[nodiscard]] bool whole() const { return whole_; }
  [[nodiscard]] std::uint64_t lines() const { return lines_; }

  /// Returns where it stands. Throws Error(STORE_FAILED, STORE_FULL); the transaction is then not
  /// in the journal, unless `uncertain`: then it may be there after a crash, until `rewrite` has
  /// succeeded.
  JournalPlace append(const Transaction& transaction);
  /// Whether the journal has to be rewritten before a line can be appended: a write to it failed,
  /// and what the disk has of it is not known.
  [[nodiscard]] bool uncertain() const { return uncertain_; }

  /// Replaces all there is by `transactions`. `moved` hears where their recipes stand from then on;
  /// until it has returned, places are those of before. Throws Error(STORE_FAILED, STORE_FULL), and
  /// what `moved` throws; the journal is then as before, or holds all of them, and places are those
  /// of before.
  void rewrite(const std::vector<Transaction>& transactions,
               const std::function<void(const std::vector<RecipePlace>&)>& moved);

  /// A recipe as `packed`; empty where its line is damaged in both files. Throws
  /// Error(STORE_FAILED).
  [[nodiscard]] std::string recipe(const std::string& id, const JournalPlace& line) const;

 private:
  void read_both();
  void append_to_copy(std::string_view line);
  std::string line_of(Transaction transaction, std::uint64_t number) const;

  const std::filesystem::path file_, copy_, scratch_;
  /// What places tell of: the files as they were opened or last rewritten, be others there by now.
  std::optional<File> in_, copy_in_;
  std::vector<Transaction> transactions_;
  std::string unreadable_;
  std::vector<std::filesystem::path> failed_files_;
  std::uint64_t lost_ = 0;
  std::uint64_t lines_ = 0;
  std::uint64_t last_number_ = 0;
  std::uint64_t size_ = 0;  ///< bytes of the first file
  bool whole_ = true;
  bool uncertain_ = false;
  std::optional<File> out_, copy_out_;  ///< open once something was appended
};

}  // namespace remeshd

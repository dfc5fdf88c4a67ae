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
/// Recipes, which are most of the bytes, are left in the files: transactions that were read have
/// the place of the line instead.
///
/// Opening changes no file.
class Journal {
 public:
  /// Reads both files, which may be missing, damaged, cut off anywhere or of different age.
  /// Scratch files go to `scratch`.
  Journal(const std::filesystem::path& folder, std::filesystem::path scratch);

  /// The transactions that were read, in order; to be called once. Recipes are given by the place
  /// of their line, but in full where only the second file has it.
  std::vector<Transaction> take_transactions() { return std::move(transactions_); }
  /// Number of lines that could be read in neither file, or that have an operation unknown to this
  /// version.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  /// Every line that could not be read, as it stands in the files.
  [[nodiscard]] const std::string& unreadable() const { return unreadable_; }
  /// Files that are there but cannot be read from the disk: `rewrite` would replace them.
  [[nodiscard]] const std::vector<std::filesystem::path>& failed_files() const {
    return failed_files_;
  }
  /// Whether every line that was ever acknowledged can be read.
  [[nodiscard]] bool intact() const {
    return lost_ == 0 && lines_ > 0 && unreadable_.empty() && failed_files_.empty();
  }
  /// Whether both files are there, whole and the same. Else they are to be rewritten.
  [[nodiscard]] bool whole() const { return whole_; }
  [[nodiscard]] std::uint64_t lines() const { return lines_; }

  /// Appends a line and returns its place. Throws Error(STORE_FAILED, STORE_FULL); the transaction
  /// is then not in the journal, unless `uncertain`: then it may be there after a crash, until
  /// `rewrite` has succeeded.
  JournalPlace append(const Transaction& transaction);
  /// Whether the journal has to be rewritten before a line can be appended: a write to it failed,
  /// and what the disk has of it is not known.
  [[nodiscard]] bool uncertain() const { return uncertain_; }

  /// Replaces the whole journal by `transactions`. `moved` is called with the new places of their
  /// recipes; until it has returned, the old places are valid. Throws Error(STORE_FAILED,
  /// STORE_FULL), and what `moved` throws; the journal is then as before, or holds all of them, and
  /// the old places stay valid.
  void rewrite(const std::vector<Transaction>& transactions,
               const std::function<void(const std::vector<RecipePlace>&)>& moved);

  /// The recipe of `id` in `line`, as `packed`; empty where the line is damaged in both files.
  /// Throws Error(STORE_FAILED).
  [[nodiscard]] std::string recipe(const std::string& id, const JournalPlace& line) const;

 private:
  void read_both();
  void append_to_copy(std::string_view line);
  std::string line_of(Transaction transaction, std::uint64_t number) const;

  const std::filesystem::path file_, copy_, scratch_;
  /// The files that places refer to: as opened or last rewritten, even if they have been replaced
  /// since.
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

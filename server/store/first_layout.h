#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "server/store/packs.h"
#include "server/store/quarantine.h"
#include "server/store/records.h"

namespace remeshd {

/// The layout of stores before they had a FORMAT: `objects/`, files named by the hash of what is in
/// them; `journal`, whose lines have no numbers; `index.sqlite`. An older program that was started
/// on a store of today leaves these there too.
class FirstLayout {
 public:
  explicit FirstLayout(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] bool present() const;
  /// The transactions of its journal, but for lines that cannot be read.
  [[nodiscard]] std::vector<Transaction> transactions() const;
  /// Makes packs of the objects; those that have no pack's content, or the wrong hash, go to the
  /// quarantine. May be interrupted and done again. Throws Error(STORE_FAILED, STORE_FULL).
  void bring_in(Packs& packs, Quarantine& quarantine) const;
  /// Moves what is left of this layout to the quarantine. Pre: the journal of today holds its
  /// transactions.
  void put_away(Quarantine& quarantine) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace remeshd

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "server/store/packs.h"
#include "server/store/quarantine.h"
#include "server/store/records.h"

namespace remeshd {

/// The bytes of a revision of the first layout, as the only array of its pack.
inline constexpr const char* kFirstLayoutArray = "first_layout";

/// The layout of stores before they had a FORMAT: `objects/`, files named by the hash of what is in
/// them; `journal`, whose lines have no numbers; `index.sqlite`. An older program leaves it behind
/// in a store of today too.
class FirstLayout {
 public:
  explicit FirstLayout(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] bool present() const;
  /// What its journal holds, but for lines that cannot be read.
  [[nodiscard]] std::vector<Transaction> transactions() const;
  /// Makes packs of the objects; those that have no pack's content, or the wrong hash, go to the
  /// quarantine. May be interrupted and done again. Throws Error(StoreFailed, StoreFull).
  void bring_in(Packs& packs, Quarantine& quarantine) const;
  /// Puts what is left of it into the quarantine, once the journal of today holds what it told.
  void put_away(Quarantine& quarantine) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace remeshd

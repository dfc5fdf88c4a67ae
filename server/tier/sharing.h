#pragma once

#include <functional>
#include <memory>
#include <string>

#include "server/designs/design_table.h"
#include "server/designs/homes.h"
#include "server/tier/object_store.h"

namespace remeshd {

/// The keys of the shared tier.
struct TierSecrets {
  std::string farm_key;                ///< of all daemons of the farm
  std::string access_key, secret_key;  ///< of an S3 bucket
};

/// What a daemon shares with others, as the sessions of all tenants use it.
struct Sharing {
  std::shared_ptr<ObjectStore> objects{};  ///< the shared tier; null: none
  std::string farm_key{};
  /// True: an edit is acknowledged when the tier has its recipe; false: when the local store has
  /// it.
  bool acknowledge_in_tier = false;
  std::function<void(const std::string&)> tell{};  ///< hears lines for the log; may be empty
  std::shared_ptr<DesignTable> designs{};          ///< null: designs are in the store alone
  Homes homes{};                                   ///< of designs; where there is no table
};

/// Whether the place of a tier is an HTTP server's URL, not a folder.
bool is_http(const std::string& place);

/// The objects at a place, `http://...`, `https://...` or a folder, behind a breaker. `s3_region`:
/// as HttpAccess::region. `tell`: as Sharing::tell. Throws Error(TIER_UNAVAILABLE) for a folder
/// that cannot be made.
std::shared_ptr<ObjectStore> open_objects(const std::string& place, const std::string& s3_region,
                                          const TierSecrets& secrets,
                                          const std::function<void(const std::string&)>& tell);

}  // namespace remeshd

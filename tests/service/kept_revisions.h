#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <string>

#include "tests/service/requests.h"

namespace remeshd::test {

/// What a daemon acknowledged: revisions that have to be there whatever happens, and those that
/// must be gone. For several threads.
class KeptRevisions {
 public:
  struct Check {
    std::size_t lost = 0;   ///< acknowledged and not there
    std::size_t risen = 0;  ///< deleted and there
    std::size_t wrong = 0;  ///< of other bytes than before
    std::size_t read = 0;   ///< whose bytes were compared
  };

  void made(const std::string& id);
  /// Its bytes, unless somebody has begun to delete it meanwhile.
  void read(const std::string& id, std::size_t bytes);
  /// Any of them, or nothing where there is none.
  std::optional<std::string> any(std::mt19937& random) const;
  /// It may be there or not, from now on.
  void deleting(const std::string& id);
  void deleted(const std::string& id);
  [[nodiscard]] std::size_t count() const;

  /// Compares with what a daemon has; reads as many meshes.
  /// Throws std::runtime_error where it does not answer.
  [[nodiscard]] Check compare(v1::RemeshService::Stub& stub, std::size_t meshes,
                              std::mt19937& random) const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::optional<std::size_t>> there_;  ///< with a hash of the mesh's bytes
  std::set<std::string> gone_;
};

/// A hash of all arrays of a mesh, bytes and digests; nothing where the call fails.
std::optional<std::size_t> mesh_hash(v1::RemeshService::Stub& stub, const std::string& id);

}  // namespace remeshd::test

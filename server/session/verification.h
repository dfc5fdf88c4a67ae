#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/session/archive.h"

namespace remeshd {

/// The reading of all that an archive has stored, mesh by mesh, so that it can be interrupted
/// between two of them. What is stored after its beginning is left out.
class CacheVerification {
 public:
  /// The archive must outlive it.
  explicit CacheVerification(Archive& archive);

  [[nodiscard]] bool ended() const { return next_ == meshes_.size(); }
  /// Reads the next mesh; returns what is wrong with it, if anything. Pre: not ended.
  std::optional<CacheFault> next();

  [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }
  [[nodiscard]] std::uint64_t bytes_total() const { return bytes_total_; }

 private:
  struct Mesh {
    std::string id;
    std::uint64_t bytes = 0;
  };

  Archive& archive_;
  std::vector<Mesh> meshes_;
  std::size_t next_ = 0;
  std::uint64_t bytes_read_ = 0, bytes_total_ = 0;
};

}  // namespace remeshd

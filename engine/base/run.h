#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>
#include <string_view>

#include "engine/base/warning.h"

namespace remeshd {

/// What a client sees while a mesh is made.
struct Progress {
  std::string_view
      stage;  ///< `cells`, `difference`, `nodes`, `optimise`, `extract`, `improve`, `verify`
  int iteration = 0;    ///< 1-based within `optimise`, 0 elsewhere
  double fraction = 0;  ///< of the whole run, 0..1; falls back where another strategy is tried
};

/// Most nodes of a mesh, where nobody sets another limit.
inline constexpr std::uint32_t kDefaultMaxNodes = 5'000'000;

/// What surrounds one computation: the stop request, the listener, the number of threads, the
/// folder for dumps and the limit on nodes. It may end a computation; it never changes a result.
struct Run {
  std::stop_token stop;
  std::function<void(const Progress&)> on_progress;  ///< may be empty
  int threads = 1;
  std::filesystem::path dumps;  ///< empty: no dumps
  /// A mesh that would need more nodes is refused (`MESH_TOO_LARGE`) before any of them is made.
  std::uint32_t max_nodes = kDefaultMaxNodes;
  /// Called with warnings that the result is certain to have, before more work is done for it; not
  /// with all of them. It may throw, or request the stop; may be empty.
  std::function<void(std::span<const Warning>)> on_warnings = {};

  /// Throws Error(Cancelled) once a stop was requested. Call it at least every few milliseconds.
  void poll() const;
  /// Polls, then calls `on_progress`.
  void report(std::string_view stage, double fraction, int iteration = 0) const;
  /// Passes warnings that are certain to `on_warnings`, then polls.
  void warn(std::span<const Warning> certain) const;
};

/// Polls once in a while: to be called for every tet or node of a long loop.
class Polling {
 public:
  explicit Polling(const Run& run) : run_(run) {}
  void operator()() {
    if (++calls_ % kEvery == 0) run_.poll();
  }

 private:
  static constexpr std::uint32_t kEvery = 4096;
  const Run& run_;
  std::uint32_t calls_ = 0;
};

}  // namespace remeshd

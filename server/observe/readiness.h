#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace remeshd {

/// Whether the daemon can do its work. Each input (the store, memory, the end of the daemon) says
/// what hinders it; the daemon is ready while nothing does. May be used by any thread.
class Readiness {
 public:
  /// Told of each change between ready and not ready, one after the other. Must not call back.
  using OnChange = std::function<void(bool ready, const std::string& why_not)>;

  /// Calls `listener` now and at every change. Replaces the former one; an empty one: nobody is
  /// told.
  void on_change(OnChange listener);

  /// Sets what hinders the daemon from the point of view of `input`; empty: nothing.
  void set(const std::string& input, const std::string& why_not);
  [[nodiscard]] bool ready() const;
  /// `store: the disk is full; memory: ...`; empty while ready.
  [[nodiscard]] std::string why_not() const;

 private:
  [[nodiscard]] std::string joined() const;

  mutable std::mutex mutex_;
  std::map<std::string, std::string> hindrances_;  ///< by input
  OnChange listener_;
};

}  // namespace remeshd

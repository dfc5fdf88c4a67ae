#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <thread>

namespace remeshd {

/// What is still to be written to the shared store, by name, and the thread that does it. Names are
/// empty files in a folder: what was not written when the process ended, the next one writes.
class Outbox {
 public:
  /// Writes what the name stands for; throws Error where that has to be tried again.
  using Write = std::function<void(const std::string& name)>;
  /// What failed is tried again before all others, so that none overtakes it, or after them.
  enum class Again { First, Last };

  /// Makes the folder if need be. Throws Error(STORE_FAILED).
  Outbox(std::filesystem::path folder, Again again, Write write);
  /// Waits for what is just being written.
  ~Outbox();
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  /// Has it written soon, after what was added before; once more where it is just being written.
  void add(const std::string& name);
  /// Writes it now, if it is still to be written. Throws what `write` throws; then it stays.
  void write_now(const std::string& name);
  /// Whether it is still to be written.
  [[nodiscard]] bool has(const std::string& name) const;
  /// How many are still to be written.
  [[nodiscard]] std::size_t size() const;

 private:
  void run(const std::stop_token& stop);
  /// False where it failed.
  bool write_one(const std::string& name);
  void take_off(const std::string& name);

  const std::filesystem::path folder_;
  const Again again_;
  const Write write_;
  mutable std::mutex mutex_;  ///< guards what follows
  std::condition_variable_any changed_;
  std::deque<std::string> order_;
  std::set<std::string> waiting_;  ///< those of them that were not written meanwhile
  std::set<std::string> writing_;
  std::jthread thread_;  ///< last: it uses what stands before it
};

}  // namespace remeshd

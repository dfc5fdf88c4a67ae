#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace remeshd {

/// A persistent queue of what is still to be written to the shared store, by name, and the threads
/// that write it, several names at a time. Each name is an empty file in a folder: what was not
/// written when the process ended, the next one writes.
class Outbox {
 public:
  /// Writes what the name stands for; throws Error where that has to be tried again, but for
  /// TIER_REFUSED: then it is given up.
  using Write = std::function<void(const std::string& name)>;
  /// What failed keeps its place, or is tried again after all others.
  enum class Again { InPlace, Last };

  /// Makes the folder if need be. Throws Error(STORE_FAILED).
  Outbox(std::filesystem::path folder, Again again, Write write);
  /// Waits for what is just being written.
  ~Outbox();
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  /// Queues a name, after those added before; one that is just being written is written once more.
  /// After the return it outlives a crash, unless the disk is full.
  void add(const std::string& name);
  /// Writes a name on this thread, if it is still to be written; first waits for another thread
  /// that is just writing it. Throws what `write` throws; then the name stays queued, unless it was
  /// given up.
  void write_now(const std::string& name);
  /// Whether a name is still to be written.
  [[nodiscard]] bool has(const std::string& name) const;
  /// How many names are still to be written.
  [[nodiscard]] std::size_t size() const;

 private:
  void run(const std::stop_token& stop);
  /// Writes a name that was taken off the list, where it had `place`. Throws what `write` throws;
  /// then the name is on the list again, unless it was given up.
  void write_taken(const std::string& name, std::uint64_t place);
  void list(const std::string& name, std::uint64_t place);
  std::uint64_t unlist(const std::string& name);
  void finish(const std::string& name);
  void remove_mark(const std::string& name);

  const std::filesystem::path folder_;
  const Again again_;
  const Write write_;
  mutable std::mutex mutex_;  ///< guards what follows
  std::condition_variable_any changed_;
  std::map<std::string, std::uint64_t> waiting_;  ///< names, with the place of each in the order
  std::map<std::uint64_t, std::string> order_;    ///< the same names, by place
  std::uint64_t next_place_ = 0;
  std::set<std::string> writing_;
  std::vector<std::jthread> threads_;  ///< last: they use what stands before them
};

}  // namespace remeshd

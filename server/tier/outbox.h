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

/// What is still to be written to the shared store, by name, and the threads that do it, several
/// names at a time. Names are empty files in a folder: what was not written when the process ended,
/// the next one writes.
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

  /// Has it written soon, after what was added before; once more where it is just being written.
  void add(const std::string& name);
  /// Writes it now, if it is still to be written. Throws what `write` throws; then it stays, unless
  /// it was given up.
  void write_now(const std::string& name);
  /// Whether it is still to be written.
  [[nodiscard]] bool has(const std::string& name) const;
  /// How many are still to be written.
  [[nodiscard]] std::size_t size() const;

 private:
  void run(const std::stop_token& stop);
  /// Writes one that was taken off the list. Throws what `write` throws; then it is on it again.
  void write_taken(const std::string& name, std::uint64_t place);
  void list(const std::string& name, std::uint64_t place);
  std::uint64_t unlist(const std::string& name);
  void finish(const std::string& name);

  const std::filesystem::path folder_;
  const Again again_;
  const Write write_;
  mutable std::mutex mutex_;  ///< guards what follows
  std::condition_variable_any changed_;
  std::map<std::string, std::uint64_t> waiting_;  ///< and the place of each in the order
  std::map<std::uint64_t, std::string> order_;    ///< the same, by place
  std::uint64_t next_place_ = 0;
  std::set<std::string> writing_;
  std::vector<std::jthread> threads_;  ///< last: they use what stands before them
};

}  // namespace remeshd

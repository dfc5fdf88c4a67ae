#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace remeshd {

/// Figures that are read anew at each scrape. Each source fills in what it knows; figures that no
/// source fills in are left out.
struct MetricsReadings {
  std::optional<bool> ready;
  std::vector<std::pair<std::string, double>> queue_depth;  ///< by lane
  std::optional<double> computations_running;
  std::optional<double> memory_bytes, memory_budget_bytes;  ///< of leases and revisions held
  std::optional<double> disk_bytes, disk_budget_bytes;
  std::optional<double> revisions;
  std::optional<double> connections, streams;
  std::optional<double> helper_crashes;
  std::optional<double> log_dropped;
  std::optional<double> tier_waiting;
};

/// Figures of how a revision was made.
struct RevisionFigures {
  std::vector<std::pair<std::string, double>> phases;  ///< s, by name
  std::optional<double> reuse;  ///< of an edit: share of its tets kept from its base
  double least_dihedral = 0;    ///< degrees
};

/// The figures that operators watch, under the names `remeshd_...`. For any thread; a figure that
/// cannot be counted for want of memory is lost.
class Metrics {
 public:
  enum class CacheResult : std::uint8_t { Memory, Disk, Tier, Computed, Remade };
  enum class Tier : std::uint8_t { Memory, Disk };
  using Source = std::function<void(MetricsReadings&)>;

  Metrics(const std::string& version, std::uint32_t algorithm_version);
  ~Metrics();
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;

  /// A call, or a request of a stream, has ended with this code of gRPC's.
  void call_ended(const std::string& method, const std::string& code, double seconds) noexcept;
  /// A call was refused for want of room or permission, or since the daemon ends; `reason`: that of
  /// its Error.
  void refused(const std::string& reason) noexcept;
  void queue_waited(const std::string& lane, double seconds) noexcept;
  void computed(const RevisionFigures& figures) noexcept;
  /// Where the mesh of a request came from.
  void cache_request(CacheResult result) noexcept;
  void evicted(Tier from) noexcept;

  /// Calls `source` at each scrape, on the scraper's thread; what it throws is dropped. Replaces
  /// the former source of this name, which is not called any more once this has returned; an empty
  /// one removes it.
  void set_source(const std::string& name, Source source);

  /// In Prometheus' text format.
  [[nodiscard]] std::string text() const;

  struct Parts;
  [[nodiscard]] const std::shared_ptr<Parts>& parts() const { return parts_; }

 private:
  const std::shared_ptr<Parts> parts_;
};

}  // namespace remeshd

#include "tests/bench/sample.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace remeshd::bench {
namespace {

using nlohmann::json;

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A line of /proc/self/status that ends in kB.
double status_bytes(const std::string& name) {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
  return 0;
}

}  // namespace

json write_sample(const Sample& s) {
  if (!s.failure.empty()) return {{"failure", s.failure}};
  const Quality& q = s.quality;
  json j{{"cpu", s.cpu},
         {"wall", s.wall},
         {"nodes", s.nodes},
         {"tets", s.tets},
         {"peak_bytes", s.peak_bytes},
         {"quality",
          {{"volume_length_mean", q.volume_length_mean},
           {"volume_length_p01", q.volume_length_p01},
           {"volume_length_min", q.volume_length_min},
           {"dihedral_min", q.dihedral_min},
           {"dihedral_max", q.dihedral_max},
           {"volume", q.volume}}}};
  if (s.import > 0) j["import"] = s.import;
  if (s.geometry > 0) j["geometry"] = s.geometry;
  if (s.surface > 0) j["surface"] = s.surface;
  if (s.retained_bytes > 0) j["retained_bytes"] = s.retained_bytes;
  if (s.strategy.empty()) return j;
  j["way"] = s.strategy;
  j["iterations"] = s.iterations;
  j["free_share"] = s.free_share;
  j["kept"] = s.kept;
  if (s.base_kept > 0 || s.base_far > 0)
    j["of_base"] = {{"kept", s.base_kept}, {"far", s.base_far}};
  j["circle_edges"] = s.circle_edges;
  j["away"] = {{"mean", s.away_mean}, {"angle", s.away_angle}};
  j["phases"] = {{"setup", s.phases.setup},
                 {"optimise", s.phases.optimise},
                 {"extract", s.phases.extract},
                 {"difference", s.phases.difference},
                 {"copy", s.phases.copy}};
  return j;
}

Sample read_sample(const json& j) {
  Sample s;
  if (j.contains("failure")) {
    s.failure = j.at("failure").get<std::string>();
    return s;
  }
  j.at("cpu").get_to(s.cpu);
  j.at("wall").get_to(s.wall);
  j.at("nodes").get_to(s.nodes);
  j.at("tets").get_to(s.tets);
  j.at("peak_bytes").get_to(s.peak_bytes);
  const json& q = j.at("quality");
  q.at("volume_length_mean").get_to(s.quality.volume_length_mean);
  q.at("volume_length_p01").get_to(s.quality.volume_length_p01);
  q.at("volume_length_min").get_to(s.quality.volume_length_min);
  q.at("dihedral_min").get_to(s.quality.dihedral_min);
  q.at("dihedral_max").get_to(s.quality.dihedral_max);
  q.at("volume").get_to(s.quality.volume);
  s.import = j.value("import", 0.0);
  s.geometry = j.value("geometry", 0.0);
  s.surface = j.value("surface", 0.0);
  s.retained_bytes = j.value("retained_bytes", 0.0);
  s.strategy = j.value("way", std::string());
  s.iterations = j.value("iterations", 0U);
  s.free_share = j.value("free_share", 0.0);
  s.kept = j.value("kept", 0.0);
  if (j.contains("of_base")) {
    j.at("of_base").at("kept").get_to(s.base_kept);
    j.at("of_base").at("far").get_to(s.base_far);
  }
  s.circle_edges = j.value("circle_edges", 0.0);
  if (j.contains("away")) {
    j.at("away").at("mean").get_to(s.away_mean);
    j.at("away").at("angle").get_to(s.away_angle);
  }
  if (j.contains("phases")) {
    const json& p = j.at("phases");
    p.at("setup").get_to(s.phases.setup);
    p.at("optimise").get_to(s.phases.optimise);
    p.at("extract").get_to(s.phases.extract);
    p.at("difference").get_to(s.phases.difference);
    p.at("copy").get_to(s.phases.copy);
  }
  return s;
}

void describe_mesh(std::span<const Vec3> nodes, std::span<const Tet> tets, Sample& sample) {
  double volume = 0;
  for (const Tet& t : tets)
    volume += tet_volume(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
  std::vector<Tet> positive(tets.begin(), tets.end());
  if (volume < 0)
    for (Tet& t : positive) std::swap(t[0], t[1]);
  sample.nodes = static_cast<std::uint32_t>(nodes.size());
  sample.tets = static_cast<std::uint32_t>(tets.size());
  sample.quality = measure_quality(nodes, positive, Run{});
}

Meter::Meter() : idle_bytes_(resident_bytes()) {}

void Meter::start() {
  std::ofstream("/proc/self/clear_refs") << "5";  // forgets VmHWM
  cpu_ = processor_seconds();
  wall_ = wall_seconds();
}

void Meter::stop(Sample& sample) const {
  sample.wall = wall_seconds() - wall_;
  sample.cpu = processor_seconds() - cpu_;
  sample.peak_bytes = std::max(0.0, status_bytes("VmHWM") - idle_bytes_);
}

double processor_seconds() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    ::getrusage(who, &used);
    sum += seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  }
  return sum;
}

double resident_bytes() { return status_bytes("VmRSS"); }

}  // namespace remeshd::bench

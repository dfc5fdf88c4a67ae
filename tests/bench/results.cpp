#include "tests/bench/results.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

namespace remeshd::bench {
namespace {

using nlohmann::json;

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

}  // namespace

std::string series_name(std::string_view run, std::uint32_t iterations) {
  return std::string(run) + " " + (iterations == 0 ? "auto" : std::to_string(iterations));
}

std::optional<double> Group::seconds(const std::string& name_of_series) const {
  return middle(name_of_series, [](const Sample& s) { return s.cpu; });
}

std::optional<double> Group::ratio(const std::string& a, const std::string& b) const {
  const auto cpu = [](const Sample& s) { return s.cpu; };
  return pairwise_ratio(rounds(a, cpu), rounds(b, cpu));
}

std::optional<double> Group::ratio_from_model(const std::string& a, const std::string& b) const {
  const auto all = [](const Sample& s) { return s.geometry + s.cpu; };
  return pairwise_ratio(rounds(a, all), rounds(b, all));
}

std::optional<double> Group::ratio_per_node(const std::string& a, const std::string& b) const {
  const auto cpu = [](const Sample& s) { return s.cpu / s.nodes; };
  return pairwise_ratio(rounds(a, cpu), rounds(b, cpu));
}

const Group* Results::find(std::string_view name, std::uint32_t nodes) const {
  for (const Group& group : groups)
    if (group.name == name && group.nodes == nodes) return &group;
  return nullptr;
}

json write_results(const Results& results) {
  json groups = json::array();
  for (const Group& group : results.groups) {
    json series = json::object();
    for (const auto& [name, samples] : group.series) {
      json rounds = json::array();
      for (const Sample& sample : samples) rounds.push_back(write_sample(sample));
      series[name] = std::move(rounds);
    }
    groups.push_back({{"name", group.name}, {"nodes", group.nodes}, {"series", std::move(series)}});
  }
  return {{"machine", results.machine},
          {"date", results.date},
          {"commands", results.commands},
          {"groups", std::move(groups)}};
}

Results read_results(const json& j) {
  Results results;
  j.at("machine").get_to(results.machine);
  j.at("date").get_to(results.date);
  j.at("commands").get_to(results.commands);
  for (const json& g : j.at("groups")) {
    Group& group = results.groups.emplace_back();
    g.at("name").get_to(group.name);
    g.at("nodes").get_to(group.nodes);
    for (const auto& [name, rounds] : g.at("series").items())
      for (const json& sample : rounds) group.series[name].push_back(read_sample(sample));
  }
  return results;
}

std::string this_machine() {
  utsname system{};
  ::uname(&system);
  const double memory = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
                        static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1024.0 * 1024 * 1024);
  return processor() + ", " + std::to_string(::sysconf(_SC_NPROCESSORS_ONLN)) + " cores, " +
         std::to_string(static_cast<int>(std::lround(memory))) + " GB, " + system.sysname + " " +
         system.release;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &local);
  return text.data();
}

}  // namespace remeshd::bench

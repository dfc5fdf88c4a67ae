// remesh-bench: what a remesh costs, against a regular run, the paper and other meshers. README.md
// beside this file says how to use it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/error.h"
#include "tests/bench/engine_run.h"
#include "tests/bench/growth.h"
#include "tests/bench/one_case.h"
#include "tests/bench/session.h"
#include "tests/bench/tables.h"
#include "tests/support/cases.h"

namespace {

using namespace remeshd;
using namespace remeshd::bench;
namespace fs = std::filesystem;

constexpr const char* kNodesPlot = "growth-nodes.svg";
constexpr const char* kFeaturesPlot = "growth-features.svg";

struct Options {
  std::vector<std::string> cases, sizes, iterations{"5", "10", "auto"}, peers;
  bool no_peers = false, goals = false, keep = false, every_size = false;
  std::string json, markdown, growth;
  Settings settings;
  GrowthPoints points;
};

/// `15000` or `15k` or `1M`.
std::uint32_t node_count(const std::string& text) {
  std::size_t used = 0;
  const double number = std::stod(text, &used);
  const std::string unit = text.substr(used);
  const double factor = unit == "k" ? 1e3 : unit == "M" ? 1e6 : unit.empty() ? 1 : 0;
  if (factor == 0) throw std::runtime_error("not a number of nodes: " + text);
  return static_cast<std::uint32_t>(std::lround(number * factor));
}

/// The sizes of a case: those asked for, or 15k to 100k, and to a million for two of them.
std::vector<std::uint32_t> sizes_of(const std::string& name, const Options& options) {
  std::vector<std::uint32_t> sizes;
  for (const std::string& size : options.sizes) sizes.push_back(node_count(size));
  if (!sizes.empty()) return sizes;
  sizes = {15'000, 30'000, 100'000};
  if (name == "simple-ab" || name == "tool1-ac") sizes.insert(sizes.end(), {300'000, 1'000'000});
  return sizes;
}

/// Results on their way, stored after each group.
class Ledger {
 public:
  Ledger(const Options& options, std::string command) : options_(options) {
    if (options.keep) {
      std::ifstream in(options.json);
      const nlohmann::json stored = nlohmann::json::parse(in, nullptr, false);
      if (stored.is_object()) results_ = read_results(stored);
    }
    results_.machine = this_machine();
    results_.date = today();
    if (std::ranges::count(results_.commands, command) == 0)
      results_.commands.push_back(std::move(command));
  }

  [[nodiscard]] const Results& results() const { return results_; }

  void measure(const Subject& subject, std::uint32_t nodes, const Settings& settings) {
    if (results_.find(subject.name, nodes) != nullptr) return;
    results_.groups.push_back(measure_group(subject, nodes, settings));
    if (options_.json.empty()) return;
    std::ofstream out(options_.json);
    out << write_results(results_).dump(1) << "\n";
    if (!out.flush()) throw std::runtime_error("cannot write " + options_.json);
  }

 private:
  const Options& options_;
  Results results_;
};

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

/// Chains belong to the smallest size.
void measure_cases(const Options& options, Ledger& ledger) {
  for (const std::string& name : options.cases) {
    const std::vector<std::uint32_t> sizes = sizes_of(name, options);
    for (const std::uint32_t nodes : sizes) {
      Settings settings = options.settings;
      if (nodes != std::ranges::min(sizes)) settings.chain = 0;
      ledger.measure(case_subject(name), nodes, settings);
    }
  }
}

void measure_growth(const Options& options, Ledger& ledger) {
  Settings settings = options.settings;
  settings.iterations = {10};
  settings.peers.clear();
  settings.paper_regular = false;
  settings.chain = 0;
  for (const std::uint32_t nodes : options.points.nodes)
    ledger.measure(case_subject("simple-ab"), nodes, settings);
  for (const int features : options.points.features)
    ledger.measure(hole_plate(features), options.points.nodes_of_features, settings);
  fs::create_directories(options.growth);
  write_file(fs::path(options.growth) / kNodesPlot,
             svg(plot_nodes(ledger.results(), options.points)));
  write_file(fs::path(options.growth) / kFeaturesPlot,
             svg(plot_features(ledger.results(), options.points)));
}

/// Whether every run gave a mesh.
bool all_well(const Results& results) {
  for (const Group& group : results.groups)
    for (const auto& [name, samples] : group.series)
      for (const Sample& sample : samples)
        if (!sample.failure.empty()) return false;
  return true;
}

void print_report(const Results& results, const Options& options) {
  std::string text = report(results, options.settings.sized);
  if (!options.growth.empty()) {
    const fs::path plots =
        fs::relative(options.growth, fs::absolute(options.markdown).parent_path());
    text += "\n### Growth\n\n";
    for (const char* plot : {kNodesPlot, kFeaturesPlot})
      text += "![" + std::string(plot) + "](" + (plots / plot).generic_string() + ")\n";
  }
  if (options.goals) text += "\n### Goals\n\n" + goal_table(judge(results));
  if (options.markdown.empty()) {
    std::cout << text;
    return;
  }
  std::ifstream in(options.markdown);
  const std::string document{std::istreambuf_iterator<char>(in), {}};
  write_file(options.markdown, between_marks(document, text).value_or(text));
}

/// What was asked for in words, as settings.
void settle(Options& options) {
  options.settings.iterations.clear();
  for (const std::string& k : options.iterations)
    options.settings.iterations.push_back(k == "auto" ? 0
                                                      : static_cast<std::uint32_t>(std::stoul(k)));
  if (options.cases.empty())
    for (const test::EditCase& c : test::seven_cases()) options.cases.push_back(c.edit);
  if (options.cases == std::vector<std::string>{"none"}) options.cases.clear();
  if (options.no_peers) return;
  for (const Peer& peer : all_peers()) {
    const bool wanted = options.peers.empty() || std::ranges::count(options.peers, peer.name) > 0;
    if (!wanted) continue;
    if (!available(peer)) {
      std::cerr << "not there: " << peer.title << " (deploy/packages-bench.txt)\n";
      continue;
    }
    options.settings.peers.push_back(peer);
    if (options.every_size) options.settings.peers.back().most_nodes = UINT32_MAX;
  }
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("What a remesh costs, against a regular run, the paper and other meshers");
  app.fallthrough();  // `tables FILE --goals`
  Options options;
  std::vector<std::string> known;
  for (const Peer& peer : all_peers()) known.push_back(peer.name);
  app.add_option("--cases", options.cases,
                 "edits of tests/cases, detailed parts, or none; all seven");
  app.add_option("--sizes", options.sizes,
                 "nodes; 15k 30k 100k, for simple-ab and tool1-ac 300k 1M too");
  app.add_option("--iterations", options.iterations, "numbers or auto; 5 10 auto");
  app.add_option("--repeats", options.settings.repeats, "rounds")->check(CLI::PositiveNumber);
  app.add_option("--seeds", options.settings.seeds, "round by round");
  CLI::Option* peers =
      app.add_option("--peers", options.peers, "other meshers; all")->check(CLI::IsMember(known));
  app.add_flag("--no-peers", options.no_peers, "ours alone")->excludes(peers);
  app.add_flag("--peers-at-every-size", options.every_size,
               "also where one takes the better part of a day");
  app.add_flag("--paper-regular", options.settings.paper_regular,
               "regular runs as the paper has them too");
  app.add_option("--chain", options.settings.chain,
                 "edits of a chain at the smallest size; 0: none")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--limit", options.settings.limit_seconds, "seconds for a run");
  app.add_flag("--sized", options.settings.sized,
               "ours sized by its rules, Gmsh's by curvature with 12 edges a circle");
  app.add_flag("--goals", options.goals, "print the goals, met or missed");
  CLI::Option* json = app.add_option("--json", options.json, "file for all samples");
  app.add_flag("--keep", options.keep, "go on with what that file has")->needs(json);
  app.add_option("--markdown", options.markdown,
                 "file for the tables, instead of stdout: between its marks, if it has them");
  app.add_option("--growth", options.growth,
                 "folder for the plots of growth, and measure for them");
  app.add_option("--growth-nodes", options.points.nodes, "15000 30000 100000 300000 1000000");
  app.add_option("--growth-features", options.points.features, "16 32 64 128 256")
      ->check(CLI::Range(2, 1000));
  options.settings.folder = fs::temp_directory_path() / "remesh-bench";
  app.add_option("--folder", options.settings.folder,
                 "for models, geometries and the peers' edge lengths");

  std::string edit, request;
  std::uint32_t nodes = 15000, iterations = 10;
  std::uint64_t seed = 1;
  int repeats = 1;
  CLI::App* run = app.add_subcommand("run", "one case in this process, a line a mesh");
  run->add_option("case", edit)->required();
  run->add_option("nodes", nodes);
  run->add_option("iterations", iterations, "0: auto");
  run->add_option("seed", seed);
  run->add_option("repeats", repeats);
  CLI::App* tables = app.add_subcommand("tables", "print stored samples, --goals too");
  tables->add_option("file", options.json)->required();
  CLI::App* work_command = app.add_subcommand(kWorkCommand, "what the benchmark starts");
  work_command->add_option("request", request)->required();
  work_command->group("");  // not in the help
  CLI11_PARSE(app, argc, argv);

  if (*work_command) {
    std::cout << work(request) << std::endl;
    return 0;
  }
  if (*run) {
    run_one_case(edit, nodes, iterations, seed, repeats);
    return 0;
  }
  if (*tables) {
    std::ifstream in(options.json);
    if (!in) throw std::runtime_error("cannot open " + options.json);
    print_report(read_results(nlohmann::json::parse(in)), options);
    return 0;
  }
  settle(options);
  std::string command = "remesh-bench";
  for (int k = 1; k < argc; ++k) command += std::string(" ") + argv[k];
  Ledger ledger(options, command);
  measure_cases(options, ledger);
  if (!options.growth.empty()) measure_growth(options, ledger);
  print_report(ledger.results(), options);
  return all_well(ledger.results()) ? 0 : 1;
} catch (const remeshd::Error& e) {
  std::cerr << "remesh-bench: " << e.info().reason << ": " << e.what() << "\n";
  return 1;
} catch (const std::exception& failure) {
  std::cerr << "remesh-bench: " << failure.what() << "\n";
  return 1;
}

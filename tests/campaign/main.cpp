// Random models and edits through the engine, each mesh verified by code of its own; README.md
// beside this file says how to use it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <deque>
#include <fstream>
#include <future>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <semaphore>

#include "tests/campaign/random_case.h"
#include "tests/campaign/record.h"
#include "tests/campaign/shrink.h"
#include "tests/campaign/store.h"
#include "tests/campaign/tally.h"
#include "tests/support/documents.h"

namespace {

using namespace remeshd::campaign;
namespace fs = std::filesystem;

struct Options {
  std::uint64_t seed = 1, number = 0, from = 0;
  int edits = 300, jobs = 1;
  std::string file, out, json, record;
  bool only_gentle = false, only_others = false, parts = false, even = false;
  std::uint32_t part_nodes = 15000;
  bool keep_refusals = false, keep_fallbacks = false, strict = false, verbose = false;
  double shrink_seconds = 60;

  [[nodiscard]] CaseRequest request(std::uint64_t k) const {
    CaseRequest result{seed, k};
    if (parts) result.part_nodes = part_nodes;
    result.even = even;
    return result;
  }
};

constexpr double kCaseSeconds = 1500;  // wall clock; each step has its own limit

bool fell_back(const Outcome& o) {
  return o.valid() && (o.strategy == "full" || o.strategy == "fresh" || o.strategy == "TetGen");
}

bool failed(const Outcome& o) { return !o.valid() && o.kind != "refused"; }

void keep(const Options& options, const WorkedCase& worked, const Outcome& o) {
  const bool wanted = failed(o) || (options.keep_refusals && o.kind == "refused") ||
                      (options.keep_fallbacks && fell_back(o));
  if (!wanted) return;
  std::cerr << "case " << worked.campaign_case.number << " step " << o.step << ": " << o.failure()
            << (fell_back(o) ? o.strategy : "") << ": " << o.message << "\n";
  if (options.out.empty()) return;
  Outcome named = o;
  if (fell_back(o)) named.kind = "fallback", named.reason = o.strategy;
  const fs::path file = store_failure(options.out, worked, named);
  std::cerr << "  stored " << file.string() << "\n";
  if (!fell_back(o) && options.shrink_seconds > 0) {
    const fs::path smaller = shrink_file(file, options.shrink_seconds);
    std::cerr << "  shrunk " << smaller.string() << "\n";
  }
}

/// The cases of a campaign in their order; the next ones are worked on meanwhile, some more than
/// there are jobs, so that none waits for a long one.
class Cases {
 public:
  explicit Cases(const Options& options)
      : options_(options),
        record_(options.record),
        next_(options.from),
        jobs_(std::max(1, options.jobs)),
        free_jobs_(static_cast<std::ptrdiff_t>(jobs_)) {}
  Cases(const Cases&) = delete;
  Cases& operator=(const Cases&) = delete;
  /// Waits for the cases that are worked on; no other is begun.
  ~Cases() { enough_ = true; }

  WorkedCase next() {
    constexpr std::size_t kAheadPerJob = 16;
    // One job waits for each case whatever comes after it.
    while (ahead_.size() < (jobs_ == 1 ? 1 : kAheadPerJob * jobs_)) start_one();
    WorkedCase worked = ahead_.front().get();
    ahead_.pop_front();
    return worked;
  }

 private:
  using Jobs = std::counting_semaphore<>;

  /// One of the jobs, taken.
  class Job {
   public:
    explicit Job(Jobs& jobs) : jobs_(jobs) { jobs_.acquire(); }
    ~Job() { jobs_.release(); }
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

   private:
    Jobs& jobs_;
  };

  void start_one() {
    for (; !options_.parts; ++next_) {
      const bool gentle = is_gentle(options_.seed, next_);
      if (!(gentle ? options_.only_others : options_.only_gentle)) break;
    }
    ahead_.push_back(std::async(std::launch::async, [this, request = options_.request(next_++)] {
      if (auto done = record_.find(request)) return std::move(*done);
      const Job job(free_jobs_);
      if (enough_) return WorkedCase{};
      WorkedCase worked = have_worked(request, kCaseSeconds);
      worked.campaign_case.number = request.number;  // which a worker that ends early does not tell
      const std::lock_guard lock(writing_);
      record_.add(request, worked);
      return worked;
    }));
  }

  const Options& options_;
  const Record record_;
  std::mutex writing_;  ///< the record
  std::uint64_t next_;
  std::size_t jobs_;
  Jobs free_jobs_;
  std::atomic<bool> enough_ = false;
  std::deque<std::future<WorkedCase>> ahead_;
};

int run(const Options& options) {
  Tally tally;
  Cases cases(options);
  int failures = 0;
  const auto save = [&] {
    if (!options.json.empty()) std::ofstream(options.json) << write_tally(tally).dump(1) << "\n";
  };
  while (tally.edits < options.edits) {
    const WorkedCase worked = cases.next();
    const std::uint64_t k = worked.campaign_case.number;
    tally.add(worked);
    for (const Outcome& o : worked.outcomes) {
      failures += failed(o);
      if (options.verbose) std::cerr << k << " " << write_outcome(o).dump() << "\n";
      keep(options, worked, o);
    }
    save();
  }
  print(tally, std::cout);
  return options.strict && failures > 0 ? 1 : 0;
}

int replay(const Options& options) {
  const WorkedCase worked = have_worked(options.file, kCaseSeconds);
  bool any = false;
  for (const Outcome& o : worked.outcomes) {
    std::cout << write_outcome(o).dump() << "\n";
    any = any || !o.valid();
  }
  return any ? 1 : 0;
}

void print_facts(const ModelFacts& facts, double length) {
  if (!facts.refused.empty()) {
    std::cout << "  refused: " << facts.refused << "\n";
    return;
  }
  const Measure& m = facts.measure;
  std::cout << "  in l: edge " << m.edge / length << ", face " << m.face / length << ", wall "
            << m.wall / length << ", gap " << m.gap / length << ", edges apart " << m.apart / length
            << "; angle " << m.angle << (m.tangent ? ", tangent" : "")
            << (m.coincident ? ", coincident" : "") << (m.film ? ", film" : "")
            << (m.wedge() ? ", wedge" : "") << (m.good_natured(length) ? ", good-natured" : "")
            << "\n";
}

int describe(const Options& options) {
  const RandomCase made = make_case(options.request(options.number), [](const CampaignCase&) {});
  const CampaignCase& c = made.campaign_case;
  std::cout << write_case(c).dump(1) << "\n";
  for (std::size_t k = 0; k < made.facts.size(); ++k) {
    std::cout << "model " << k << ": " << model_after(c, k).features.size() << " features\n";
    if (made.measured) print_facts(made.facts[k], made.length);
  }
  for (const auto& [reason, n] : made.discarded)
    std::cout << "discarded " << n << ": " << reason << "\n";
  return 0;
}

void add_case_options(CLI::App* command, Options& options) {
  command->add_option("--seed", options.seed, "of the campaign");
  CLI::Option* parts =
      command->add_flag("--parts", options.parts, "edits in loops of detailed parts");
  command->add_option("--nodes", options.part_nodes, "of the parts' first meshes")->needs(parts);
  command->add_flag("--even", options.even, "one edge length everywhere");
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Random models and edits, meshed and verified");
  app.require_subcommand(1);
  Options options;

  CLI::App* run_command = app.add_subcommand("run", "mesh and verify edits until there are enough");
  add_case_options(run_command, options);
  run_command->add_option("--edits", options.edits, "how many at least");
  run_command->add_option("--from", options.from, "the first case");
  run_command->add_option("--out", options.out, "folder for what failed");
  run_command->add_option("--json", options.json, "file for the figures");
  run_command->add_option("--jobs", options.jobs, "cases to work on at a time");
  run_command->add_option("--record", options.record, "file of the cases done, to go on with");
  run_command->add_option("--shrink", options.shrink_seconds, "seconds for each failure; 0: none");
  CLI::Option* gentle = run_command->add_flag("--good-natured", options.only_gentle,
                                              "only cases made to be good-natured");
  CLI::Option* others = run_command->add_flag("--others", options.only_others, "only the others");
  gentle->excludes(others)->excludes("--parts");
  others->excludes("--parts");
  run_command->add_flag("--keep-refusals", options.keep_refusals, "store refused edits too");
  run_command->add_flag("--keep-fallbacks", options.keep_fallbacks, "store edits that fell back");
  run_command->add_flag("--strict", options.strict, "exit with 1 where anything failed");
  run_command->add_flag("--verbose", options.verbose, "print every outcome");

  CLI::App* replay_command = app.add_subcommand("replay", "run a stored case");
  replay_command->add_option("file", options.file)->required();
  CLI::App* shrink_command = app.add_subcommand("shrink", "make a stored case smaller");
  shrink_command->add_option("file", options.file)->required();
  shrink_command->add_option("--seconds", options.shrink_seconds);
  CLI::App* describe_command = app.add_subcommand("describe", "print a case and its measures");
  add_case_options(describe_command, options);
  describe_command->add_option("--case", options.number);
  CLI::App* work_command = app.add_subcommand("work", "what the other commands start");
  add_case_options(work_command, options);
  work_command->add_option("--case", options.number);
  work_command->add_option("--file", options.file);
  CLI11_PARSE(app, argc, argv);

  if (*run_command) return run(options);
  if (*replay_command) return replay(options);
  if (*describe_command) return describe(options);
  if (*shrink_command) {
    std::cout << shrink_file(options.file, options.shrink_seconds).string() << "\n";
    return 0;
  }
  if (options.file.empty())
    work_on_request(options.request(options.number));
  else
    work_on_file(options.file);
  return 0;
} catch (const std::exception& failure) {
  std::cerr << "remesh-campaign: " << failure.what() << "\n";
  return 2;
}

#include "tests/bench/goals.h"

#include <array>
#include <limits>
#include <string_view>

#include "tests/bench/plot.h"

namespace remeshd::bench {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Goals of one case, as shares; kNone where there is none.
struct CaseGoals {
  std::string_view edit;
  double phi_15k, phi_30k;      ///< share of free nodes
  double paper_15k, paper_30k;  ///< remesh over the regular run as the paper has it
  double paper_stretch_30k;
};

constexpr std::array<CaseGoals, 7> kCases{{
    {"simple-ab", .17, .12, .100, .072, .05},
    {"tool1-ab", .17, .13, .122, .084, .07},
    {"tool1-ac", .28, .22, .180, .133, .10},
    {"tool2-ab", .165, .13, .295, .231, .10},
    {"tool2-bc", .13, .10, .318, .214, .10},
    {"tool2-cd", .165, .135, kNone, kNone, kNone},
    {"tool3-ab", .78, .71, kNone, kNone, .276},
}};

std::optional<double> given(double limit) {
  return limit == kNone ? std::nullopt : std::optional(limit);
}

/// The goals as they are added up.
class Judge {
 public:
  explicit Judge(const Results& results) : results_(results) {}

  std::vector<Goal> goals() && { return std::move(goals_); }

  template <class F>
  void add(const char* group, std::string_view name, std::uint32_t nodes, F&& measured,
           std::optional<double> limit, std::optional<double> stretch, Goal::Unit unit) {
    if (!limit && !stretch) return;
    const Group* found = results_.find(name, nodes);
    goals_.push_back({.group = group,
                      .where = std::string(name) + " " + tick_label(nodes),
                      .measured = found ? measured(*found) : std::nullopt,
                      .limit = limit,
                      .stretch = stretch,
                      .unit = unit});
  }

  void ratio(const char* group, std::string_view name, std::uint32_t nodes, const char* of,
             const char* to, std::optional<double> limit, std::optional<double> stretch,
             Goal::Unit unit = Goal::Unit::Ratio) {
    add(
        group, name, nodes, [&](const Group& g) { return g.ratio(of, to); }, limit, stretch, unit);
  }

  std::optional<double> phi(std::string_view name, std::uint32_t nodes) const {
    const Group* found = results_.find(name, nodes);
    if (!found) return {};
    return found->middle("remesh 10", [](const Sample& s) { return s.free_share; });
  }

  /// In proportion to what has to be done: limits that hang on phi.
  void proportion(std::string_view name, std::uint32_t nodes) {
    const std::optional<double> share = phi(name, nodes);
    goals_.push_back({.group = "remesh / regular, 10 iterations: 1.25 phi + 2 % (0.8 phi)",
                      .where = std::string(name) + " " + tick_label(nodes),
                      .unit = Goal::Unit::Percent});
    Goal& goal = goals_.back();
    if (!share) return;
    goal.measured = results_.find(name, nodes)->ratio("remesh 10", "regular 10");
    goal.limit = 1.25 * *share + 0.02;
    goal.stretch = 0.8 * *share;
  }

 private:
  const Results& results_;
  std::vector<Goal> goals_;
};

std::optional<double> bytes_per_node(const Group& g, const char* series, double Sample::*bytes) {
  return g.middle(series, [&](const Sample& s) { return s.*bytes / s.nodes; });
}

}  // namespace

Outcome Goal::outcome() const {
  if (!measured || (!limit && !stretch)) return Outcome::NotMeasured;
  if (stretch && *measured <= *stretch) return Outcome::StretchMet;
  return limit && *measured <= *limit ? Outcome::Met : Outcome::Missed;
}

std::vector<Goal> judge(const Results& results) {
  Judge judge(results);
  using Unit = Goal::Unit;
  for (const CaseGoals& c : kCases)
    judge.ratio("regular auto / HXT", c.edit, 15000, "regular auto", "hxt", 1.0, .5);
  for (const CaseGoals& c : kCases)
    judge.ratio("regular auto / HXT", c.edit, 100000, "regular auto", "hxt", 1.2, .5);
  for (const std::uint32_t nodes : {15000U, 30000U})
    for (const CaseGoals& c : kCases) judge.proportion(c.edit, nodes);
  for (const CaseGoals& c : kCases)
    judge.ratio("paper's regular run / HXT", c.edit, 15000, "paper 10", "hxt", 2.0, {});
  for (const CaseGoals& c : kCases)
    judge.ratio("remesh / paper's regular run, 10 iterations", c.edit, 15000, "remesh 10",
                "paper 10", given(c.paper_15k), {}, Unit::Percent);
  for (const CaseGoals& c : kCases)
    judge.ratio("remesh / paper's regular run, 10 iterations", c.edit, 30000, "remesh 10",
                "paper 10", given(c.paper_30k), given(c.paper_stretch_30k), Unit::Percent);
  judge.ratio("remesh / regular, 10 iterations", "simple-ab", 1'000'000, "remesh 10", "regular 10",
              .025, .015, Unit::Percent);
  judge.ratio("remesh auto / HXT", "tool1-ac", 15000, "remesh auto", "hxt", 1. / 4, 1. / 8);
  judge.ratio("remesh auto / HXT", "tool1-ac", 100000, "remesh auto", "hxt", 1. / 6, 1. / 15);
  for (const std::uint32_t nodes : {15000U, 30000U})
    for (const CaseGoals& c : kCases)
      judge.add(
          "phi, 10 iterations", c.edit, nodes,
          [&](const Group&) { return judge.phi(c.edit, nodes); },
          nodes == 15000 ? c.phi_15k : c.phi_30k, {}, Unit::Percent);
  for (const CaseGoals& c : kCases)
    judge.ratio("edit of a chain / single edit", c.edit, 15000, "chain", "single", 1.1, {});
  for (const char* edit : {"simple-ab", "tool1-ac"})
    judge.add(
        "peak of a regular run, a node", edit, 1'000'000,
        [](const Group& g) { return bytes_per_node(g, "regular 10", &Sample::peak_bytes); }, 1500,
        {}, Unit::Bytes);
  for (const CaseGoals& c : kCases)
    judge.add(
        "memory that stays with a revision, a node", c.edit, 15000,
        [](const Group& g) { return bytes_per_node(g, "chain", &Sample::retained_bytes); }, 600, {},
        Unit::Bytes);
  return std::move(judge).goals();
}

}  // namespace remeshd::bench

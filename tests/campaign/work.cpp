#include "tests/campaign/work.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tests/campaign/random_case.h"
#include "tests/support/child_process.h"

namespace remeshd::campaign {
namespace {

using nlohmann::json;

void print(const json& event) { std::cout << event.dump() << std::endl; }

json to_json(const StepFacts& f) {
  return {{"measured", f.measured},
          {"good_natured", f.good_natured},
          {"topology_changed", f.topology_changed},
          {"tangent", f.tangent},
          {"coincident", f.coincident},
          {"wedge", f.wedge},
          {"smallest", f.smallest},
          {"kind", f.kind},
          {"size", f.size},
          {"types", f.types}};
}

StepFacts facts_from(const json& j) {
  StepFacts f;
  j.at("measured").get_to(f.measured);
  j.at("good_natured").get_to(f.good_natured);
  j.at("topology_changed").get_to(f.topology_changed);
  j.at("tangent").get_to(f.tangent);
  j.at("coincident").get_to(f.coincident);
  j.at("wedge").get_to(f.wedge);
  j.at("smallest").get_to(f.smallest);
  j.at("kind").get_to(f.kind);
  j.at("size").get_to(f.size);
  j.at("types").get_to(f.types);
  return f;
}

std::vector<StepFacts> step_facts(const RandomCase& made) {
  std::vector<StepFacts> result;
  const CampaignCase& c = made.campaign_case;
  for (std::size_t k = 0; k < made.facts.size(); ++k) {
    const ModelFacts& now = made.facts[k];
    std::size_t base = k == 0 ? 0 : k - 1;
    while (base > 0 && c.steps[base - 1].undone) --base;
    const ModelFacts& before = made.facts[base];
    StepFacts f;
    f.measured = made.measured && now.refused.empty() && before.refused.empty();
    f.good_natured = f.measured && now.measure.good_natured(made.length) &&
                     before.measure.good_natured(made.length);
    f.topology_changed =
        now.refused.empty() && before.refused.empty() && now.topology != before.topology;
    f.tangent = now.measure.tangent;
    f.coincident = now.measure.coincident;
    f.wedge = made.measured && now.refused.empty() && now.measure.wedge();
    f.smallest = made.measured && now.refused.empty()
                     ? std::min(1e9, now.measure.smallest() / made.length)
                     : 0;
    if (k > 0) f.kind = c.steps[k - 1].kind;
    if (k > 0) f.size = c.steps[k - 1].size;
    for (const FeatureSource& feature : model_after(c, k).features) f.types.push_back(feature.type);
    result.push_back(std::move(f));
  }
  return result;
}

constexpr double kProcessorSeconds = 120;  // of a step

void run_and_print(const CampaignCase& c) {
  run_case(
      c,
      [](std::size_t step) {
        test::limit_processor_time(kProcessorSeconds);
        print({{"begin", step}});
      },
      [](const Outcome& outcome) {
        print({{"end", write_outcome(outcome)}});
      });
}

WorkedCase collect(const std::vector<std::string>& arguments, double seconds) {
  const test::ChildEnd worker = test::run_child(test::kThisProgram, arguments, seconds);
  WorkedCase worked;
  std::size_t begun = 0, ended = 0;
  std::istringstream lines(worker.output);
  for (std::string line; std::getline(lines, line);) {
    const json event = json::parse(line, nullptr, false);
    if (event.is_discarded()) continue;
    if (event.contains("looking")) worked.campaign_case = read_case(event.at("looking"));
    if (event.contains("case")) {
      worked.campaign_case = read_case(event.at("case"));
      worked.made = true;
      worked.gentle = event.value("gentle", false);
      if (event.contains("facts"))
        for (const json& f : event.at("facts")) worked.facts.push_back(facts_from(f));
      if (event.contains("discarded")) event.at("discarded").get_to(worked.discarded);
    }
    if (event.contains("begin")) begun = event.at("begin").get<std::size_t>() + 1;
    if (event.contains("end")) {
      worked.outcomes.push_back(read_outcome(event.at("end")));
      ended = worked.outcomes.back().step + 1;
    }
  }
  if (worker.exit_code != 0) throw std::runtime_error("a worker failed: " + worker.errors);
  if (worker.signal == 0 && !worker.too_long) return worked;
  Outcome crash;
  // While the case was made, the last model looked at is at fault.
  crash.step =
      worked.made ? (begun > ended ? begun - 1 : ended) : worked.campaign_case.steps.size();
  crash.kind = worker.too_long || worker.signal == SIGXCPU ? "hang" : "crash";
  crash.reason = crash.kind == "hang" ? "time" : ::strsignal(worker.signal);
  crash.message = worker.errors;
  worked.outcomes.push_back(crash);
  return worked;
}

}  // namespace

json write_worked(const WorkedCase& worked) {
  json facts = json::array(), outcomes = json::array();
  for (const StepFacts& f : worked.facts) facts.push_back(to_json(f));
  for (const Outcome& o : worked.outcomes) outcomes.push_back(write_outcome(o));
  return {{"case", write_case(worked.campaign_case)},
          {"gentle", worked.gentle},
          {"facts", facts},
          {"discarded", worked.discarded},
          {"outcomes", outcomes},
          {"made", worked.made}};
}

WorkedCase read_worked(const json& j) {
  WorkedCase worked;
  worked.campaign_case = read_case(j.at("case"));
  j.at("gentle").get_to(worked.gentle);
  for (const json& f : j.at("facts")) worked.facts.push_back(facts_from(f));
  j.at("discarded").get_to(worked.discarded);
  for (const json& o : j.at("outcomes")) worked.outcomes.push_back(read_outcome(o));
  j.at("made").get_to(worked.made);
  return worked;
}

void work_on_request(const CaseRequest& request) {
  const RandomCase made = make_case(request, [](const CampaignCase& c) {
    test::limit_processor_time(kProcessorSeconds);
    print({{"looking", write_case(c)}});
  });
  json facts = json::array();
  for (const StepFacts& f : step_facts(made)) facts.push_back(to_json(f));
  print({{"case", write_case(made.campaign_case)},
         {"gentle", made.gentle},
         {"facts", facts},
         {"discarded", made.discarded}});
  run_and_print(made.campaign_case);
}

void work_on_file(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot open " + file);
  const CampaignCase c = read_case(json::parse(in));
  print({{"case", write_case(c)}});
  run_and_print(c);
}

WorkedCase have_worked(const CaseRequest& request, double seconds) {
  std::vector<std::string> arguments{"remesh-campaign", "work"};
  const std::vector<std::string> which = request.arguments();
  arguments.insert(arguments.end(), which.begin(), which.end());
  return collect(arguments, seconds);
}

WorkedCase have_worked(const std::string& file, double seconds) {
  return collect({"remesh-campaign", "work", "--file", file}, seconds);
}

}  // namespace remeshd::campaign

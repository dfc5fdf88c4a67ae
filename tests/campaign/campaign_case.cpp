#include "tests/campaign/campaign_case.h"

#include <nlohmann/json.hpp>

#include "tests/support/documents.h"

namespace remeshd::campaign {

using nlohmann::json;

std::vector<std::string> CaseRequest::arguments() const {
  std::vector<std::string> result{"--seed", std::to_string(seed), "--case", std::to_string(number)};
  if (part_nodes) result.insert(result.end(), {"--parts", "--nodes", std::to_string(*part_nodes)});
  if (even) result.emplace_back("--even");
  return result;
}

ModelSource model_after(const CampaignCase& c, std::size_t k) {
  ModelSource model = c.model;
  for (std::size_t i = 0; i < k; ++i)
    if (!c.steps[i].undone || i + 1 == k) model = apply(model, c.steps[i].edit);
  return model;
}

json write_case(const CampaignCase& c) {
  json options{{"iterations", c.options.iterations},
               {"seed", c.options.seed},
               {"even", c.options.sizing.even}};
  if (c.options.nodes) options["nodes"] = *c.options.nodes;
  if (c.options.size) options["size"] = *c.options.size;
  json steps = json::array();
  for (const Step& step : c.steps)
    steps.push_back({{"kind", step.kind},
                     {"size", step.size},
                     {"undone", step.undone},
                     {"edit", test::write_edit(step.edit)}});
  return {{"seed", c.seed}, {"case", c.number},   {"part", c.part},
          {"note", c.note}, {"options", options}, {"model", test::write_model(c.model)},
          {"steps", steps}};
}

CampaignCase read_case(const json& j) {
  CampaignCase c;
  c.seed = j.value("seed", std::uint64_t{0});
  c.number = j.value("case", std::uint64_t{0});
  c.part = j.value("part", std::string());
  c.note = j.value("note", std::string());
  c.model = test::read_model(j.at("model"));
  const json& options = j.at("options");
  if (options.contains("nodes")) c.options.nodes = options.at("nodes").get<std::uint32_t>();
  if (options.contains("size")) c.options.size = options.at("size").get<double>();
  c.options.iterations = options.value("iterations", 0U);
  c.options.seed = options.value("seed", std::uint64_t{1});
  c.options.sizing.even = options.value("even", true);
  for (const json& step : j.at("steps"))
    c.steps.push_back({test::read_edit(step.at("edit")), step.value("kind", std::string()),
                       step.value("size", 0.0), step.value("undone", false)});
  return c;
}

}  // namespace remeshd::campaign

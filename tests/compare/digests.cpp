// What the engine makes of fixed models and edits, a line a mesh with a digest of its bytes:
// compare_builds.py compares the lines of two builds.
#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/remesh/remesh.h"
#include "engine/revision/storage/stored_revision.h"
#include "proto/checksum.h"
#include "tests/campaign/random_case.h"
#include "tests/support/cases.h"
#include "tests/support/chains.h"
#include "tests/support/strategy_name.h"

namespace remeshd::test {
namespace {

struct Options {
  std::vector<std::uint32_t> sizes{15000, 30000}, iterations{5, 10};
  std::vector<std::uint64_t> seeds{1, 2, 3};
  std::uint64_t campaign = 1;  ///< seed
  std::uint64_t campaign_cases = 200;
};

/// Digest of a revision's arrays: the documents beside them hold the report, which may learn to
/// tell more without a node being elsewhere.
std::string digest(const Revision& revision) {
  std::string bytes;
  const StoredArrays image = image_of(revision);
  for (const StoredArray& array : image.arrays)
    if (array.name != "documents") bytes += array.name + array.flat();
  return sha256_hex(bytes).substr(0, 24);
}

/// Prints a mesh's line, or why there is none. Returns whether there is one.
bool tell(const std::string& name, const std::function<const Revision&()>& make) {
  std::cout << name << ' ' << std::flush;
  try {
    const Revision& revision = make();
    std::cout << name_of(revision.report.strategy) << ' ' << revision.report.counts.nodes << ' '
              << digest(revision) << std::endl;
    return true;
  } catch (const Error& e) {
    std::cout << "refused " << e.info().reason << std::endl;
    return false;
  }
}

void tell_seven(const Options& options) {
  for (const EditCase& edit : seven_cases())
    for (const std::uint32_t nodes : options.sizes)
      for (const std::uint32_t iterations : options.iterations)
        for (const std::uint64_t seed : options.seeds) {
          const std::string name = edit.edit + ' ' + std::to_string(nodes) + ' ' +
                                   std::to_string(iterations) + ' ' + std::to_string(seed);
          Revision base, edited;
          if (!tell(name + " first", [&]() -> const Revision& {
                return base = make_revision(
                           Revision::none(), case_model(edit.original),
                           {.nodes = nodes, .iterations = iterations, .seed = seed}, {});
              }))
            continue;
          tell(name + " edit", [&]() -> const Revision& {
            return edited = make_revision(base, case_model(edit.modified),
                                          {.iterations = iterations, .seed = seed}, {});
          });
        }
}

void tell_chains() {
  for (const Chain& chain : chains_that_go_all_ways()) {
    ModelSource source = case_model(chain.model);
    Revision revision;
    int step = 0;
    const auto name = [&] { return "chain " + chain.model + ' ' + std::to_string(step++); };
    tell(name(), [&]() -> const Revision& {
      return revision = make_revision(Revision::none(), source, {.nodes = 1000}, {});
    });
    for (const Chain::Step& s : chain.steps) {
      parameter(source, s.parameter) = s.value;
      tell(name(), [&]() -> const Revision& {
        return revision = make_revision(revision, source, s.options, {});
      });
    }
  }
}

void tell_campaign(const Options& options) {
  for (std::uint64_t number = 0; number < options.campaign_cases; ++number) {
    const campaign::RandomCase random = campaign::make_case(options.campaign, number, [](auto&) {});
    const campaign::CampaignCase& c = random.campaign_case;
    MeshOptions inherited = c.options;
    inherited.nodes.reset();
    inherited.size.reset();
    Revision base;
    bool any = false;
    for (std::size_t k = 0; k <= c.steps.size(); ++k) {
      Revision made;
      const bool valid = tell("campaign " + std::to_string(number) + " step " + std::to_string(k),
                              [&]() -> const Revision& {
                                return made = make_revision(any ? base : Revision::none(),
                                                            campaign::model_after(c, k),
                                                            any ? inherited : c.options, {});
                              });
      if (valid) base = std::move(made);
      any |= valid;
      if (!any) break;
    }
  }
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Options options;
  CLI::App app{"Digests of the meshes that the engine makes of fixed models and edits"};
  app.add_option("--sizes", options.sizes, "nodes of the seven cases");
  app.add_option("--iterations", options.iterations);
  app.add_option("--seeds", options.seeds);
  app.add_option("--campaign", options.campaign, "seed of the campaign");
  app.add_option("--campaign-cases", options.campaign_cases);
  CLI11_PARSE(app, argc, argv);
  remeshd::test::tell_chains();
  remeshd::test::tell_seven(options);
  remeshd::test::tell_campaign(options);
  return 0;
}

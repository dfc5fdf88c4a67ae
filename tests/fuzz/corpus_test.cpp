#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/fuzz/targets.h"

namespace remeshd::fuzz {
namespace {

namespace fs = std::filesystem;

class Corpus : public testing::TestWithParam<Target> {};

void run(const Target& target, const std::string& bytes, const std::string& name) {
  try {
    target.run(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  } catch (const std::exception& finding) {
    ADD_FAILURE() << name << ": " << finding.what();
  }
}

TEST_P(Corpus, HasNoFinding) {
  const fs::path folder = fs::path(REMESHD_FUZZ_CORPUS) / GetParam().name;
  int files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    std::stringstream bytes;
    bytes << in.rdbuf();
    run(GetParam(), bytes.str(), entry.path().filename().string());
    ++files;
  }
  EXPECT_GT(files, 0);
}

TEST_P(Corpus, CanBeBegunAnewFromSeeds) {
  const Seeds seeds = GetParam().seeds();
  EXPECT_FALSE(seeds.empty());
  for (const std::string& seed : seeds) run(GetParam(), seed, seed.substr(0, 100));
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, testing::ValuesIn(kTargets),
                         [](const auto& target) { return target.param.name; });

}  // namespace
}  // namespace remeshd::fuzz

#include "tests/campaign/random_case.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/model/feature_model.h"

namespace remeshd::campaign {
namespace {

RandomCase make(std::uint64_t seed, std::uint64_t number) {
  return make_case(seed, number, [](const CampaignCase&) {});
}

TEST(RandomCase, IsTheSameForTheSameSeedAndNumber) {
  for (std::uint64_t k = 0; k < 2; ++k)
    EXPECT_EQ(write_case(make(5, k).campaign_case), write_case(make(5, k).campaign_case));
  EXPECT_NE(write_case(make(5, 0).campaign_case), write_case(make(6, 0).campaign_case));
}

TEST(RandomCase, KeepsItsWordWhereItIsGentle) {
  for (std::uint64_t k = 0; k < 3; ++k) {
    const RandomCase made = make(7, k);
    ASSERT_EQ(made.facts.size(), made.campaign_case.steps.size() + 1);
    for (const ModelFacts& facts : made.facts)
      if (made.gentle && facts.refused.empty()) {
        EXPECT_TRUE(facts.measure.good_natured(made.length)) << "case " << k;
      }
  }
}

TEST(RandomCase, HasThreeToFortyFeaturesAndValidDocuments) {
  for (std::uint64_t k = 0; k < 4; ++k) {
    const CampaignCase c = make(8, k).campaign_case;
    for (std::size_t step = 0; step <= c.steps.size(); ++step) {
      const ModelSource model = model_after(c, step);
      EXPECT_GE(model.features.size(), 3U);
      EXPECT_LE(model.features.size(), 45U);
      EXPECT_NO_THROW(evaluate(model)) << "case " << k << " step " << step;
    }
  }
}

TEST(CampaignCase, ComesBackFromItsFile) {
  for (std::uint64_t k = 0; k < 4; ++k) {
    const nlohmann::json document = write_case(make(9, k).campaign_case);
    EXPECT_EQ(write_case(read_case(nlohmann::json::parse(document.dump()))), document);
  }
}

}  // namespace
}  // namespace remeshd::campaign

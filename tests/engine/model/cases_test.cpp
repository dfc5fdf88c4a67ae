#include <gtest/gtest.h>

#include "tests/support/cases.h"

namespace remeshd {
namespace {

TEST(Cases, EveryEditTakesItsModelToTheNextOne) {
  ASSERT_EQ(test::seven_cases().size(), 7U);
  for (const test::EditCase& c : test::seven_cases()) {
    const ModelSource edited = apply(test::case_model(c.original), test::case_edit(c.edit));
    EXPECT_TRUE(same_geometry(evaluate(edited), test::case_features(c.modified))) << c.edit;
    EXPECT_FALSE(same_geometry(evaluate(edited), test::case_features(c.original))) << c.edit;
  }
}

}  // namespace
}  // namespace remeshd

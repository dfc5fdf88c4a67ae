#include "server/session/recipe.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

Recipe recipe_with_everything() {
  Recipe recipe{.revision = std::string(64, 'a'),
                .parent = std::string(64, 'b'),
                .algorithm_version = 13,
                .model = case_model("tool2-b"),
                .edit = "{\"edits\": []}"};
  recipe.model.parameters.push_back({.name = "p",
                                     .value = 1.0 / 3,
                                     .lower = -0.0,
                                     .upper = 1e300,
                                     .integer = true,
                                     .unit = "mm",
                                     .description = "a \"p\"\n"});
  recipe.model.parameters.push_back({.name = "q", .value = std::string("2*p")});
  FeatureSource prism = feature("prism", "prism", {point(0.0, 0.0), arc(1.0, 0.0, 0.5, "p")}, {});
  prism.reference = std::array<Scalar, 3>{1.0, std::string("p"), 0.1};
  prism.placement.z_axis = {0.0, 1.0, 0.0};
  prism.placement.x_axis = {1.0, 0.0, 0.0};
  recipe.model.features.push_back(prism);
  recipe.model.features.back().nature = Nature::Subtractive;
  recipe.model.features.push_back(block("last", 1, 2, 3));
  recipe.model.features.back().reference = ReferenceKind::Centre;
  recipe.model.sizes = {{"holes", "hole*.wall", "radius/4"},
                        {"spot", BallSource{1.0, "p", 0.1, 2.0}, 0.5},
                        {"end", BoxSource{0.0, 0.0, 0.0, 1.0, 2.0, "q"}, 1.0 / 3}};
  recipe.model.groups = {{"load", "pin*.top", {.max_area_change = 0.1, .fail_emptied = true}},
                         {"rest", "not load"}};
  recipe.options.size = 0.1;
  recipe.options.seed = ~std::uint64_t{0};
  recipe.options.inside = MeshOptions::Inside::ControlMesh;
  recipe.options.start = MeshOptions::Start::Random;
  recipe.options.rebuild = true;
  recipe.options.threshold = 0.45;
  recipe.options.order = 2;
  recipe.options.sizing = {
      .even = false, .edges_per_circle = 20, .layers = 0, .min_size = 1.0 / 3, .growth = 1.1};
  recipe.digests = {{ArrayName::Nodes, std::string(64, 'c')}, {ArrayName::Tets, "d"}};
  return recipe;
}

TEST(RecipeText, ComesBackToTheBit) {
  const Recipe recipe = recipe_with_everything();
  EXPECT_EQ(read_recipe(write_recipe(recipe)), recipe);
  EXPECT_EQ(read_recipe(write_recipe({})), Recipe());
}

TEST(RecipeText, OfAModelWithoutSizesIsThatOfBeforeThereWereAny) {
  Recipe recipe = recipe_with_everything();
  EXPECT_NE(write_recipe(recipe).find("\"sizes\""), std::string::npos);
  recipe.model.sizes.clear();
  EXPECT_EQ(write_recipe(recipe).find("\"sizes\""), std::string::npos);
  EXPECT_EQ(read_recipe(write_recipe(recipe)), recipe);
}

TEST(RecipeText, OfAModelWithoutGroupsIsThatOfBeforeThereWereAny) {
  Recipe recipe = recipe_with_everything();
  EXPECT_NE(write_recipe(recipe).find("\"groups\""), std::string::npos);
  recipe.model.groups.clear();
  EXPECT_EQ(write_recipe(recipe).find("\"groups\""), std::string::npos);
  EXPECT_EQ(read_recipe(write_recipe(recipe)), recipe);
}

TEST(RecipeText, OfTheFirstOrderIsThatOfBeforeThereWasASecond) {
  Recipe recipe = recipe_with_everything();
  EXPECT_NE(write_recipe(recipe).find("\"order\""), std::string::npos);
  recipe.options.order = 1;
  EXPECT_EQ(write_recipe(recipe).find("\"order\""), std::string::npos);
  EXPECT_EQ(read_recipe(write_recipe(recipe)), recipe);
}

TEST(RecipeText, OfAnEvenMeshIsThatOfBeforeThereWereSizes) {
  Recipe recipe = recipe_with_everything();
  EXPECT_NE(write_recipe(recipe).find("sizing"), std::string::npos);
  recipe.options.sizing = {};
  EXPECT_EQ(write_recipe(recipe).find("sizing"), std::string::npos);
  EXPECT_TRUE(read_recipe(write_recipe(recipe)).options.sizing.even);
  recipe.options.sizing = {.even = false};
  EXPECT_EQ(read_recipe(write_recipe(recipe)), recipe) << "without a least size";
}

TEST(RecipeText, ThatIsNoneIsAnError) {
  EXPECT_THROW(read_recipe(""), Error);
  EXPECT_THROW(read_recipe("{}"), Error);
  std::string other = write_recipe(recipe_with_everything());
  other.replace(other.find("\"format\":1"), 10, "\"format\":2");
  EXPECT_THROW(read_recipe(other), Error);
}

TEST(RecipeText, HasTheDigestsOfWhatIsDelivered) {
  HeldRevision held;
  held.revision.output.mesh.nodes.push_back({1, 2, 3});
  EXPECT_TRUE(recipe_of(held).digests.empty()) << "its options are not known";
  held.asked.emplace();
  const auto arrays = mesh_arrays(held.revision.output);
  const Recipe recipe = recipe_of(held);
  ASSERT_EQ(recipe.digests.size(), arrays.size());
  for (std::size_t i = 0; i < arrays.size(); ++i)
    EXPECT_EQ(recipe.digests[i].digest, digest_of(arrays[i]).whole);
}

}  // namespace
}  // namespace remeshd::test

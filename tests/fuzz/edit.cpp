// Edit documents as text, applied to a model with a feature of each type.
#include "proto/document.h"
#include "tests/fuzz/documents.h"
#include "tests/fuzz/targets.h"

int fuzz_edit(const std::uint8_t* data, std::size_t size) {
  using namespace remeshd;
  try {
    fuzz::check_edit(parse_edit({reinterpret_cast<const char*>(data), size}));
  } catch (const DocumentError& error) {
    fuzz::expect_in_words(error);
  } catch (const Error& error) {
    fuzz::expect_in_words(error);
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::edit_seeds() {
  Seeds seeds = case_documents(true);
  for (
      const char* edit : {
          R"({"setParameter": {"name": "r", "value": "h/3"}})",
          R"({"setParameter": {"name": "n", "value": 7}})",
          R"({"setFeatureParameter": {"feature": "hole", "name": "radius", "value": 2.5}})",
          R"({"setFeatureParameter": {"feature": "bar", "name": "profile", "value": [[0, 0], [8, 0], {"to": [8, 4], "through": [10, 2]}, [0, 5]]}})",
          R"({"setPlacement": {"feature": "ring", "placement": {"origin": [1, 2, "h"], "zAxis": [0, 1, 0], "xAxis": [0, 0, 1]}}})",
          R"({"removeFeature": {"feature": "cut"}})",
          R"({"addFeature": {"feature": {"id": "new", "nature": "SUBTRACTIVE", "type": "sphere", "parameters": {"radius": "r"}, "placement": {"origin": [0, 0, 0]}, "reference": "CENTRE"}, "after": "plate"}})",
      })
    seeds.push_back(std::string(R"({"edits": [)") + edit + "]}");
  return seeds;
}

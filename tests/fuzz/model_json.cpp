// Documents of models and edits as text: `remesh validate`, and requests that carry a document.
#include <string_view>

#include "proto/document.h"
#include "tests/fuzz/documents.h"
#include "tests/fuzz/targets.h"

namespace {

struct Check {
  void operator()(const remesh::v1::FeatureModel& model) const {
    remeshd::fuzz::check_model(model);
  }
  void operator()(const remesh::v1::ModelEdit& edit) const { remeshd::fuzz::check_edit(edit); }
};

}  // namespace

int fuzz_model_json(const std::uint8_t* data, std::size_t size) {
  using namespace remeshd;
  try {
    std::visit(Check(), parse_document({reinterpret_cast<const char*>(data), size}));
  } catch (const DocumentError& error) {
    fuzz::expect_in_words(error);
  } catch (const Error& error) {
    fuzz::expect_in_words(error);
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::model_json_seeds() {
  Seeds seeds = case_documents(false);
  seeds.emplace_back(kModelOfEveryType);
  return seeds;
}

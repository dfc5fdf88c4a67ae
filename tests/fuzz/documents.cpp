#include "tests/fuzz/documents.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/model/feature_model.h"
#include "engine/model/solid.h"
#include "engine/remesh/node_limit.h"
#include "proto/document.h"
#include "proto/json_writer.h"
#include "server/service/decode_model.h"
#include "server/service/encode_model.h"
#include "server/session/recipe.h"

namespace remeshd::fuzz {
namespace {

namespace v1 = remesh::v1;

void check_solids(const FeatureModel& model) {
  for (const Feature& feature : model.features) {
    const Box box = world_bounds(feature);
    for (const auto& [lo, hi] : {std::pair(box.lo.x, box.hi.x), std::pair(box.lo.y, box.hi.y),
                                 std::pair(box.lo.z, box.hi.z)})
      expect(std::isfinite(lo) && std::isfinite(hi) && lo <= hi, "a box that is none");
    const double volume = volume_of(feature.shape);
    expect(std::isfinite(volume) && volume >= 0, "a volume that is none");
    expect(!faces_of(feature).empty(), "a feature without faces");
  }
  const Membership membership(model);
  for (const Feature& feature : model.features) {
    const Box box = world_bounds(feature);
    for (const Vec3& p : {box.lo, box.hi, 0.5 * (box.lo + box.hi)}) {
      std::vector<int> owners;
      membership.owners(p, owners);
      expect(membership.last_owner(p) == (owners.empty() ? -1 : owners.back()),
             "two answers to who owns a point");
      expect(std::ranges::is_sorted(owners), "owners that are not in history order");
    }
  }
}

void check_evaluated(const ModelSource& source) {
  const FeatureModel model = evaluate(source);
  expect(model.features.size() == source.features.size(), "a feature got lost");
  expect(same_geometry(model, evaluate(source)), "a model that is evaluated in two ways");
  check_solids(model);
  const double nodes =
      check_node_limit(Revision::none(), model, {.size = 1.0}, {.max_nodes = 100000});
  expect(nodes >= 0 && nodes <= 100000, "a number of nodes that is none");
}

void check_source(const ModelSource& source) {
  expect(decode(encode(source)) == source, "a model is not what was encoded");
  expect(read_recipe(write_recipe({.model = source})).model == source,
         "a recipe has another model than was written");
}

}  // namespace

const char* const kModelOfEveryType = R"json({
  "name": "every", "unit": "mm",
  "parameters": {"r": 3, "h": "2*r + sin(pi/2)",
                 "n": {"value": 4, "lower": 1, "upper": 9, "integer": true}},
  "features": [
    {"id": "plate", "nature": "ADDITIVE", "type": "block",
     "parameters": {"dx": 80, "dy": 40, "dz": "h"}, "placement": {"origin": [0, 0, 0]}},
    {"id": "hole", "nature": "SUBTRACTIVE", "type": "cylinder", "reference": "CENTRE",
     "parameters": {"radius": "r", "height": 10}, "placement": {"origin": ["n*4", 0, 0]}},
    {"id": "tip", "nature": "ADDITIVE", "type": "cone",
     "parameters": {"radius_bottom": 5, "radius_top": 0, "height": 10},
     "placement": {"origin": [0, 0, 5], "zAxis": [0, 1, 1], "xAxis": [1, 0, 0]}},
    {"id": "ball", "nature": "ADDITIVE", "type": "sphere",
     "parameters": {"radius": 4}, "placement": {"origin": [20, 0, 5]}},
    {"id": "ring", "nature": "ADDITIVE", "type": "torus",
     "parameters": {"major_radius": 6, "minor_radius": 2}, "placement": {"origin": [-20, 0, 5]}},
    {"id": "bar", "nature": "ADDITIVE", "type": "prism",
     "parameters": {"height": 7,
                    "profile": [[0, 0], [8, 0], {"to": [8, "r"], "through": [10, 1]}, [0, 5]]},
     "placement": {"origin": [0, 10, 0]}},
    {"id": "disc", "nature": "ADDITIVE", "type": "revolution", "referencePoint": [0, 0, 1],
     "parameters": {"angle": 270, "profile": [[2, 0], [6, 0], [6, 3], [2, 3]]},
     "placement": {"origin": [0, -10, 0]}},
    {"id": "cut", "nature": "SUBTRACTIVE", "type": "slot",
     "parameters": {"length": 12, "width": 4, "height": 9}, "placement": {"origin": [0, 0, 0]}}]})json";

const ModelSource& source_of_every_type() {
  static const ModelSource source = decode(parse_model(kModelOfEveryType));
  return source;
}

void check_model(const v1::FeatureModel& message) {
  const ModelSource source = decode(message);
  check_evaluated(source);
  // All has been looked at: what is kept of it is a document that any daemon takes.
  const std::string text = write_document(message);
  const v1::FeatureModel again = parse_model(text);
  expect(decode(again) == source, "a document that was written is another model");
  expect(write_document(again) == text, "a document that is written in two ways");
  check_source(source);
}

void check_edit(const v1::ModelEdit& message) {
  const ModelSource& base = source_of_every_type();
  static const FeatureModel base_model = evaluate(base);
  const ModelEdit edit = decode(message);
  ModelSource edited;
  try {
    edited = apply(base, edit);
  } catch (const Error& why) {
    const auto index = why.info().edit_index;
    expect(!index || (*index >= 0 && *index < static_cast<int>(edit.edits.size())),
           "an error of an edit that is not there");
    throw;
  }
  const FeatureModel model = evaluate(edited);
  // Only an edit that is right is kept.
  const std::string text = write_document(message);
  expect(write_document(parse_edit(text)) == text, "an edit that is written in two ways");
  expect(apply(base, decode(parse_edit(text))) == edited, "an edit that was written is another");
  check_source(edited);
  expect(motion_bound(base_model, model) >= 0, "a motion that is none");
  expect(motion_bound(base_model, model) == motion_bound(model, base_model),
         "a motion that is longer one way");
  expect(same_geometry(base_model, model) == same_geometry(model, base_model),
         "a model like another that is not like it");
  check_solids(model);
}

std::vector<std::string> case_documents(bool edits) {
  std::vector<std::string> texts;
  for (const auto& file : std::filesystem::directory_iterator(REMESHD_CASES_DIR)) {
    if (file.path().extension() != ".json") continue;
    if (file.path().string().ends_with(".edit.json") != edits) continue;
    texts.push_back(read_document(file.path()));
  }
  std::ranges::sort(texts);
  return texts;
}

}  // namespace remeshd::fuzz

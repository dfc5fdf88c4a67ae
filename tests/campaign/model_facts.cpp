#include "tests/campaign/model_facts.h"

#include "engine/base/error.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/feature_model.h"
#include "engine/model/solid.h"
#include "engine/nodes/density.h"
#include "tests/campaign/contacts.h"

namespace remeshd::campaign {
namespace {
constexpr double kSpacing = 0.7;  // of points to measure at, in l
}

ModelFacts find_facts(const ModelSource& source, double length, double nodes) {
  ModelFacts facts;
  try {
    const FeatureModel model = evaluate(source);
    const CellularModel cells = build_cells(model, Run{});
    facts.volume = cells.volume;
    facts.area = cells.area;
    if (length == 0) length = edge_length_for(cells.volume, cells.area, nodes);
    facts.measure = measure(model, cells.boundary, kSpacing * length);
    facts.topology = topology(cells.boundary);
  } catch (const Error& failure) {
    facts.refused = failure.info().reason;
    if (rightly_refused(facts)) return facts;
    // Without cells, what the features' own surfaces tell.
    const FeatureModel model = evaluate(source);
    const Contacts contacts = find_contacts(model, Membership(model));
    facts.measure.tangent = contacts.tangent > 0;
    facts.measure.coincident = contacts.coincident > 0;
    facts.measure.film = contacts.film > 0;
  }
  return facts;
}

bool rightly_refused(const ModelFacts& facts) {
  return !facts.refused.empty() && facts.refused != "KERNEL_FAILURE";
}

}  // namespace remeshd::campaign

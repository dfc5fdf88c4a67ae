#include "tests/campaign/parts/part_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/base/error.h"
#include "engine/cellular/cellular_model.h"
#include "tests/campaign/parts/drawing.h"
#include "tests/campaign/parts/drawn_part.h"
#include "tests/campaign/parts/part_edit.h"
#include "tests/support/cases.h"

namespace remeshd::campaign {
namespace {

constexpr double kDetailed = 0.3;  // share of cases
constexpr int kChangeTries = 30;   // in a row that come to nothing, before the loop ends
constexpr double kEffect = 1e-9;   // of the part's size: an edit that changes less changes nothing

std::uint64_t seed_of(const CaseRequest& request) {
  Random random(request.seed * 0x9E3779B97F4A7C15ULL + request.number);
  random.next();
  return random.next();
}

class PartCaseMaker {
 public:
  PartCaseMaker(const CaseRequest& request,
                const std::function<void(const CampaignCase&)>& before_look)
      : before_look_(before_look), random_(seed_of(request)) {
    CampaignCase& c = made_.campaign_case;
    c.seed = request.seed;
    c.number = request.number;
    c.options.seed = 1 + random_.below(1000);
    c.options.nodes = request.part_nodes;
    made_.measured = false;
  }

  RandomCase operator()() {
    begin();
    const std::size_t wanted = 10 + random_.below(11);
    for (int tries = 0; made_.campaign_case.steps.size() < wanted && tries < kChangeTries;) {
      const std::size_t before = made_.campaign_case.steps.size();
      change(wanted - before);
      tries = made_.campaign_case.steps.size() > before ? 0 : tries + 1;
    }
    return std::move(made_);
  }

 private:
  /// What a model is found to be, if it may be used.
  struct Found {
    ModelFacts facts;
    Drawing drawing;
    Vec3 edges;  ///< sum of the points of all edges, which tells boundaries apart
    double size = 0;

    [[nodiscard]] bool same_boundary(const Found& other) const {
      const double length = kEffect * size;
      return std::fabs(facts.volume - other.facts.volume) < length * size * size &&
             std::fabs(facts.area - other.facts.area) < length * size &&
             distance(edges, other.edges) < length;
    }
  };

  void discard(const std::string& reason) { ++made_.discarded[reason]; }

  /// Nothing where the model is rightly refused.
  std::optional<Found> look(const ModelSource& source) {
    Found found;
    try {
      const FeatureModel model = evaluate(source);
      const CellularModel cells = build_cells(model, Run{});
      found.facts.volume = cells.volume;
      found.facts.area = cells.area;
      found.facts.topology = topology(cells.boundary);
      found.size = cells.boundary.bounds.diagonal();
      for (const BoundaryEdge& edge : cells.boundary.edges)
        for (const Vec3& p : edge.points) found.edges += p;
      found.drawing = look_at_drawing(model, cells.boundary);
    } catch (const Error& failure) {
      found.facts.refused = failure.info().reason;
      if (rightly_refused(found.facts)) {
        discard(found.facts.refused);
        return {};
      }
    }
    return found;
  }

  void begin() {
    CampaignCase& c = made_.campaign_case;
    const bool detailed = random_.uniform() < kDetailed;
    for (;;) {
      if (detailed) {
        c.part = test::detailed_parts()[random_.below(test::detailed_parts().size())];
        c.model = test::case_model("detailed/" + c.part);
      } else {
        DrawnPart drawn = draw_part(random_.next(), *c.options.nodes);
        c.part = std::move(drawn.body);
        c.model = std::move(drawn.model);
      }
      before_look_(c);
      const std::optional<Found> found = look(c.model);
      const bool drawn_well = detailed || (found && found->drawing.as_good_as({}));
      if (found && found->facts.refused.empty() && drawn_well) {
        now_ = *found;
        made_.facts = {now_.facts};
        break;
      }
      if (found) discard(found->facts.refused.empty() ? "drawn badly" : found->facts.refused);
    }
    last_ = c.model;
    if (detailed && random_.uniform() < 0.5)
      take({test::case_edit("detailed/" + c.part), "given", 0}, true);
  }

  /// Adds a step if its model can be used; returns whether a further one may follow it.
  bool take(Step step, bool however_drawn) {
    CampaignCase next = made_.campaign_case;
    next.steps.push_back(step);
    const ModelSource model = apply(last_, step.edit);
    before_look_(next);
    const std::optional<Found> found = look(model);
    if (!found) return false;
    const bool usable = found->facts.refused.empty();
    if (usable && !however_drawn && !found->drawing.as_good_as(now_.drawing)) {
      discard("drawn badly");
      return false;
    }
    if (usable && found->same_boundary(now_)) {
      discard("without effect");
      return false;
    }
    next.steps.back().undone = !usable;
    made_.campaign_case = std::move(next);
    made_.facts.push_back(found->facts);
    if (!usable) return false;
    now_ = *found;
    last_ = model;
    return true;
  }

  void change(std::size_t most) {
    // Of ten: three drifts, two sweeps, two jumps, and one of each of the others.
    using enum Change;
    static constexpr std::array<Change, 10> kChanges{Drift, Drift, Drift, Sweep,    Sweep,
                                                     Jump,  Jump,  Move,  Addition, Removal};
    const Change kind = kChanges[random_.below(kChanges.size())];
    try {
      const ChangeSteps steps = random_change(last_, kind, random_, serial_);
      for (std::size_t k = 0; k < std::min(most, steps.edits.size()); ++k)
        if (!take({steps.edits[k], kChangeNames[static_cast<std::size_t>(kind)], steps.sizes[k]},
                  false))
          return;
    } catch (const Error& failure) {
      discard(failure.info().reason);
    }
  }

  const std::function<void(const CampaignCase&)>& before_look_;
  Random random_;
  int serial_ = 0;
  ModelSource last_;  ///< after all steps but those undone
  Found now_;         ///< of it
  RandomCase made_;
};

}  // namespace

RandomCase make_part_case(const CaseRequest& request,
                          const std::function<void(const CampaignCase&)>& before_look) {
  return PartCaseMaker(request, before_look)();
}

}  // namespace remeshd::campaign

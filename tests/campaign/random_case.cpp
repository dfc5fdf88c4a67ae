#include "tests/campaign/random_case.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "engine/base/error.h"
#include "engine/nodes/density.h"
#include "tests/campaign/bodies.h"
#include "tests/campaign/mean_features.h"
#include "tests/campaign/parts/part_case.h"
#include "tests/campaign/random_edit.h"
#include "tests/campaign/site_features.h"

namespace remeshd::campaign {
namespace {

constexpr double kGentle = 0.59;  // share of cases
constexpr int kModelTries = 40;   // before a gentle model is made mean
constexpr int kEditTries = 12;    // before the chain ends

void fill_sites(Draft& d, double share) {
  for (const std::size_t site : free_sites(d))
    if (d.model.features.size() < 38 && d.chance(share)) add_on_site(d, site);
}

void add_troubles(Draft& d) {
  if (d.sites.empty()) return;
  const auto add = [&](Trouble family) {
    add_trouble(d, family, d.sites[d.random.below(d.sites.size())]);
  };
  // The three that the campaign promises, then anything.
  if (d.chance(0.45)) add(Trouble::Tangent);
  if (d.chance(0.35)) add(Trouble::Coincident);
  if (d.chance(0.45)) add(Trouble::Wedge);
  for (std::uint64_t n = d.random.below(d.chance(0.25) ? 16 : 3); n > 0; --n)
    add(static_cast<Trouble>(d.random.below(kTroubles)));
}

/// Turns and moves the whole model, if it is all numbers where it counts.
void place_anywhere(Draft& d) {
  Transform motion = random_rotation(d.random);
  if (d.chance(0.5))
    motion = Transform::translation({d.length * d.random.uniform(-200, 200),
                                     d.length * d.random.uniform(-200, 200),
                                     d.length * d.random.uniform(-200, 200)}) *
             motion;
  const FeatureModel now = evaluate(d.model);
  for (std::size_t k = 0; k < now.features.size(); ++k)
    d.model.features[k].placement = placement_of(motion * now.features[k].placement);
  for (Site& site : d.sites) site.frame = motion * site.frame;
}

/// Throws Error where it comes to nothing.
Draft draft_model(std::uint64_t seed, bool gentle) {
  Draft d(seed);
  d.random.next();
  d.dense = d.chance(0.15);
  d.nodes = std::floor(d.random.uniform(d.dense ? 4500 : 2000, 5000));
  d.model.name = "campaign";
  d.model.unit = "mm";
  add_body(d);
  fill_sites(d, gentle || d.dense ? d.random.uniform(0.35, 0.8) : d.random.uniform(0, 1));
  // Else the first edit brings it: where trouble keeps the first mesh from being made, no edit of
  // the model is ever seen.
  if (!gentle && d.chance(0.2)) add_troubles(d);
  while (d.model.features.size() < 3) {
    if (free_sites(d).empty()) throw error::no_features();
    const std::size_t before = d.model.features.size();
    fill_sites(d, 1);
    if (d.model.features.size() == before) throw error::no_features();
  }
  if (d.model.features.size() > 40) throw error::no_features();
  if (d.chance(0.35)) place_anywhere(d);
  return d;
}

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  Random random(a * 0x9E3779B97F4A7C15ULL + b);
  return random.next();
}

class CaseMaker {
 public:
  CaseMaker(std::uint64_t seed, std::uint64_t number,
            const std::function<void(const CampaignCase&)>& before_look)
      : before_look_(before_look), seed_(mix(seed, number)) {
    made_.campaign_case.seed = seed;
    made_.campaign_case.number = number;
  }

  RandomCase operator()() {
    Random random(seed_);
    made_.gentle = random.uniform() < kGentle;  // as is_gentle
    std::optional<Draft> draft;
    for (std::uint64_t k = 0; !draft; ++k) {
      if (k == kModelTries) made_.gentle = false;
      draft = try_model(mix(seed_, k));
    }
    const int steps = 4 + static_cast<int>(random.below(3));
    for (int k = 0; k < steps && made_.facts.front().refused.empty(); ++k)
      if (!add_step(*draft)) break;
    return std::move(made_);
  }

 private:
  void discard(const std::string& reason) { ++made_.discarded[reason]; }

  /// Facts of the model where it is to be used.
  std::optional<ModelFacts> look(const ModelSource& model, double nodes) {
    ModelFacts facts = find_facts(model, made_.length, nodes);
    if (rightly_refused(facts)) {
      discard(facts.refused);
      return {};
    }
    if (!facts.refused.empty()) return facts;
    const double l =
        made_.length > 0 ? made_.length : edge_length_for(facts.volume, facts.area, nodes);
    if (made_.gentle && !facts.measure.good_natured(l)) {
      discard("not good-natured");
      return {};
    }
    return facts;
  }

  std::optional<Draft> try_model(std::uint64_t seed) {
    try {
      Draft d = draft_model(seed, made_.gentle);
      CampaignCase& c = made_.campaign_case;
      c.model = d.model;
      c.options.nodes = static_cast<std::uint32_t>(d.nodes);
      c.options.seed = 1 + seed % 1000;
      before_look_(c);
      const std::optional<ModelFacts> facts = look(d.model, d.nodes);
      if (!facts) return {};
      if (facts->refused.empty())
        d.length = made_.length = edge_length_for(facts->volume, facts->area, d.nodes);
      made_.facts = {*facts};
      return d;
    } catch (const Error& failure) {
      discard(failure.info().reason);
      return {};
    }
  }

  /// False where no edit came to anything.
  bool add_step(Draft& draft) {
    std::size_t kind = 0;
    for (int k = 0; k < kEditTries; ++k) {
      // The same kind again for a while, else those that rarely succeed become rare.
      if (k % 8 == 0) kind = draft.random.below(kEditKinds.size());
      if (k < 8 && !made_.gentle && !troubled_) kind = kAddFeature;
      Draft trial = draft;
      trial.may_add_parameters = false;
      draft.random.next();
      try {
        const RandomEdit edit = random_edit(trial, kind, made_.gentle);
        CampaignCase next = made_.campaign_case;
        next.steps.push_back({edit.edit, edit.kind, edit.size});
        before_look_(next);
        std::optional<ModelFacts> facts = look(trial.model, trial.nodes);
        if (!facts) continue;
        const bool usable = facts->refused.empty();
        next.steps.back().undone = !usable;
        made_.campaign_case = std::move(next);
        made_.facts.push_back(std::move(*facts));
        if (usable) {
          draft = std::move(trial);
          troubled_ = troubled_ || kind == kAddFeature;
        }
        return true;
      } catch (const Error& failure) {
        discard(failure.info().reason);
      }
    }
    return false;
  }

  const std::function<void(const CampaignCase&)>& before_look_;
  std::uint64_t seed_;
  bool troubled_ = false;  ///< a mean case has had its trouble
  RandomCase made_;
};

}  // namespace

bool is_gentle(std::uint64_t seed, std::uint64_t number) {
  return Random(mix(seed, number)).uniform() < kGentle;
}

RandomCase make_case(std::uint64_t seed, std::uint64_t number,
                     const std::function<void(const CampaignCase&)>& before_look) {
  return CaseMaker(seed, number, before_look)();
}

RandomCase make_case(const CaseRequest& request,
                     const std::function<void(const CampaignCase&)>& before_look) {
  RandomCase made = request.part_nodes ? make_part_case(request, before_look)
                                       : make_case(request.seed, request.number, before_look);
  made.campaign_case.options.sizing.even = request.even;
  return made;
}

}  // namespace remeshd::campaign

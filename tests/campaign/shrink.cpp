#include "tests/campaign/shrink.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>

#include "engine/base/error.h"
#include "tests/campaign/draft.h"
#include "tests/campaign/store.h"

namespace remeshd::campaign {
namespace {

namespace fs = std::filesystem;

constexpr double kTrySeconds = 200;

double rounded(double v, int digits) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, v);
  return std::strtod(text.data(), nullptr);
}

class Shrinker {
 public:
  Shrinker(fs::path file, double seconds)
      : file_(std::move(file)),
        trial_file_(file_.string() + ".try"),
        end_(Clock::now() +
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
        best_(read_case_file(file_)) {}

  fs::path operator()() {
    const std::optional<Outcome> first = outcome(best_);
    if (!first || first->valid()) throw std::runtime_error(file_.string() + " does not fail");
    failure_ = signature(*first);
    drop_steps();
    fewer_nodes();  // at first: what follows takes less time
    remove_features();
    remove_edits();
    plain_numbers();
    for (const int digits : {2, 3, 5, 8}) fewer_digits(digits);
    remove_features();
    best_.note = "shrunk to " + failure_ + "; " + best_.note;
    fs::remove(trial_file_);
    fs::path small = file_;
    small.replace_extension(".small.json");
    write_case_file(small, best_);
    return small;
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// What counts as the same failure: of an invalid mesh the first check.
  static std::string signature(const Outcome& o) {
    return o.kind + " " + o.reason.substr(0, o.reason.find(','));
  }

  /// Of the last step; none where the case did not get there.
  std::optional<Outcome> outcome(const CampaignCase& c) {
    write_case_file(trial_file_, c);
    const WorkedCase worked = have_worked(trial_file_.string(), kTrySeconds);
    if (worked.outcomes.empty() || worked.outcomes.back().step != c.steps.size()) return {};
    return worked.outcomes.back();
  }

  bool take(const CampaignCase& smaller) {
    if (Clock::now() > end_) return false;
    try {
      const std::optional<Outcome> o = outcome(smaller);
      if (!o || signature(*o) != failure_) return false;
    } catch (const std::exception&) {
      return false;  // the smaller case makes no sense
    }
    best_ = smaller;
    return true;
  }

  bool change(const std::function<void(CampaignCase&)>& how) {
    CampaignCase smaller = best_;
    try {
      how(smaller);
    } catch (const Error&) {
      return false;
    }
    return take(smaller);
  }

  void drop_steps() {
    if (best_.steps.empty()) return;
    // The last document alone; the last edit alone; then edit by edit.
    change([](CampaignCase& c) {
      c.model = model_after(c, c.steps.size());
      c.steps.clear();
    });
    if (!best_.steps.empty()) {
      // Undone steps are there for their own sake.
      const Step last = best_.steps.back();
      CampaignCase& c = best_;
      std::erase_if(c.steps, [](const Step& s) { return s.undone; });
      if (last.undone) c.steps.push_back(last);
      c.steps.back().undone = false;
    }
    if (best_.steps.size() > 1)
      change([](CampaignCase& c) {
        c.model = model_after(c, c.steps.size() - 1);
        c.steps.erase(c.steps.begin(), c.steps.end() - 1);
        c.steps.front().undone = false;
      });
    for (std::size_t k = 0; k + 1 < best_.steps.size();) {
      const std::size_t before = best_.steps.size();
      change([&](CampaignCase& c) {  // joins two edits to one
        std::vector<Edit>& next = c.steps[k + 1].edit.edits;
        next.insert(next.begin(), c.steps[k].edit.edits.begin(), c.steps[k].edit.edits.end());
        c.steps.erase(c.steps.begin() + static_cast<std::ptrdiff_t>(k));
      });
      if (best_.steps.size() == before) ++k;
    }
  }

  void remove_edits() {
    for (std::size_t s = 0; s < best_.steps.size(); ++s)
      for (std::size_t e = best_.steps[s].edit.edits.size(); e-- > 0;) {
        if (best_.steps[s].edit.edits.size() < 2) break;
        change([&](CampaignCase& c) {
          auto& edits = c.steps[s].edit.edits;
          edits.erase(edits.begin() + static_cast<std::ptrdiff_t>(e));
        });
      }
  }

  static bool concerns(const Edit& edit, const std::string& id) {
    struct Feature {
      std::string operator()(const SetParameter&) const { return {}; }
      std::string operator()(const SetFeatureParameter& e) const { return e.feature; }
      std::string operator()(const SetPlacement& e) const { return e.feature; }
      std::string operator()(const AddFeature& e) const { return e.feature.id; }
      std::string operator()(const RemoveFeature& e) const { return e.feature; }
      std::string operator()(const SetSize&) const { return {}; }
      std::string operator()(const RemoveSize&) const { return {}; }
      std::string operator()(const SetGroup&) const { return {}; }
      std::string operator()(const RemoveGroup&) const { return {}; }
    };
    return std::visit(Feature{}, edit) == id;
  }

  /// Halves of them at first, then quarters, down to one by one.
  void remove_features() {
    for (std::size_t n = std::max<std::size_t>(1, best_.model.features.size() / 2);; n /= 2) {
      for (std::size_t k = best_.model.features.size(); k > 0;) {
        const std::size_t from = k > n ? k - n : 0;
        change([&](CampaignCase& c) { erase_features(c, from, k); });
        k = from;
      }
      if (n == 1) return;
    }
  }

  /// With all edits of them.
  static void erase_features(CampaignCase& c, std::size_t from, std::size_t to) {
    for (std::size_t k = to; k-- > from;) {
      const std::string id = c.model.features[k].id;
      c.model.features.erase(c.model.features.begin() + static_cast<std::ptrdiff_t>(k));
      for (Step& step : c.steps) {
        std::erase_if(step.edit.edits, [&](const Edit& e) { return concerns(e, id); });
        for (Edit& e : step.edit.edits)
          if (auto* add = std::get_if<AddFeature>(&e); add != nullptr && add->after == id)
            add->after.clear();
      }
    }
    // What cannot fail as before need not be tried.
    if (c.model.features.empty()) throw error::no_features();
    evaluate(model_after(c, c.steps.size()));
  }

  void fewer_nodes() {
    if (!best_.options.nodes) return;
    for (const std::uint32_t n : {300U, 600U, 1000U, 1500U, 2000U, 3000U})
      if (n < *best_.options.nodes && change([&](CampaignCase& c) { c.options.nodes = n; })) return;
  }

  /// Every number of the model and of the edits' features.
  static void for_all_numbers(CampaignCase& c, const std::function<void(double&)>& f) {
    const auto one = [&](Scalar& s) {
      if (double* v = std::get_if<double>(&s)) f(*v);
    };
    const auto placement = [&](PlacementSource& p) {
      for (Scalar& s : p.origin) one(s);
    };
    const auto profile = [&](std::vector<ProfileEntry>& entries) {
      for (ProfileEntry& e : entries) {
        one(e.x);
        one(e.y);
        if (!e.through) continue;
        one((*e.through)[0]);
        one((*e.through)[1]);
      }
    };
    const auto feature = [&](FeatureSource& s) {
      for (auto& [name, value] : s.parameters) one(value);
      if (s.profile) profile(*s.profile);
      placement(s.placement);
    };
    for (ParameterSource& p : c.model.parameters) one(p.value);
    for (FeatureSource& s : c.model.features) feature(s);
    for (Step& step : c.steps)
      for (Edit& edit : step.edit.edits) {
        if (auto* add = std::get_if<AddFeature>(&edit)) feature(add->feature);
        if (auto* place = std::get_if<SetPlacement>(&edit)) placement(place->placement);
        if (auto* set = std::get_if<SetFeatureParameter>(&edit)) {
          if (auto* scalar = std::get_if<Scalar>(&set->value)) one(*scalar);
          if (auto* outline = std::get_if<std::vector<ProfileEntry>>(&set->value))
            profile(*outline);
        }
      }
  }

  void fewer_digits(int digits) {
    change(
        [&](CampaignCase& c) { for_all_numbers(c, [&](double& v) { v = rounded(v, digits); }); });
    // One feature at a time where all together are too much.
    for (std::size_t k = 0; k < best_.model.features.size(); ++k)
      change([&](CampaignCase& c) {
        CampaignCase only;
        only.model.features = {c.model.features[k]};
        for_all_numbers(only, [&](double& v) { v = rounded(v, digits); });
        if (only.model.features[0] == c.model.features[k]) throw error::no_features();
        c.model.features[k] = only.model.features[0];
      });
  }

  /// Values for expressions, where no step sets a parameter.
  void plain_numbers() {
    change([](CampaignCase& c) {
      const FeatureModel model = evaluate(c.model);
      for (std::size_t k = 0; k < model.features.size(); ++k) {
        FeatureSource& source = c.model.features[k];
        source.placement = placement_of(model.features[k].placement);
      }
    });
    change([](CampaignCase& c) {
      for (FeatureSource& f : c.model.features) f.reference = ReferenceKind::Origin;
    });
    // Each parameter by its number, then those that nothing uses any more go.
    const std::vector<ParameterSource> parameters = best_.model.parameters;
    for (const ParameterSource& p : parameters)
      if (const double* number = std::get_if<double>(&p.value))
        change([&](CampaignCase& c) { write_out(c.model, p.name, *number); });
  }

  /// Expressions of this parameter alone, `p1`, `p1*2` or `p1-2`, as the generator writes them, as
  /// numbers.
  static void write_out(ModelSource& model, const std::string& name, double number) {
    for (FeatureSource& f : model.features)
      for (auto& [key, value] : f.parameters) {
        const std::string* text = std::get_if<std::string>(&value);
        if (text == nullptr || !text->starts_with(name)) continue;
        const std::string rest = text->substr(name.size());
        if (rest.empty()) {
          value = number;
        } else if (rest[0] == '*' || rest[0] == '+' || rest[0] == '-') {
          const double by = std::strtod(rest.c_str() + 1, nullptr);
          value = rest[0] == '*' ? number * by : rest[0] == '+' ? number + by : number - by;
        }
      }
    std::erase_if(model.parameters, [&](const ParameterSource& p) { return p.name == name; });
    evaluate(model);
  }

  fs::path file_, trial_file_;
  Clock::time_point end_;
  CampaignCase best_;
  std::string failure_;
};

}  // namespace

fs::path shrink_file(const fs::path& file, double seconds) { return Shrinker(file, seconds)(); }

}  // namespace remeshd::campaign

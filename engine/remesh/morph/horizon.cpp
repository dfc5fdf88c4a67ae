#include "engine/remesh/morph/horizon.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/error.h"
#include "engine/local_fuse/local_fuse.h"
#include "engine/motion/design_velocities.h"
#include "engine/remesh/density.h"
#include "engine/remesh/morph/hold.h"

namespace remeshd {
namespace {

struct HorizonLimits {
  double near = 0.01;    ///< of the way searched: how exactly the end is found
  double further = 1.1;  ///< x the change that moves the fastest surface as far as it may go
};
constexpr HorizonLimits kHorizon;

/// Why the connectivity does not stay with that value; nothing where it does.
std::optional<std::string> ends_at(const Revision& revision, const std::string& parameter,
                                   double value, double hold, const Run& run) {
  run.poll();
  try {
    Revision modified;
    modified.model = with_value(revision.source, parameter, value);
    modified.model.groups = revision.model.groups;  // whose rims are edges of the boundary
    modified.meshed_model = modified.model;
    modified.options = revision.options;
    modified.options.hold = hold;
    modified.edge_length = revision.edge_length;
    modified.cells = build_cells(modified.model, revision.model, revision.cells, run);
    const auto result =
        hold > 0 ? hold_mesh(revision, modified, run) : morph_mesh(revision, modified, run);
    if (const auto* why = std::get_if<NotMorphed>(&result))
      return why->empty() ? "a surface moves further than morphing lets it, or the topology changes"
                          : *why;
    return {};
  } catch (const Error& error) {
    if (error.info().kind == ErrorKind::Cancelled) throw;
    return std::string(error.what());
  }
}

/// The bounds that the model gives the parameter; infinite where it gives none.
std::pair<double, double> bounds_of(const ModelSource& source, const std::string& parameter) {
  const auto found = std::ranges::find(source.parameters, parameter, &ParameterSource::name);
  if (found == source.parameters.end()) return {-HUGE_VAL, HUGE_VAL};
  return {found->lower.value_or(-HUGE_VAL), found->upper.value_or(HUGE_VAL)};
}

/// The largest speed of a boundary node.
double fastest(const DesignVelocities& velocities, const Revision& revision,
               const std::string& parameter, const Run& run) {
  const NodalVelocities all = velocities.of(parameter, run);
  double most = 0;
  for (std::size_t n = 0; n < revision.supports().size(); ++n)
    if (revision.supports()[n].kind != Support::Kind::Interior)
      most = std::fmax(most, norm(all.velocities[n]));
  return most;
}

struct End {
  double value;
  std::string reason;
};

/// The end of the connectivity, by bisection between `good`, where it stays, and `bad`; `bad`
/// without a reason where it stays there too.
End find_end(const Revision& revision, const std::string& parameter, double good, double bad,
             double hold, const Run& run) {
  std::optional<std::string> why = ends_at(revision, parameter, bad, hold, run);
  if (!why) return {bad, ""};
  const double near = kHorizon.near * std::fabs(bad - good);
  while (std::fabs(bad - good) > near) {
    const double middle = 0.5 * (good + bad);
    if (auto reason = ends_at(revision, parameter, middle, hold, run)) {
      bad = middle;
      why = std::move(reason);
    } else {
      good = middle;
    }
  }
  return {good, *why};
}

}  // namespace

Horizon connectivity_horizon(const Revision& revision, const std::string& parameter, double hold,
                             const Run& run) {
  Horizon out;
  out.value = out.lower = out.upper = parameter_value(revision.source, parameter);
  const DesignVelocities velocities(revision, run);
  const double speed = fastest(velocities, revision, parameter, run);
  const auto [least, most] = bounds_of(revision.source, parameter);
  const double furthest = hold > 0 ? hold * revision.edge_length
                                   : kMorphLimits.surface_motion * sizes_of(revision, run).least();
  const double way = kHorizon.further * furthest / speed;
  if (!std::isfinite(way)) {
    out.lower = least;
    out.upper = most;
    out.lower_reason = out.upper_reason = "no surface moves";
    return out;
  }
  const auto end = [&](double bound, double far) {
    const bool within = std::fabs(bound - out.value) <= std::fabs(far - out.value);
    End found = find_end(revision, parameter, out.value, within ? bound : far, hold, run);
    if (found.reason.empty())
      found.reason = within ? "the parameter's bound" : "was not tried further";
    return found;
  };
  const End lower = end(least, out.value - way), upper = end(most, out.value + way);
  out.lower = lower.value;
  out.lower_reason = lower.reason;
  out.upper = upper.value;
  out.upper_reason = upper.reason;
  return out;
}

}  // namespace remeshd

#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"
#include "engine/base/warning.h"

namespace remeshd {

/// What kind of failure an Error is; the server maps each to one gRPC status.
enum class ErrorKind {
  InvalidArgument,     ///< the request cannot be right whatever the state
  NotFound,            ///< no such revision, design or feature
  FailedPrecondition,  ///< the request is sound, this model cannot be meshed or this state forbids
                       ///< it
  DeadlineExceeded,
  ResourceExhausted,  ///< busy or too big; may carry a retry delay
  Aborted,            ///< lost a compare-and-set
  Cancelled,
  Unavailable,  ///< the daemon is going away, or a store that it needs cannot be reached
  Internal,
  DataLoss,          ///< a stored mesh is lost and comes out otherwise when made again
  Unimplemented,     ///< this build does not do it
  PermissionDenied,  ///< known, but not allowed
  Unauthenticated,
};

/// A failure a user can act on: what, where in the run, which feature and parameter, what to do.
struct ErrorInfo {
  ErrorKind kind = ErrorKind::Internal;
  /// Stable name, one of Error.Reason in proto/remesh/v1/error.proto: `DEGENERATE_FEATURE`.
  std::string reason{};
  std::string message{};                ///< one sentence
  std::string stage{};                  ///< station of the engine or `request`
  std::vector<std::string> features{};  ///< ids of features at fault, the main one first
  std::string parameter{};  ///< parameter, `placement.origin[1]`, `profile[3]`, ...; empty if none
  std::string hint{};       ///< what would help; empty if nothing sensible can be said
  std::optional<int> edit_index{};      ///< 0-based index of the edit at fault
  std::optional<double> retry_after{};  ///< s until it is worth trying again
  std::optional<Vec3> place{};          ///< model's unit; `message` names it too
  std::optional<int> line{}, column{};  ///< in a document, from 1
  std::optional<Warning> warning{};     ///< with WARNING_IS_ERROR
  /// Attempts at a mesh before the last one, each with its reason: `full: an inverted tet ...`.
  std::vector<std::string> attempts{};
  std::string home{};  ///< address of the daemon to ask instead, with DESIGN_ELSEWHERE
};

class Error : public std::runtime_error {
 public:
  explicit Error(ErrorInfo info) : std::runtime_error(info.message), info_(std::move(info)) {}
  [[nodiscard]] const ErrorInfo& info() const { return info_; }
  ErrorInfo& info() { return info_; }

 private:
  ErrorInfo info_;
};

/// Ids of features.
using FeatureIds = std::vector<std::string>;

/// One function per failure; each returns the Error to throw.
namespace error {

Error cancelled();
Error internal(std::string_view stage, std::string_view what);

// Stage `model`. `feature` is empty where the model itself is at fault; `parameter` spells the
// place: `radius`, `profile[3].through`, `placement.zAxis`, or the model parameter's name.

Error invalid_name(std::string_view feature, std::string_view parameter, std::string_view name,
                   std::string_view why);
Error duplicate_feature(std::string_view feature);
Error duplicate_parameter(std::string_view parameter);
Error unknown_feature_type(std::string_view feature, std::string_view type,
                           std::string_view known_types);
Error missing_parameter(std::string_view feature, std::string_view parameter,
                        std::string_view type);
Error unknown_parameter(std::string_view feature, std::string_view parameter,
                        std::string_view known_parameters);
/// A profile where a number or expression belongs, or the other way round.
Error wrong_value_kind(std::string_view feature, std::string_view parameter,
                       std::string_view expected);
Error non_finite_value(std::string_view feature, std::string_view parameter,
                       std::string_view value);
Error value_out_of_range(std::string_view feature, std::string_view parameter, double value,
                         std::string_view range);
/// A value outside the bounds that a parameter of the model has; at least one is given.
Error out_of_bounds(std::string_view parameter, double value, const std::optional<double>& lower,
                    const std::optional<double>& upper);
/// A value of an `integer` parameter of the model that is no whole number.
Error not_whole(std::string_view parameter, double value);
/// `why`: a clause that goes on after "the bounds of parameter ...".
Error bounds_invalid(std::string_view parameter, std::string_view why);
Error degenerate_feature(std::string_view feature, std::string_view parameter, double value,
                         std::string_view why);
Error degenerate_frame(std::string_view feature, std::string_view parameter, std::string_view why);
Error invalid_profile(std::string_view feature, std::string_view parameter, std::string_view why,
                      std::string_view hint);
Error self_intersecting_profile(std::string_view feature, std::string_view parameter,
                                std::string_view why);
Error profile_crosses_axis(std::string_view feature, std::string_view parameter,
                           std::string_view why);
Error invalid_expression(std::string_view feature, std::string_view parameter,
                         std::string_view expression, std::string_view why);
Error unknown_name(std::string_view feature, std::string_view parameter, std::string_view name,
                   std::string_view expression);
/// `cycle` reads `a -> b -> a`; `parameter` is the model parameter it was found from.
Error cyclic_parameters(std::string_view parameter, std::string_view cycle);
Error limit_exceeded(std::string_view feature, std::string_view parameter, std::string_view what,
                     std::size_t count, std::size_t limit);
Error no_features();
Error no_additive_feature();

// Edits; the caller adds the edit's index.

Error unknown_feature(std::string_view feature);
Error unknown_model_parameter(std::string_view name);

// Stage `cells`.

/// No cell of the model is material.
Error empty_model();
/// The material falls into `pieces` parts that share no face. `place`, `features`: of the smallest
/// part.
Error disconnected_model(int pieces, const Vec3& place, const FeatureIds& features);
/// The boundary touches itself; `what`: `along an edge`, `at a vertex`, `at a point`; `features`:
/// those that meet at `place`.
Error non_manifold_model(std::string_view what, const Vec3& place, const FeatureIds& features);
/// The CAD kernel failed, or a check of its result did. A caller that catches it and knows the
/// features adds those at the place.
Error kernel_failure(std::string_view what, const std::optional<Vec3>& place = {},
                     const FeatureIds& features = {});

// Stage `control mesh`: TetGen in its own process.

/// TetGen does not accept the surface, or gives no usable mesh of it; `why`: a clause.
Error tetgen_refused(std::string_view why);
/// `TETGEN_REFUSED` too: TetGen was not asked.
Error surface_too_fine(std::size_t facets);
/// TetGen ended without a usable answer; `how`: a clause.
Error tetgen_crashed(std::string_view how);
Error tetgen_too_slow(double seconds);
Error tetgen_out_of_memory(std::size_t bytes);
/// The program `remeshd-tetgen` cannot be started from `path`.
Error tetgen_missing(std::string_view path, std::string_view why);

// Stage `request`; boundary_not_recovered: stage `verify`.
/// `option`: `nodes`, `size`, `iterations`.
Error options_invalid(std::string_view option, std::string_view why);
/// `what`: a clause that ends before the number, `an edge length of 0.1 needs about`; `option`:
/// `nodes` or `size`, empty where neither was given; `feature`: the one that is too large, empty
/// where no one alone is.
Error mesh_too_large(std::string_view what, double nodes, std::uint32_t limit,
                     std::string_view option, std::string_view feature, std::string_view hint);
/// `what`: what is missing or wrong, and where; `place`, `features`: where that is, none where the
/// whole mesh is wrong.
Error boundary_not_recovered(std::string_view what, const std::optional<Vec3>& place,
                             const FeatureIds& features);

}  // namespace error
}  // namespace remeshd

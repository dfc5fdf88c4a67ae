#include "engine/model/selection/evaluate_sizes.h"

#include <set>
#include <string>

#include "engine/base/error.h"
#include "engine/model/expression.h"
#include "engine/model/limits.h"
#include "engine/model/selection/select_faces.h"
#include "engine/model/selection/selection_error.h"

namespace remeshd {
namespace {

/// `feature`: whose parameters the value was computed from; empty: none.
double checked_length(double value, const std::string& feature, const std::string& parameter) {
  if (value < kMinSize || value > kMaxLength)
    throw error::value_out_of_range(feature, parameter, value, "between 1e-9 and 1e9");
  return value;
}

/// Evaluates the size controls of one model.
class Sizes {
 public:
  Sizes(const ModelSource& source, const std::vector<Feature>& features, const Scope& scope,
        SelectorCost& cost)
      : source_(source), features_(features), scope_(scope), cost_(cost) {}

  std::vector<SizeControl> operator()() {
    if (source_.sizes.size() > kMaxSelections)
      throw error::limit_exceeded("", "sizes", "sizes", source_.sizes.size(), kMaxSelections);
    std::set<std::string_view> ids;
    std::vector<SizeControl> sizes;
    for (std::size_t k = 0; k < source_.sizes.size(); ++k) {
      const SizeControlSource& size = source_.sizes[k];
      check_name(size.id, "", "sizes[" + std::to_string(k) + "].id");
      if (!ids.insert(size.id).second) throw error::duplicate_size(size.id);
      where_ = "sizes." + size.id;
      sizes.push_back({size.id, std::visit(
                                    [&](const auto& place) -> decltype(SizeControl::place) {
                                      return evaluate(place, size.size);
                                    },
                                    size.place)});
    }
    return sizes;
  }

 private:
  [[nodiscard]] double length(const Scalar& value, const std::string& field) const {
    const std::string parameter = where_ + field;
    return checked_length(scope_.value(value, "", parameter), "", parameter);
  }
  [[nodiscard]] double coordinate(const Scalar& value, const std::string& field) const {
    const std::string parameter = where_ + field;
    return checked_coordinate(scope_.value(value, "", parameter), "", parameter);
  }

  [[nodiscard]] SizedBall evaluate(const BallSource& ball, const Scalar& size) const {
    return {.centre = {coordinate(ball[0], ".in.ball[0]"), coordinate(ball[1], ".in.ball[1]"),
                       coordinate(ball[2], ".in.ball[2]")},
            .radius = length(ball[3], ".in.ball[3]"),
            .size = length(size, ".size")};
  }

  [[nodiscard]] SizedBox evaluate(const BoxSource& box, const Scalar& size) const {
    std::array<double, 6> at{};
    for (std::size_t k = 0; k < at.size(); ++k) {
      const std::string field = ".in.box[" + std::to_string(k) + "]";
      at[k] = coordinate(box[k], field);
      if (k >= 3 && !(at[k] > at[k - 3]))
        throw error::value_out_of_range("", where_ + field, at[k],
                                        "greater than the least on that axis");
    }
    return {
        .lo = {at[0], at[1], at[2]}, .hi = {at[3], at[4], at[5]}, .size = length(size, ".size")};
  }

  [[nodiscard]] std::vector<SizedFaces> evaluate(const std::string& on, const Scalar& size) {
    // A number is checked even where the selector names nothing.
    const bool is_number = std::holds_alternative<double>(size);
    const double everywhere = is_number ? length(size, ".size") : 0;
    std::vector<SizedFaces> sized;
    for (SelectedFaces& faces :
         select_faces(on, source_, features_, scope_, where_ + ".on", cost_)) {
      const double here = is_number ? everywhere : length_on(source_.features[faces.feature], size);
      sized.push_back({std::move(faces), here});
    }
    return sized;
  }

  [[nodiscard]] double length_on(const FeatureSource& feature, const Scalar& size) const {
    const std::string parameter = where_ + ".size";
    return checked_length(scope_.value(size, numbers_of(feature, scope_), feature.id, parameter),
                          feature.id, parameter);
  }

  const ModelSource& source_;
  const std::vector<Feature>& features_;
  const Scope& scope_;
  SelectorCost& cost_;
  std::string where_;  ///< the size being evaluated
};

}  // namespace

std::vector<SizeControl> evaluate_sizes(const ModelSource& source,
                                        const std::vector<Feature>& features, const Scope& scope,
                                        SelectorCost& cost) {
  return Sizes(source, features, scope, cost)();
}

}  // namespace remeshd

#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/source.h"

namespace remeshd {

/// Longest expression accepted, in characters.
inline constexpr std::size_t kMaxExpressionLength = 4096;
/// Most parameters of one model.
inline constexpr std::size_t kMaxParameters = 10000;

/// Throws Error(INVALID_NAME) unless `name` is `[A-Za-z_][A-Za-z0-9_]{0,63}` and neither `pi`,
/// `deg` nor the name of a function. `feature` and `parameter` say whose name it is.
void check_name(std::string_view name, std::string_view feature, std::string_view parameter);

/// An expression whose parameters have their numbers, but for some names that get theirs later.
struct OpenExpression {
  std::string text;
  std::map<std::string, double> numbers;  ///< of its names that are known
  friend bool operator==(const OpenExpression&, const OpenExpression&) = default;
};

/// Evaluates an open expression for any values of its open names. Not safe from several threads.
class OpenValue {
 public:
  /// `names`: those that are open. Pre: the expression is one of `Scope::open` with these names.
  OpenValue(const OpenExpression& expression, std::span<const char* const> names);
  ~OpenValue();
  OpenValue(OpenValue&&) noexcept;

  /// With these values, one a name; NaN where it has none, as `sqrt(x)` left of nought.
  double operator()(std::span<const double> values);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

/// The parameters of a model, evaluated, and what is needed to evaluate expressions over them.
///
/// Expressions are muParser's: `+ - * / ^`, comparisons, `?:`, its functions, and the constants
/// `pi` and `deg` (pi/180) in full precision. The same text has the same value in every locale.
/// Nothing in an expression can change a parameter.
class Scope {
 public:
  /// Evaluates all parameters; they may be expressions over each other in any order.
  ///
  /// Throws Error(InvalidArgument) naming the parameter: bad names, names that stand twice,
  /// expressions that cannot be read, unknown names, circles, values that are not finite, bounds
  /// that no value meets, values outside their bounds.
  explicit Scope(const std::vector<ParameterSource>& parameters);
  ~Scope();
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

  /// Value of a number or expression. Throws Error(InvalidArgument) that names the place.
  [[nodiscard]] double value(const Scalar& scalar, std::string_view feature,
                             std::string_view parameter) const;
  /// The same of an expression that sees other names before the parameters.
  [[nodiscard]] double value(const Scalar& scalar, const std::map<std::string, double>& before,
                             std::string_view feature, std::string_view parameter) const;
  /// An expression that sees `names` before all others and gets their values later; then `before`,
  /// then the parameters. Throws Error(InvalidArgument) that names the place.
  [[nodiscard]] OpenExpression open(const std::string& text, std::span<const char* const> names,
                                    const std::map<std::string, double>& before,
                                    std::string_view feature, std::string_view parameter) const;

 private:
  struct Parser;
  /// The numbers of the names that a text uses and `inner` does not define.
  std::map<std::string, double> known_names(Parser& inner, const std::string& text,
                                            const std::map<std::string, double>& before,
                                            std::string_view feature,
                                            std::string_view parameter) const;
  std::unique_ptr<Parser> parser_;
};

}  // namespace remeshd

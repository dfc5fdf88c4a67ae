#pragma once

#include <cstdint>
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

/// An expression some of whose names are variables; its other names are bound to numbers.
struct OpenExpression {
  std::string text;
  std::map<std::string, double> numbers;  ///< of its names that are no variables
  friend bool operator==(const OpenExpression&, const OpenExpression&) = default;
};

/// Evaluates an open expression for any values of its variables. Not safe from several threads.
class OpenValue {
 public:
  /// Value: the value of the expression. Margin: a comparison gives by how much it holds, below 0
  /// where it does not (`a < b` gives b - a); `&&` gives the lesser of its two sides, `||` the
  /// greater.
  enum class Kind : std::uint8_t { Value, Margin };
  /// `names`: the variables. Pre: the expression is a result of `Scope::open` with these names.
  OpenValue(const OpenExpression& expression, std::span<const char* const> names,
            Kind kind = Kind::Value);
  ~OpenValue();
  OpenValue(OpenValue&&) noexcept;

  /// Its value for these values of the variables, one each, in the order of `names`; NaN where it
  /// has no finite value, as `sqrt(x)` for x < 0, and everywhere for the margin of `?:`.
  double operator()(std::span<const double> values);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

/// The parameters of a model, evaluated, and what is needed to evaluate expressions over them.
///
/// Expressions are muParser's: `+ - * / ^`, comparisons, `?:`, its functions, and the constants
/// `pi` and `deg` (pi/180) in full precision. The same text has the same value in every locale.
/// Nothing in an expression can change a parameter. Not safe from several threads.
class Scope {
 public:
  /// Evaluates all parameters; they may be expressions over each other in any order.
  ///
  /// Throws Error(InvalidArgument) naming the parameter: bad or duplicate names, expressions that
  /// cannot be read, unknown names, cycles, values that are not finite, bounds that no value meets,
  /// values outside their bounds, values of integer parameters that are not whole.
  explicit Scope(const std::vector<ParameterSource>& parameters);
  ~Scope();
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

  /// Value of a number or expression. Throws Error(InvalidArgument) with `feature` and `parameter`.
  [[nodiscard]] double value(const Scalar& scalar, std::string_view feature,
                             std::string_view parameter) const;
  /// Like the above, but an expression may also use the names of `before`, which hide parameters.
  [[nodiscard]] double value(const Scalar& scalar, const std::map<std::string, double>& before,
                             std::string_view feature, std::string_view parameter) const;
  /// An expression in the variables `names`, which hide the names of `before`, which hide the
  /// parameters. Throws Error(InvalidArgument) with `feature` and `parameter`.
  [[nodiscard]] OpenExpression open(const std::string& text, std::span<const char* const> names,
                                    const std::map<std::string, double>& before,
                                    std::string_view feature, std::string_view parameter) const;

 private:
  struct Parser;
  /// The numbers of the names that a text uses, from `before` or else the parameters; names that
  /// neither has are left out, and so are constants of `inner`.
  std::map<std::string, double> known_names(Parser& inner, const std::string& text,
                                            const std::map<std::string, double>& before,
                                            std::string_view feature,
                                            std::string_view parameter) const;
  std::unique_ptr<Parser> parser_;
};

}  // namespace remeshd

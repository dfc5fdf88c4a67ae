#include "engine/model/expression.h"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "engine/base/error.h"

namespace remeshd {
namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// muParser with our constants in place of its own, which are cut at 12 digits. The optimiser is
/// off: it rewrites `2*a + 3` and with it the last bits of the value.
mu::Parser bare_parser() {
  mu::Parser parser;
  parser.ClearConst();
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineConst("deg", std::numbers::pi / 180);
  parser.EnableOptimizer(false);
  return parser;
}

/// The same with operators that tell by how much a comparison holds (`OpenValue::Kind::Margin`).
mu::Parser margin_parser() {
  mu::Parser parser = bare_parser();
  parser.EnableBuiltInOprt(false);
  const auto define = [&](const char* name, mu::fun_type2 meaning, mu::EOprtPrecedence precedence,
                          mu::EOprtAssociativity associativity = mu::oaLEFT) {
    parser.DefineOprt(name, meaning, precedence, associativity);
  };
  define(
      "||", [](double a, double b) { return std::fmax(a, b); }, mu::prLOR);
  define(
      "&&", [](double a, double b) { return std::fmin(a, b); }, mu::prLAND);
  for (const char* less : {"<", "<="})
    define(
        less, [](double a, double b) { return b - a; }, mu::prCMP);
  for (const char* greater : {">", ">="})
    define(
        greater, [](double a, double b) { return a - b; }, mu::prCMP);
  define(
      "==", [](double a, double b) { return -std::fabs(a - b); }, mu::prCMP);
  define(
      "!=", [](double a, double b) { return std::fabs(a - b); }, mu::prCMP);
  define(
      "+", [](double a, double b) { return a + b; }, mu::prADD_SUB);
  define(
      "-", [](double a, double b) { return a - b; }, mu::prADD_SUB);
  define(
      "*", [](double a, double b) { return a * b; }, mu::prMUL_DIV);
  define(
      "/", [](double a, double b) { return a / b; }, mu::prMUL_DIV);
  define(
      "^", [](double a, double b) { return std::pow(a, b); }, mu::prPOW, mu::oaRIGHT);
  return parser;
}

const std::set<std::string, std::less<>>& reserved_names() {
  static const auto names = [] {
    std::set<std::string, std::less<>> all{"pi", "deg"};
    const mu::Parser parser = bare_parser();
    for (const auto& [name, function] : parser.GetFunDef()) all.insert(name);
    return all;
  }();
  return names;
}

/// Why a text is refused before muParser reads it, for example because it would assign; empty if it
/// is not.
std::string objection(const std::string& text) {
  if (text.size() > kMaxExpressionLength)
    return "expressions have at most " + std::to_string(kMaxExpressionLength) + " characters";
  bool blank = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c != ' ' && c != '\t') blank = false;
    if ((c < ' ' && c != '\t') || c > '~') return "only printable ASCII characters are allowed";
    if (c == '"') return "text is no value";
    if (c != '=') continue;
    const bool comparison = (i > 0 && (text[i - 1] == '=' || text[i - 1] == '<' ||
                                       text[i - 1] == '>' || text[i - 1] == '!')) ||
                            (i + 1 < text.size() && text[i + 1] == '=');
    if (!comparison) return "an expression cannot assign";
  }
  return blank ? "the expression is empty" : "";
}

/// `a -> b -> a` for the parameters from the first appearance of `back` on the path.
std::string spell_cycle(const std::vector<ParameterSource>& parameters,
                        const std::vector<std::size_t>& path, std::size_t back) {
  std::string text;
  bool inside = false;
  for (const std::size_t k : path) {
    inside = inside || k == back;
    if (inside) text += parameters[k].name + " -> ";
  }
  return text + parameters[back].name;
}

using Index = std::map<std::string_view, std::size_t>;

/// Checks what needs no evaluation: names and bounds. Returns the parameters' indices by name.
Index check_parameters(const std::vector<ParameterSource>& parameters) {
  if (parameters.size() > kMaxParameters)
    throw error::limit_exceeded("", "", "parameters", parameters.size(), kMaxParameters);
  Index index;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const auto& [name, value, lower, upper, integer, unit, description] = parameters[k];
    check_name(name, "", name);
    if (!index.emplace(name, k).second) throw error::duplicate_parameter(name);
    for (const auto& bound : {lower, upper})
      if (bound && !std::isfinite(*bound)) throw error::bounds_invalid(name, "are not finite");
    if (lower && upper && *lower > *upper)
      throw error::bounds_invalid(name, "leave no value: lower lies above upper");
  }
  return index;
}

void check_value(const ParameterSource& parameter, double value) {
  const auto& [name, scalar, lower, upper, integer, unit, description] = parameter;
  if ((lower && value < *lower) || (upper && value > *upper))
    throw error::out_of_bounds(name, value, lower, upper);
  if (integer && value != std::floor(value)) throw error::not_whole(name, value);
}

}  // namespace

void check_name(std::string_view name, std::string_view feature, std::string_view parameter) {
  if (name.empty()) throw error::invalid_name(feature, parameter, name, "is empty");
  if (name.size() > 64) throw error::invalid_name(feature, parameter, name, "is too long");
  bool well_formed = is_letter(name.front());
  for (const char c : name) well_formed = well_formed && (is_letter(c) || is_digit(c));
  if (!well_formed)
    throw error::invalid_name(feature, parameter, name, "has a character that is not allowed");
  if (reserved_names().contains(name))
    throw error::invalid_name(feature, parameter, name, "is reserved for expressions");
}

/// One muParser for all expressions of a model; known parameters are constants to it.
struct Scope::Parser {
  mu::Parser mu = bare_parser();

  /// The names an expression uses that are no constants yet.
  std::vector<std::string> unknowns(const std::string& text, std::string_view feature,
                                    std::string_view parameter) {
    const std::string why = objection(text);
    if (!why.empty()) throw error::invalid_expression(feature, parameter, text, why);
    try {
      mu.SetExpr(text);
      std::vector<std::string> names;
      for (const auto& [name, variable] : mu.GetUsedVar()) names.push_back(name);
      return names;
    } catch (const mu::ParserError& e) {
      throw error::invalid_expression(feature, parameter, text, e.GetMsg());
    }
  }

  double evaluate(const std::string& text, std::string_view feature, std::string_view parameter) {
    const std::vector<std::string> missing = unknowns(text, feature, parameter);
    if (!missing.empty()) throw error::unknown_name(feature, parameter, missing.front(), text);
    const double result = one_value(text, feature, parameter);
    if (!std::isfinite(result)) throw error::non_finite_value(feature, parameter, text);
    return result;
  }

  /// The value of a text whose names are all defined, be it finite or not.
  double one_value(const std::string& text, std::string_view feature, std::string_view parameter) {
    try {
      mu.SetExpr(text);
      int count = 0;
      const double* values = mu.Eval(count);
      if (count != 1)
        throw error::invalid_expression(feature, parameter, text, "a list is no value");
      return values[0];
    } catch (const mu::ParserError& e) {
      throw error::invalid_expression(feature, parameter, text, e.GetMsg());
    }
  }
};

Scope::Scope(const std::vector<ParameterSource>& parameters) : parser_(std::make_unique<Parser>()) {
  const Index index = check_parameters(parameters);
  std::vector<std::vector<std::size_t>> uses(parameters.size());
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const ParameterSource& parameter = parameters[k];
    const auto* text = std::get_if<std::string>(&parameter.value);
    if (text == nullptr) continue;
    for (const std::string& other : parser_->unknowns(*text, "", parameter.name)) {
      const auto found = index.find(other);
      if (found == index.end()) throw error::unknown_name("", parameter.name, other, *text);
      uses[k].push_back(found->second);
    }
  }

  // Depth first without recursion: a chain of 10,000 parameters must not overflow the call stack.
  enum class Mark { New, OnPath, Done };
  std::vector<Mark> marks(parameters.size(), Mark::New);
  std::vector<std::size_t> path;
  std::vector<std::size_t> next;
  for (std::size_t root = 0; root < parameters.size(); ++root) {
    if (marks[root] == Mark::Done) continue;
    path = {root};
    next = {0};
    marks[root] = Mark::OnPath;
    while (!path.empty()) {
      const std::size_t k = path.back();
      if (next.back() < uses[k].size()) {
        const std::size_t other = uses[k][next.back()++];
        if (marks[other] == Mark::OnPath)
          throw error::cyclic_parameters(parameters[other].name,
                                         spell_cycle(parameters, path, other));
        if (marks[other] == Mark::New) {
          marks[other] = Mark::OnPath;
          path.push_back(other);
          next.push_back(0);
        }
        continue;
      }
      const ParameterSource& parameter = parameters[k];
      const double number = value(parameter.value, "", parameter.name);
      check_value(parameter, number);
      parser_->mu.DefineConst(parameter.name, number);
      marks[k] = Mark::Done;
      path.pop_back();
      next.pop_back();
    }
  }
}

Scope::~Scope() = default;

double Scope::value(const Scalar& scalar, std::string_view feature,
                    std::string_view parameter) const {
  if (const auto* text = std::get_if<std::string>(&scalar))
    return parser_->evaluate(*text, feature, parameter);
  const double number = std::get<double>(scalar);
  if (!std::isfinite(number))
    throw error::non_finite_value(feature, parameter, std::isnan(number) ? "NaN" : "infinity");
  return number;
}

double Scope::value(const Scalar& scalar, const std::map<std::string, double>& before,
                    std::string_view feature, std::string_view parameter) const {
  const auto* text = std::get_if<std::string>(&scalar);
  if (text == nullptr) return value(scalar, feature, parameter);
  Parser inner;
  for (const auto& [name, number] : known_names(inner, *text, before, feature, parameter))
    inner.mu.DefineConst(name, number);
  return inner.evaluate(*text, feature, parameter);
}

OpenExpression Scope::open(const std::string& text, std::span<const char* const> names,
                           const std::map<std::string, double>& before, std::string_view feature,
                           std::string_view parameter) const {
  Parser inner;
  double any = 0;
  for (const char* name : names) inner.mu.DefineVar(name, &any);
  OpenExpression expression{text, known_names(inner, text, before, feature, parameter)};
  for (const char* name : names) expression.numbers.erase(name);
  for (const auto& [name, number] : expression.numbers) inner.mu.DefineConst(name, number);
  for (const std::string& name : inner.unknowns(text, feature, parameter))
    if (std::ranges::find(names, name) == names.end())
      throw error::unknown_name(feature, parameter, name, text);
  inner.one_value(text, feature, parameter);  // evaluates it once, for errors such as a list
  return expression;
}

std::map<std::string, double> Scope::known_names(Parser& inner, const std::string& text,
                                                 const std::map<std::string, double>& before,
                                                 std::string_view feature,
                                                 std::string_view parameter) const {
  std::map<std::string, double> known;
  const auto& parameters = parser_->mu.GetConst();
  for (const std::string& name : inner.unknowns(text, feature, parameter)) {
    if (const auto own = before.find(name); own != before.end()) {
      known[name] = own->second;
    } else if (const auto found = parameters.find(name); found != parameters.end()) {
      known[name] = found->second;
    }
  }
  return known;
}

struct OpenValue::Parser {
  mu::Parser mu;
  std::vector<double> values;
};

OpenValue::OpenValue(const OpenExpression& expression, std::span<const char* const> names,
                     Kind kind)
    : parser_(std::make_unique<Parser>(
          Parser{kind == Kind::Margin ? margin_parser() : bare_parser(), {}})) {
  parser_->values.resize(names.size());
  for (const auto& [name, number] : expression.numbers) parser_->mu.DefineConst(name, number);
  for (std::size_t k = 0; k < names.size(); ++k)
    parser_->mu.DefineVar(names[k], &parser_->values[k]);
  // `?:` would take a margin below 0 for true.
  const bool untold = kind == Kind::Margin && expression.text.find('?') != std::string::npos;
  parser_->mu.SetExpr(untold ? "0/0" : expression.text);
}

OpenValue::~OpenValue() = default;
OpenValue::OpenValue(OpenValue&&) noexcept = default;

double OpenValue::operator()(std::span<const double> values) {
  std::ranges::copy(values, parser_->values.begin());
  try {
    const double value = parser_->mu.Eval();
    return std::isfinite(value) ? value : std::nan("");
  } catch (const mu::ParserError&) {
    return std::nan("");  // due to these values: Scope::open has evaluated the text once
  }
}

}  // namespace remeshd

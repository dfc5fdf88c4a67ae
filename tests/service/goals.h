#pragma once

#include <string>

namespace remeshd::test {

/// The figures of a program, printed as they come, and whether one missed its goal. What is not a
/// matter of time must hold everywhere; times and rates have to reach their goals only where
/// `timed` is set, for a machine that others use as well decides about them.
class Goals {
 public:
  explicit Goals(bool timed) : timed_(timed) {}

  /// A figure without a goal.
  void tell(const std::string& what, double value, const std::string& unit = "") const;
  void must(const std::string& what, bool holds);
  /// Of counts and bytes.
  void must_be_at_most(const std::string& what, double value, const std::string& unit, double goal);
  /// Of times and rates.
  void at_most(const std::string& what, double value, const std::string& unit, double goal);
  void at_least(const std::string& what, double value, const std::string& unit, double goal);

  /// 0 where every goal that counts was reached, else 1.
  [[nodiscard]] int exit_status() const { return missed_ ? 1 : 0; }

 private:
  void judge(const std::string& figure, const std::string& goal, bool reached, bool counts);

  const bool timed_;
  bool missed_ = false;
};

}  // namespace remeshd::test

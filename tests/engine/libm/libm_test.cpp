#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace remeshd {
namespace {

using Function = double (*)(double);
using Exact = long double (*)(long double);

/// Of the C library's functions of long double, which have 11 more bits, in units of the last
/// place.
double error_in_ulp(double value, long double exact) {
  const double nearest = std::abs(static_cast<double>(exact));
  const long double ulp = std::nextafter(nearest, INFINITY) - nearest;
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / ulp);
}

/// The greatest error over random arguments.
double worst_error(Function function, Exact exact, double from, double to) {
  std::mt19937_64 random(1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = std::uniform_real_distribution<double>(from, to)(random);
    worst = std::max(worst, error_in_ulp(function(x), exact(x)));
  }
  return worst;
}

TEST(Libm, HasErrorsOfLessThanOneUnitInTheLastPlace) {
  EXPECT_LT(worst_error(std::sin, std::sin, -1e4, 1e4), 1);
  EXPECT_LT(worst_error(std::cos, std::cos, -1e4, 1e4), 1);
  EXPECT_LT(worst_error(std::tan, std::tan, -10, 10), 1);
  EXPECT_LT(worst_error(std::asin, std::asin, -1, 1), 1);
  EXPECT_LT(worst_error(std::acos, std::acos, -1, 1), 1);
  EXPECT_LT(worst_error(std::atan, std::atan, -100, 100), 1);
  EXPECT_LT(worst_error(std::exp, std::exp, -700, 700), 1);
  EXPECT_LT(worst_error(std::exp2, std::exp2, -1000, 1000), 1);
  EXPECT_LT(worst_error(std::log, std::log, 1e-6, 1e6), 1);
  EXPECT_LT(worst_error(std::log2, std::log2, 1e-6, 1e6), 1);
  EXPECT_LT(worst_error(std::log10, std::log10, 1e-6, 1e6), 1);
  EXPECT_LT(worst_error(std::cbrt, std::cbrt, -1e6, 1e6), 1);
}

TEST(Libm, HasTheSameErrorsForTwoArguments) {
  std::mt19937_64 random(2);
  const auto any = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = any(1e-3, 1e3), y = any(-20, 20);
    worst = std::max(worst, error_in_ulp(std::pow(x, y), std::pow(1.0L * x, 1.0L * y)));
    worst = std::max(worst, error_in_ulp(std::hypot(x, y), std::hypot(1.0L * x, 1.0L * y)));
    worst = std::max(worst, error_in_ulp(std::atan2(y, x), std::atan2(1.0L * y, 1.0L * x)));
  }
  EXPECT_LT(worst, 1);
}

TEST(Libm, IsExactWhereTheResultIs) {
  EXPECT_EQ(std::pow(3.0, 4.0), 81);
  EXPECT_EQ(std::pow(0.0, 0.0), 1);
  EXPECT_EQ(std::pow(-2.0, 3.0), -8);
  EXPECT_EQ(std::exp2(10.0), 1024);
  EXPECT_EQ(std::hypot(3.0, 4.0), 5);
  EXPECT_EQ(std::cbrt(27.0), 3);
  EXPECT_EQ(std::log10(1000.0), 3);
  EXPECT_EQ(std::sin(0.0), 0);
  EXPECT_EQ(std::atan2(0.0, -1.0), std::acos(-1.0));
  EXPECT_TRUE(std::isnan(std::acos(1.5)));
}

/// The linker shows the program's own to OpenCASCADE's libraries too.
TEST(Libm, IsThatOfTheWholeProgram) {
  for (const char* name : {"sin", "cos", "sincos", "tan", "atan2", "exp", "log", "pow", "acos"}) {
    Dl_info ours, found;
    ASSERT_NE(dladdr(reinterpret_cast<void*>(&worst_error), &ours), 0);
    ASSERT_NE(dladdr(dlsym(RTLD_DEFAULT, name), &found), 0) << name;
    EXPECT_EQ(found.dli_fbase, ours.dli_fbase) << name << " is that of " << found.dli_fname;
  }
}

}  // namespace
}  // namespace remeshd

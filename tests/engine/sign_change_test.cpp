#include "mesh/sign_change.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace karcher {
namespace {

constexpr double kUnitRounding = 1e-15;

/// The zero of a function, and the number of evaluations.
template <class Function>
double changeOf(const Function& function, double from, double to, int& evaluations) {
  evaluations = 0;
  return signChange(from, to, function(from), function(to), kUnitRounding * (from + to),
                    [&](double x) {
                      ++evaluations;
                      return function(x);
                    });
}

TEST(SignChange, IsTheZeroOfRisingAndFallingFunctions) {
  int evaluations = 0;
  const auto rising = [](double x) { return x * x - 2; };
  const auto falling = [](double x) { return 2 - x * x; };
  EXPECT_NEAR(changeOf(rising, 0, 2, evaluations), std::sqrt(2.0), 1e-15);
  EXPECT_LE(evaluations, 12);
  EXPECT_NEAR(changeOf(falling, 0, 2, evaluations), std::sqrt(2.0), 1e-15);
  EXPECT_LE(evaluations, 12);
  EXPECT_EQ(changeOf([](double x) { return x - 1; }, 1, 2, evaluations), 1);
  EXPECT_EQ(evaluations, 0);
}

TEST(SignChange, IsFoundOfSteepAndFlatFunctions) {
  int evaluations = 0;
  EXPECT_NEAR(changeOf([](double x) { return std::pow(x, 15) - 1e-9; }, 0, 1, evaluations),
              std::pow(1e-9, 1.0 / 15), 1e-14);
  EXPECT_LE(evaluations, 100);
  EXPECT_NEAR(changeOf([](double x) { return x - 1e-12; }, 0, 1, evaluations), 1e-12, 1e-15);
}

TEST(SignChange, IsTheJumpOfADiscontinuousFunction) {
  int evaluations = 0;
  const auto jump = [](double x) { return x < 0.3 ? -1e-9 : 1.0; };
  EXPECT_NEAR(changeOf(jump, 0, 1, evaluations), 0.3, 1e-14);
  EXPECT_LE(evaluations, 100);
}

TEST(SignChange, IsFoundBesideValuesThatAreNotFinite) {
  int evaluations = 0;
  const auto beyond = [](double x) {
    return x < 0.7 ? x - 0.25 : std::numeric_limits<double>::infinity();
  };
  EXPECT_NEAR(changeOf(beyond, 0, 1, evaluations), 0.25, 1e-15);
  EXPECT_LE(evaluations, 100);
}

/// The search for a foot may find equal signs at both ends if the slope jumps in between.
TEST(SignChange, OfOneSignAtBothEndsIsTakenToRise) {
  int evaluations = 0;
  const auto negative = [](double) { return -1.0; };
  const auto positive = [](double) { return 1.0; };
  EXPECT_NEAR(changeOf(negative, 0, 1, evaluations), 1, 1e-14);
  EXPECT_NEAR(changeOf(positive, 0, 1, evaluations), 0, 1e-14);
  EXPECT_LE(evaluations, 100);
}

}  // namespace
}  // namespace karcher

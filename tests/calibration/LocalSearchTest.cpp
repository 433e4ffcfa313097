#include "calibration/LocalSearch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace squat::calibration {
namespace {

// A narrow quadratic valley, five inputs: the minimum lies at 0.3, 0.4, ... 0.7 and is 0.
double valley(const UnitPoint& x) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double own = x[i] - 0.3 - 0.1 * static_cast<double>(i);
    const double next = i + 1 < x.size() ? x[i + 1] - 0.4 - 0.1 * static_cast<double>(i) : 0;
    sum += own * own + 10 * (own - next) * (own - next);
  }
  return sum;
}

// BOBYQA's model of a quadratic is exact after (n + 1)(n + 2) / 2 = 21 points; twice as many leave room for its steps.
TEST(LocalSearch, FindsTheMinimumOfAQuadratic) {
  int calls = 0;
  double best = INFINITY;
  UnitPoint at;
  LocalSearchOptions options;
  options.evaluations = 60;
  searchFrom(
      UnitPoint(5, 0.5),
      [&](const UnitPoint& x) -> std::optional<double> {
        ++calls;
        if (valley(x) < best) best = valley(x), at = x;
        return valley(x);
      },
      options);
  EXPECT_LE(calls, 60);
  for (std::size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(at[i], 0.3 + 0.1 * static_cast<double>(i), 0.02);
}

TEST(LocalSearch, StaysInTheCube) {
  searchFrom({0.95, 0.02},
             [](const UnitPoint& x) -> std::optional<double> {
               for (const double c : x) EXPECT_TRUE(c >= 0 && c <= 1) << c;
               return -x[0] + x[1];
             },
             {});
}

TEST(LocalSearch, EndsAtOnceWhereItIsCancelled) {
  int calls = 0;
  searchFrom({0.5, 0.5},
             [&](const UnitPoint&) -> std::optional<double> {
               if (++calls == 3) return std::nullopt;
               return 1.0 * calls;
             },
             {});
  EXPECT_EQ(calls, 3);
}

TEST(LocalSearch, TakesASingleInput) {
  double best = INFINITY, at = 0;
  searchFrom({0.9},
             [&](const UnitPoint& x) -> std::optional<double> {
               const double value = std::pow(x[0] - 0.25, 2);
               if (value < best) best = value, at = x[0];
               return value;
             },
             {});
  EXPECT_NEAR(at, 0.25, 0.02);
}

TEST(LocalSearch, RepeatsItselfToTheBit) {
  std::vector<UnitPoint> first, second;
  for (auto* seen : {&first, &second})
    searchFrom({0.2, 0.8, 0.5},
               [&](const UnitPoint& x) -> std::optional<double> {
                 seen->push_back(x);
                 return valley(x);
               },
               {});
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace squat::calibration

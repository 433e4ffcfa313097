#include "verification/Seen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

namespace squat::verification {

namespace {

struct Worst {
  double value = 0;
  std::string unit;
  Worse worse = Worse::larger;
};

// Of the test that runs.
std::map<std::string, Worst>& worstOf() {
  static std::map<std::string, Worst> worst;
  return worst;
}

void compare(const std::string& test, const std::string& what, const Worst& worst) {
  if (std::isnan(worst.value)) ADD_FAILURE() << what << " is not a number";
  const auto& all = statedFigures();
  const auto stated = std::find_if(all.begin(), all.end(), [&](const Stated& each) {
    return each.test == test && each.quantity == what && each.unit == worst.unit;
  });
  const std::string command = ".ci/verification " + test;
  if (stated == all.end()) {
    std::printf("%s has no figure yet: %s states it\n", what.c_str(), command.c_str());
    return;
  }
  bool good = false;
  const auto wrong = judgedAsStated(worst.value, std::stod(stated->figure), worst.worse, good);
  if (!wrong.empty()) ADD_FAILURE() << what << ": " << wrong << " [" << worst.unit << "]";
  if (good)
    std::printf("%s is %.2g %s, stated is %s: %s states it anew\n", what.c_str(), worst.value, worst.unit.c_str(),
                stated->figure.c_str(), command.c_str());
}

class AtTheEnd : public ::testing::EmptyTestEventListener {
  void OnTestEnd(const ::testing::TestInfo& test) override {
    for (const auto& [what, worst] : worstOf())
      compare(std::string(test.test_suite_name()) + "." + test.name(), what, worst);
    worstOf().clear();
  }
};

}  // namespace

const std::vector<Stated>& statedFigures() {
  static const auto all = [] {
    std::vector<Stated> rows;
    std::ifstream file(SQUAT_SOURCE_DIR "/tests/verification/accuracy.csv");
    std::string line;
    std::getline(file, line);  // the heading
    while (std::getline(file, line)) {
      std::istringstream cells(line);
      auto& row = rows.emplace_back();
      for (auto* cell : {&row.test, &row.quantity, &row.figure, &row.unit}) std::getline(cells, *cell, ',');
    }
    return rows;
  }();
  return all;
}

void seen(const std::string& what, double value, const std::string& unit, Worse worse) {
  static const bool listens = [] {
    ::testing::UnitTest::GetInstance()->listeners().Append(new AtTheEnd);  // which owns it
    return true;
  }();
  static_cast<void>(listens);
  value = std::abs(value);
  std::printf("seen: %s | %.3g | %s%s\n", what.c_str(), value, unit.c_str(),
              worse == Worse::smaller ? " | smaller is worse" : "");
  const auto [at, isFirst] = worstOf().try_emplace(what, Worst{value, unit, worse});
  if (!isFirst && (worse == Worse::larger) == (value > at->second.value)) at->second.value = value;
  if (std::isnan(value)) at->second.value = value;
}

void seenDeviation(const std::string& what, double found, double expected) {
  seen(what, 100 * (found / expected - 1), "%");
}

std::string judgedAsStated(double worst, double stated, Worse worse, bool& good) {
  const bool isLarger = worse == Worse::larger;
  const double bad = isLarger ? worst : stated, fine = isLarger ? stated : worst;
  good = bad * kStatedWithin < fine;
  if (bad < kStatedWithin * fine || bad == fine) return {};  // not so of NaN; none seen and none stated are alike
  std::ostringstream text;
  text << worst << " is seen, " << stated << " is stated, and less than " << kStatedWithin
       << " times as bad is accepted";
  return text.str();
}

}  // namespace squat::verification

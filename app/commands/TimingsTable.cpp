#include "commands/TimingsTable.h"

#include <cstdio>
#include <vector>

#include "text/TextTable.h"

namespace squat::commands {

namespace {

std::string fixedText(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::string timingsTable(const dynamics::StepTimings& timings) {
  if (timings.steps() == 0) return {};
  const auto perStep = [&](int thread, dynamics::StepPhase phase) {
    return 1e6 * timings.seconds(thread, phase) / static_cast<double>(timings.steps());
  };
  std::vector<double> sums(dynamics::stepPhases, 0.0);
  double all = 0;
  for (std::size_t p = 0; p < dynamics::stepPhases; ++p) {
    for (int thread = 0; thread < timings.threads(); ++thread)
      sums[p] += perStep(thread, static_cast<dynamics::StepPhase>(p));
    all += sums[p];
  }
  std::vector<std::string> head{"phase of a step"};
  for (int thread = 0; thread < timings.threads(); ++thread)
    head.push_back("thread " + std::to_string(thread + 1) + " [us]");
  head.emplace_back("share [%]");
  text::TextTable table(std::move(head));
  for (std::size_t p = 0; p < dynamics::stepPhases; ++p) {
    if (sums[p] == 0) continue;
    const auto phase = static_cast<dynamics::StepPhase>(p);
    std::vector<std::string> row{dynamics::nameOf(phase)};
    for (int thread = 0; thread < timings.threads(); ++thread) row.push_back(fixedText("%.1f", perStep(thread, phase)));
    row.push_back(fixedText("%.1f", 100 * sums[p] / all));
    table.add(std::move(row));
  }
  return table.text();
}

}  // namespace squat::commands

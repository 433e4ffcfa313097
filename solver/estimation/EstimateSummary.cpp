#include "estimation/EstimateSummary.h"

#include <cstdio>

#include "text/Numbers.h"
#include "text/TextTable.h"

namespace squat::estimation {

namespace {

using text::formatted;
using text::kTerminalWidth;
using text::TextTable;

using text::roundedText;

std::string row(const Interval& interval, double unit, const char* name) {
  return roundedText(unit * interval.value) + " " + name + " (90 %: " + roundedText(unit * interval.low) + " to " +
         roundedText(unit * interval.high) + ")";
}

// The stretches that a wheel bridges, from and to [mm].
std::string unfeltText(const Estimate& estimate) {
  std::string text;
  const auto& profile = estimate.profile;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (profile[i].isFelt || (i > 0 && !profile[i - 1].isFelt)) continue;
    std::size_t last = i;
    while (last + 1 < profile.size() && !profile[last + 1].isFelt) ++last;
    text += (text.empty() ? "" : ", ") + formatted("%.0f", 1e3 * profile[i].position) + " to " +
            formatted("%.0f", 1e3 * profile[last].position);
  }
  return text;
}

}  // namespace

std::string estimateSummary(const Estimate& estimate) {
  std::string text = "depth   " + row(estimate.depth, 1e6, "um") + "\n";
  text += "length  " + row(estimate.length, 1e3, "mm") + "\n";
  text += "misfit  " + roundedText(estimate.misfit) + " times the noise\n\n";
  TextTable table({"passage", "speed", "deepest point at", "peak", "noise", "difference, rms"});
  for (const auto& passage : estimate.passages)
    table.add({passage.name, formatted("%.2f m/s", passage.speed), formatted("%.3f m", passage.location),
               formatted("%.1f m/s2", passage.peak), formatted("%.2f m/s2", passage.noise),
               formatted("%.2f m/s2", passage.difference)});
  text += table.text(kTerminalWidth);
  if (const auto unfelt = unfeltText(estimate); !unfelt.empty())
    text += "The wheel does not touch " + unfelt + " mm: the rail may be deeper there than estimated.\n";
  for (const auto& note : estimate.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace squat::estimation

#include "estimation/EstimateSummary.h"

#include <cstdio>

#include "text/Numbers.h"
#include "text/TextTable.h"

namespace squat::estimation {

namespace {

using text::kTerminalWidth;
using text::TextTable;

using text::roundedText;

std::string row(const Interval& interval, double unit, const char* name) {
  return roundedText(unit * interval.value) + " " + name + " (90 %: " + roundedText(unit * interval.low) + " to " +
         roundedText(unit * interval.high) + ")";
}

std::string decimals(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// The stretches that a wheel bridges, from and to [mm].
std::string unfeltText(const Estimate& estimate) {
  std::string text;
  const auto& profile = estimate.profile;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (profile[i].isFelt || (i > 0 && !profile[i - 1].isFelt)) continue;
    std::size_t last = i;
    while (last + 1 < profile.size() && !profile[last + 1].isFelt) ++last;
    text += (text.empty() ? "" : ", ") + decimals(1e3 * profile[i].position, "%.0f") + " to " +
            decimals(1e3 * profile[last].position, "%.0f");
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
    table.add({passage.name, decimals(passage.speed, "%.2f m/s"), decimals(passage.place, "%.3f m"),
               decimals(passage.peak, "%.1f m/s2"), decimals(passage.noise, "%.2f m/s2"),
               decimals(passage.difference, "%.2f m/s2")});
  text += table.text(kTerminalWidth);
  if (const auto unfelt = unfeltText(estimate); !unfelt.empty())
    text += "The wheel does not touch " + unfelt + " mm: the rail may be deeper there than estimated.\n";
  for (const auto& note : estimate.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace squat::estimation

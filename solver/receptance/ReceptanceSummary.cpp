#include "receptance/ReceptanceSummary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "text/Numbers.h"
#include "text/TextTable.h"

namespace squat::receptance {

namespace {

using text::formatted;
using text::roundedText;
using text::TextTable;

constexpr double kShown[] = {50, 82, 100, 300, 500, 1000, 1500, 2000};  // [Hz], where they were computed

std::string receptanceTable(const TrackReceptance& result, ReceptanceQuantity quantity) {
  std::vector<std::string> head{"frequency"};
  for (const auto& point : result.points) head.push_back(point.name), head.push_back("phase");
  TextTable table(head);
  std::vector<std::vector<std::complex<double>>> values;
  for (const auto& point : result.points) values.push_back(asQuantity(result.frequency, point.receptance, quantity));
  const auto& at = result.frequency;
  for (const double f : kShown) {
    if (f < at.front() * (1 - 1e-9) || f > at.back() * (1 + 1e-9)) continue;
    auto i = std::lower_bound(at.begin(), at.end(), f) - at.begin();  // the nearest that was computed
    if (i == static_cast<long>(at.size()) || (i > 0 && f - at[i - 1] < at[i] - f)) --i;
    std::vector<std::string> row{formatted("%.0f Hz", result.frequency[i])};
    for (const auto& point : values) {
      row.push_back(formatted("%.3e ", std::abs(point[i])) + unitOf(quantity));
      row.push_back(formatted("%.0f°", std::arg(point[i]) * 180 / std::numbers::pi));
    }
    table.add(row);
  }
  return table.text();
}

}  // namespace

std::string receptanceSummary(const TrackReceptance& receptance, ReceptanceQuantity quantity) {
  std::string text = receptanceTable(receptance, quantity) + "\n";
  for (const auto& point : receptance.points) {
    text += "resonances " + point.name + " [Hz]:";
    for (const double f :
         resonances(receptance.frequency, asQuantity(receptance.frequency, point.receptance, quantity)))
      text += formatted(" %.0f", f);
    text += "\n";
  }
  if (!receptance.modes.empty()) text += "\nNatural modes of the free wheelset:\n" + modesTable(receptance.modes);
  for (const auto& note : receptance.notes) text += "note: " + note + "\n";
  return text;
}

std::string modesTable(const std::vector<model::HarmonicMode>& modes) {
  TextTable table({"mode [Hz]", "both sides", "axle box", "wheel centre", "contact [1/√kg]"});
  for (const auto& mode : modes)
    table.add({roundedText(mode.frequency), mode.centre == model::Centre::symmetric ? "symmetric" : "antisymmetric",
               roundedText(mode.boxAmplitude), roundedText(mode.wheelAmplitude), roundedText(mode.contactAmplitude)});
  return table.text();
}

}  // namespace squat::receptance

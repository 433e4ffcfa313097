#include "receptance/ReceptanceSummary.h"

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

std::string receptanceTable(const TrackReceptance& result) {
  std::vector<std::string> head{"frequency"};
  for (const auto& point : result.points) head.push_back(point.name), head.push_back("phase");
  TextTable table(head);
  const double step = result.frequency.size() > 1 ? result.frequency[1] - result.frequency[0] : 1;
  for (const double f : kShown) {
    const auto i = std::lround((f - result.frequency.front()) / step);
    if (i < 0 || i >= static_cast<long>(result.frequency.size())) continue;
    std::vector<std::string> row{formatted("%.0f Hz", result.frequency[i])};
    for (const auto& point : result.points) {
      row.push_back(formatted("%.3e m/N", std::abs(point.receptance[i])));
      row.push_back(formatted("%.0f°", std::arg(point.receptance[i]) * 180 / std::numbers::pi));
    }
    table.add(row);
  }
  return table.text();
}

}  // namespace

std::string receptanceSummary(const TrackReceptance& receptance) {
  std::string text = receptanceTable(receptance) + "\n";
  for (const auto& point : receptance.points) {
    text += "resonances " + point.name + " [Hz]:";
    for (const double f : resonances(receptance.frequency, point.receptance)) text += formatted(" %.0f", f);
    text += "\n";
  }
  text += "\nNatural modes of the free half wheelset:\n" + modesTable(receptance.modes);
  for (const auto& note : receptance.notes) text += "note: " + note + "\n";
  return text;
}

std::string modesTable(const std::vector<model::HarmonicMode>& modes) {
  TextTable table({"mode [Hz]", "axle box", "wheel centre", "contact [1/√kg]"});
  for (const auto& mode : modes)
    table.add({roundedText(mode.frequency), roundedText(mode.boxShare), roundedText(mode.wheelShare),
               roundedText(mode.contactShare)});
  return table.text();
}

}  // namespace squat::receptance

#include <algorithm>
#include <cmath>

#include "growth/GrowthFiles.h"
#include "text/Numbers.h"
#include "text/TextTable.h"

namespace squat::growth {

namespace {

constexpr double perMillion = 1 / kilogramsInMegatonne;
constexpr std::size_t shownStages = 12;

// Without a sign before zero.
std::string mm(double metres) { return text::fixedText(std::abs(metres) < 0.5e-6 ? 0.0 : 1e3 * metres, 3); }

// The first, the last, those after a grinding and others evenly between.
std::vector<std::size_t> shown(const std::vector<Stage>& stages) {
  std::vector<std::size_t> list;
  const std::size_t every = std::max<std::size_t>(1, (stages.size() + shownStages - 1) / shownStages);
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (i % every == 0 || i + 1 == stages.size() || stages[i].ground) list.push_back(i);
  return list;
}

std::string trafficText(const Growth& growth) {
  std::string lines = "Traffic: each of these wheelsets in turn.\n";
  text::TextTable table({"wheel load", "speed", "touches at", "traction"});
  for (std::size_t i = 0; i < growth.traffic.size(); ++i)
    table.add({text::fixedText(1e-3 * growth.wheelLoads[i], 1) + " kN", text::fixedText(growth.speeds[i], 1) + " m/s",
               text::fixedText(1e3 * growth.traffic[i].lateral, 1) + " mm",
               text::fixedText(growth.traffic[i].traction, 3)});
  return lines + table.text();
}

std::string stagesText(const Growth& growth) {
  text::TextTable table({"Mt", "depth mm", "length mm", "wave mm", "height mm", "wear mm", "flow mm", "strain %",
                         "force kN", "ABA m/s2"});
  for (const std::size_t i : shown(growth.stages)) {
    const auto& s = growth.stages[i];
    table.add({text::fixedText(perMillion * s.tonnage, 2) + (s.ground ? " ground" : ""), mm(s.depth),
               text::fixedText(1e3 * s.length, 1), s.waveLength > 0 ? text::fixedText(1e3 * s.waveLength, 1) : "-",
               mm(s.waveHeight), mm(s.wear), mm(s.flow), text::fixedText(100 * s.largestStrain, 2),
               text::fixedText(1e-3 * s.largestForce, 1), text::fixedText(s.peakAcceleration, 1)});
  }
  return table.text();
}

}  // namespace

std::string stageLine(const Stage& stage) {
  return text::fixedText(perMillion * stage.tonnage, 2) + " Mt  depth " + mm(stage.depth) + " mm  axle box " +
         text::fixedText(stage.peakAcceleration, 0) + " m/s2" + (stage.ground ? "  ground" : "");
}

std::string growthSummary(const Growth& growth, const GrowthOptions& options) {
  if (growth.stages.empty()) return {};
  std::string summary = trafficText(growth) + "\n" + stagesText(growth);
  const auto &first = growth.stages.front(), &last = growth.stages.back();
  summary += "\nOn the rail far from the defect " + mm(last.wearAround) + " mm have worn off, and " +
             mm(last.flowAround) + " mm have sunk; depths count from there.\n";
  const double change = last.depth - first.depth;
  summary += "The dip has become " + mm(std::abs(change)) + " mm " + (change >= 0 ? "deeper" : "shallower") + " in " +
             text::fixedText(perMillion * last.tonnage, 2) + " Mt.\n";
  for (const auto& grinding : options.grindings)
    if (const auto clean = lastCleanTonnage(growth, grinding.depth))
      summary += "Grinding by " + mm(grinding.depth) + " mm would have removed all strained steel up to " +
                 text::fixedText(perMillion * *clean, 2) + " Mt after the last grinding.\n";
  return summary;
}

}  // namespace squat::growth

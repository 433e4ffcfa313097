#include "project/ViewsInFile.h"

#include <limits>

namespace squat::project {
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const AxisRange& range) { return {{"low", range.low}, {"high", range.high}, {"unit", range.unit}}; }

Json jsonOf(const FigureRange& range) {
  Json json;
  json["figure"] = range.figure;
  if (range.x) json["x"] = jsonOf(*range.x);
  if (range.y) json["y"] = jsonOf(*range.y);
  return json;
}

std::optional<AxisRange> rangeIn(const JsonNode& node, const char* axis) {
  if (!node.has(axis)) return std::nullopt;
  constexpr double maximum = std::numeric_limits<double>::max();
  const JsonNode range = node.at(axis);
  const AxisRange read{range.at("low").number(-maximum, maximum), range.at("high").number(-maximum, maximum),
                       range.at("unit").text()};
  if (!(read.low < read.high)) range.fail("has a low end that is not below the high one");
  return read;
}

// A scale of a later program would be lost when the project is saved.
analysis::SpectrumScale scaleIn(const JsonNode& node) {
  const auto scale = analysis::spectrumScaleNamed(node.text());
  if (scale) return *scale;
  std::string known;
  for (const auto name : analysis::spectrumScaleNames) known += (known.empty() ? "" : ", ") + std::string(name);
  node.fail("is no scale of a spectrum that this program knows: " + known);
}

}  // namespace

Json jsonOf(const FigureViews& figures) {
  const auto& settings = figures.settings;
  const auto section = settings.section.value_or(analysis::Section{});
  Json json{{"cutoff", settings.cutoff},
            {"from", section.from},
            {"to", section.to},
            {"window", settings.window},
            {"scale", nameOf(settings.spectrum)},
            {"colours", settings.colours},
            {"moment", settings.moment},
            {"segment", settings.segment},
            {"hop", settings.hop}};
  for (const auto& range : figures.ranges) json["ranges"].push_back(jsonOf(range));
  return json;
}

Json jsonOf(const TableOrder& order) {
  return {{"sort", order.sort}, {"descending", order.descending}, {"group", order.group}, {"filter", order.filter}};
}

FigureViews figuresIn(const JsonNode& node) {
  constexpr double highest = 1e12, farthest = 1e12;  // [Hz], [m]
  constexpr int largest = 1 << 30;
  FigureViews figures;
  auto& settings = figures.settings;
  settings.cutoff = node.at("cutoff").number(0, highest);
  settings.section = {node.at("from").number(-farthest, farthest), node.at("to").number(-farthest, farthest)};
  settings.window = node.at("window").text();
  settings.spectrum = scaleIn(node.at("scale"));
  settings.colours = node.at("colours").text();
  settings.moment = node.at("moment").whole(-1, largest);
  settings.segment = static_cast<std::size_t>(node.at("segment").whole(1, largest));
  settings.hop = static_cast<std::size_t>(node.at("hop").whole(1, largest));
  if (!node.has("ranges")) return figures;
  for (const auto& range : node.at("ranges").list())
    figures.ranges.push_back({range.at("figure").text(), rangeIn(range, "x"), rangeIn(range, "y")});
  return figures;
}

TableOrder orderIn(const JsonNode& node) {
  return {node.at("sort").text(), node.at("descending").flag(), node.at("group").text(), node.at("filter").text()};
}

}  // namespace squat::project

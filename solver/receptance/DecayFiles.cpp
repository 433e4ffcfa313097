#include "receptance/DecayFiles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/Errors.h"
#include "receptance/ThirdOctaves.h"
#include "text/Cells.h"
#include "text/Csv.h"
#include "text/Heading.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/TextTable.h"

namespace squat::receptance {

namespace {

constexpr std::size_t largestDecayFile = 10'000'000;  // bytes

using Values = std::map<double, std::vector<double>>;  // by third octave

std::optional<RailDirection> directionIn(const std::string& word) {
  const auto name = text::lowerCase(word);
  for (const char* vertical : {"v", "vertical", "vertikal"})
    if (name == vertical) return RailDirection::vertical;
  for (const char* lateral : {"h", "l", "lateral", "horizontal", "quer"})
    if (name == lateral) return RailDirection::lateral;
  return std::nullopt;
}

// The third octave of a frequency [Hz] in a file.
double bandOf(double frequency, const std::string& path, const std::string& where) {
  if (const auto band = nominalThirdOctave(frequency)) return *band;
  throw FileError(path, where, text::formatted("%.4g Hz", frequency) + " is not the middle of a third octave",
                  "Decay rates are read in third octaves from 50 to 5000 Hz");
}

// The frequency [Hz] that a heading such as "100 Hz [dB/m]" names.
std::optional<double> bandIn(const std::string& heading) {
  auto name = text::lowerCase(text::bracketedHeading(heading).name);
  const std::size_t hertz = name.find("hz");
  if (hertz == std::string::npos) return std::nullopt;
  return text::numberIn(text::trimmed(std::string_view(name).substr(0, hertz)), '.');
}

void requireRate(const std::string& heading, const std::string& path) {
  const auto unit = text::lowerCase(text::bracketedHeading(heading).unit);
  if (unit != "db/m")
    throw FileError(path, "column '" + heading + "'", unit.empty() ? "states no unit" : "unit is '" + unit + "'",
                    "Decay rates are in dB/m: write it behind the name, e.g. 100 Hz [dB/m]");
}

void addRate(Values& values, double band, const std::string& cell, const std::string& path, std::size_t line) {
  const auto field = text::lowerCase(cell);
  if (field.empty() || field == "nan" || field == "-") return;
  const auto rate = text::numberIn(cell, '.');
  if (!rate || !(*rate >= 0 && *rate < 1000))
    throw FileError(path, "line " + std::to_string(line), text::shown(cell) + " is not a decay rate in dB/m",
                    "Write numbers from 0 to 1000; leave the field empty where nothing was measured");
  values[band].push_back(*rate);
}

MeasuredDecay spreadOf(const std::vector<double>& values) {
  MeasuredDecay spread;
  spread.count = static_cast<int>(values.size());
  if (values.empty()) return spread;
  spread.lowest = *std::min_element(values.begin(), values.end());
  spread.highest = *std::max_element(values.begin(), values.end());
  for (const double value : values) spread.mean += value / static_cast<double>(values.size());
  return spread;
}

// One row a measurement.
void readRows(const text::Cells& cells, std::size_t direction, Values& vertical, Values& lateral,
              const std::string& path) {
  const auto& heading = cells.rows.front();
  for (std::size_t row = 1; row < cells.rows.size(); ++row) {
    const auto& fields = cells.rows[row];
    const auto way = directionIn(direction < fields.size() ? fields[direction] : "");
    if (!way)
      throw FileError(path, "line " + std::to_string(cells.lines[row]), "the direction is not stated",
                      "Write v or vertical, or h, l or lateral");
    for (std::size_t i = 0; i < std::min(fields.size(), heading.size()); ++i)
      if (const auto band = bandIn(heading[i])) {
        requireRate(heading[i], path);
        addRate(*way == RailDirection::vertical ? vertical : lateral,
                bandOf(*band, path, "column '" + heading[i] + "'"), fields[i], path, cells.lines[row]);
      }
  }
}

// One row a third octave.
void readColumns(const text::Cells& cells, Values& vertical, Values& lateral, const std::string& path) {
  const auto& heading = cells.rows.front();
  if (text::lowerCase(text::bracketedHeading(heading.front()).unit) != "hz")
    throw FileError(path, "column '" + heading.front() + "'", "must be the frequency in Hz",
                    "Write frequency [Hz], vertical [dB/m], lateral [dB/m]");
  for (std::size_t row = 1; row < cells.rows.size(); ++row) {
    const auto& fields = cells.rows[row];
    const std::string where = "line " + std::to_string(cells.lines[row]);
    const auto frequency = fields.empty() ? std::nullopt : text::numberIn(fields[0], '.');
    if (!frequency) throw FileError(path, where, "has no frequency", "Begin each line with the third octave in Hz");
    const double band = bandOf(*frequency, path, where);
    for (std::size_t i = 1; i < std::min(fields.size(), heading.size()); ++i)
      if (const auto way = directionIn(text::bracketedHeading(heading[i]).name)) {
        requireRate(heading[i], path);
        addRate(*way == RailDirection::vertical ? vertical : lateral, band, fields[i], path, cells.lines[row]);
      }
  }
}

std::string rateText(double rate) { return text::formatted("%.1f", rate); }

}  // namespace

MeasuredDecay MeasuredDecayRates::at(double wanted, RailDirection direction) const {
  const auto found = std::find(band.begin(), band.end(), wanted);
  if (found == band.end()) return {};
  return (direction == RailDirection::vertical ? vertical : lateral)[static_cast<std::size_t>(found - band.begin())];
}

MeasuredDecayRates readMeasuredDecayRates(const std::string& path) {
  const auto cells = text::readCells(path, largestDecayFile);
  Values vertical, lateral;
  if (!cells.rows.empty()) {
    const auto& heading = cells.rows.front();
    const auto direction = std::find_if(heading.begin(), heading.end(), [](const std::string& name) {
      return text::lowerCase(name).find("direction") != std::string::npos || text::lowerCase(name) == "richtung";
    });
    if (direction != heading.end())
      readRows(cells, static_cast<std::size_t>(direction - heading.begin()), vertical, lateral, path);
    else
      readColumns(cells, vertical, lateral, path);
  }
  MeasuredDecayRates rates;
  for (const auto* values : {&vertical, &lateral})
    for (const auto& [band, all] : *values) rates.band.push_back(band);
  std::sort(rates.band.begin(), rates.band.end());
  rates.band.erase(std::unique(rates.band.begin(), rates.band.end()), rates.band.end());
  if (rates.band.empty())
    throw FileError(path, "", "has no decay rates",
                    "Give a column \"direction\" and one for each third octave (100 Hz [dB/m]), or frequency [Hz], "
                    "vertical [dB/m], lateral [dB/m]");
  for (const double band : rates.band)
    rates.vertical.push_back(spreadOf(vertical[band])), rates.lateral.push_back(spreadOf(lateral[band]));
  return rates;
}

std::string decayCsv(const DecayRates& rates, const MeasuredDecayRates* measured) {
  std::vector<std::string> names{"frequency [Hz]", "vertical [dB/m]", "lateral [dB/m]", "vertical limit [dB/m]",
                                 "lateral limit [dB/m]"};
  std::vector<std::vector<double>> columns(measured ? 11 : 5);
  columns[0] = rates.band, columns[1] = rates.vertical, columns[2] = rates.lateral;
  std::size_t column = 3;
  for (const auto direction : {RailDirection::vertical, RailDirection::lateral}) {
    for (const double band : rates.band) columns[column].push_back(decayLimit(band, direction));
    ++column;
  }
  if (measured)
    for (const auto direction : {RailDirection::vertical, RailDirection::lateral}) {
      const std::string word = direction == RailDirection::vertical ? "vertical" : "lateral";
      for (const char* what : {" measured lowest", " measured mean", " measured highest"})
        names.push_back(word + what + " [dB/m]");
      for (const double band : rates.band) {
        const auto at = measured->at(band, direction);
        const double none = std::nan("");
        columns[column].push_back(at.count ? at.lowest : none);
        columns[column + 1].push_back(at.count ? at.mean : none);
        columns[column + 2].push_back(at.count ? at.highest : none);
      }
      column += 3;
    }
  std::vector<const std::vector<double>*> all;
  for (const auto& values : columns) all.push_back(&values);
  return text::csvColumns(names, all);
}

std::string decaySummary(const DecayRates& rates, const MeasuredDecayRates* measured) {
  std::vector<std::string> head{"third octave", "vertical [dB/m]", "lateral [dB/m]"};
  if (measured) head.insert(head.end(), {"measured vertical", "measured lateral"});
  text::TextTable table(head);
  int within[2] = {0, 0}, known[2] = {0, 0};
  for (std::size_t b = 0; b < rates.band.size(); ++b) {
    std::vector<std::string> row{text::formatted("%.0f Hz", rates.band[b])};
    const double own[2] = {rates.vertical[b], rates.lateral[b]};
    for (const double rate : own) row.push_back(rateText(rate) + (rate < 2 * rates.smallest ? " (at most)" : ""));
    for (int way = 0; measured && way < 2; ++way) {
      const auto at = measured->at(rates.band[b], way ? RailDirection::lateral : RailDirection::vertical);
      known[way] += at.count > 0, within[way] += at.holds(own[way]);
      row.push_back(at.count == 0 ? "-"
                                  : rateText(at.lowest) + " to " + rateText(at.highest) +
                                        (at.holds(own[way])     ? ""
                                         : own[way] < at.lowest ? " below"
                                                                : " above"));
    }
    table.add(row);
  }
  std::string text = "Track decay rates after EN 15461:\n" + table.text();
  if (measured)
    text += "Within what was measured: vertical " + std::to_string(within[0]) + " of " + std::to_string(known[0]) +
            " third octaves, lateral " + std::to_string(within[1]) + " of " + std::to_string(known[1]) + "\n";
  for (const auto& note : rates.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace squat::receptance

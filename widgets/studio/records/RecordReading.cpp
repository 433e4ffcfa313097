#include "studio/records/RecordReading.h"

#include "analysis/OptionText.h"
#include "readers/SignalFile.h"
#include "text/Text.h"

namespace squat::studio {

records::RecordOptions readingOf(const project::LongRecords& chosen) {
  records::RecordOptions options;
  options.columns.column = chosen.channels;
  options.everyAcceleration = true;
  options.columns.speed = chosen.speed;
  if (!chosen.chainage.empty()) options.chainage = analysis::chainageFromText(chosen.chainage);
  if (chosen.units.empty()) return options;
  for (const auto& unit : text::split(chosen.units, ','))
    if (unit.find('=') == std::string::npos)
      options.columns.signalUnit = unit;
    else
      options.columns.units.push_back(analysis::columnUnitFromText(unit));
  return options;
}

records::Together togetherOf(const project::LongRecords& chosen) {
  return chosen.together == "ride"     ? records::Together::consecutive
         : chosen.together == "passes" ? records::Together::passes
                                       : records::Together::asTheyFollow;
}

signals::TimeSeries passageIn(const std::string& file) {
  return readers::passageWithPositions(readers::readSignals(file).front()).series;
}

}  // namespace squat::studio

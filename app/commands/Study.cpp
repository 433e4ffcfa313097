#include "commands/Study.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "case/DecimalNumber.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "core/Errors.h"
#include "laboratory/NumberTable.h"
#include "laboratory/RunFeatures.h"
#include "signals/SignalError.h"

namespace squat::commands {

namespace {

constexpr std::size_t kMostRuns = 10000;

[[noreturn]] void refuse(const std::string& text, const std::string& allowed, const std::string& advice) {
  throw CaseError({{"--vary", text, allowed, advice}});
}

std::vector<std::string> split(const std::string& text, char sign) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const auto end = std::min(text.find(sign, from), text.size());
    parts.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return parts;
}

// Values from..to rounded to 12 digits, so that 0.1:0.5:5 gives 0.3 and not 0.30000000000000004.
std::vector<std::string> spaced(const std::string& whole, const std::vector<std::string>& parts) {
  const auto from = cases::parseDecimal(parts[0]), to = cases::parseDecimal(parts[1]);
  std::size_t count = 0;
  const auto* end = parts[2].data() + parts[2].size();
  const bool counted = std::from_chars(parts[2].data(), end, count).ptr == end && !parts[2].empty();
  if (!from || !to || !counted || count < 1 || count > kMostRuns)
    refuse(whole, "KEY=FROM:TO:COUNT with a count from 1 to 10000", "Write for example --vary motion.speed=25:35:5");
  std::vector<std::string> values;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    char text[40];
    const auto last =
        std::to_chars(text, text + sizeof text, *from + share * (*to - *from), std::chars_format::general, 12);
    values.emplace_back(text, last.ptr);
  }
  return values;
}

}  // namespace

Variation variationFromText(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    refuse(text, "KEY=FROM:TO:COUNT or KEY=VALUE,VALUE,...", "Write for example --vary motion.speed=25:35:5");
  Variation variation{text.substr(0, equals), {}};
  const auto values = text.substr(equals + 1);
  if (!cases::findParameter(variation.key)) throw CaseError({cases::unknownKey(variation.key, values)});
  const auto parts = split(values, ':');
  variation.values = parts.size() == 3 ? spaced(text, parts) : split(values, ',');
  return variation;
}

std::vector<StudyRun> studyRuns(const std::vector<Variation>& variations) {
  std::size_t total = 1;
  for (std::size_t i = 0; i < variations.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (variations[j].key == variations[i].key)
        refuse(variations[i].key, "each key once", "Join its values in one --vary");
    total *= std::max<std::size_t>(1, variations[i].values.size());
    if (total > kMostRuns) refuse(std::to_string(total) + " runs", "at most 10000 runs", "Vary fewer keys or values");
  }
  const auto digits = static_cast<int>(std::max<std::size_t>(3, std::to_string(total).size()));
  std::vector<StudyRun> runs(total);
  for (std::size_t number = 0; number < total; ++number) {
    char name[24];
    std::snprintf(name, sizeof name, "%0*zu", digits, number + 1);
    runs[number].name = name;
    std::size_t rest = number;
    for (auto variation = variations.rbegin(); variation != variations.rend(); ++variation) {
      const auto& values = variation->values;
      runs[number].sets.insert(runs[number].sets.begin(), {variation->key, values[rest % values.size()]});
      rest /= values.size();
    }
  }
  return runs;
}

std::vector<std::pair<std::string, double>> studyFeatures(const results::RunResult& result) {
  std::vector<std::pair<std::string, double>> row;
  try {
    row = signals::featureRow(laboratory::runFeatures(result));
  } catch (const signals::SignalError&) {  // a smooth rail without an impact: only the rest is told
  }
  if (const auto* force = result.signal("contact_force"); force && !force->empty()) {
    const auto [low, high] = std::minmax_element(force->begin(), force->end());
    row.emplace_back("largest contact force [N]", *high);
    row.emplace_back("smallest contact force [N]", *low);
  }
  return row;
}

std::string studyCsv(const std::vector<StudyOutcome>& outcomes) {
  std::vector<std::string> names;  // of all features, in order of first appearance
  for (const auto& outcome : outcomes)
    for (const auto& feature : outcome.features)
      if (std::find(names.begin(), names.end(), feature.first) == names.end()) names.push_back(feature.first);

  std::string text = "run";
  if (!outcomes.empty())
    for (const auto& [key, value] : outcomes.front().run.sets) {
      const auto* parameter = cases::findParameter(key);
      const auto unit =
          parameter && !parameter->unit.empty() && parameter->unit != "-" ? " [" + parameter->unit + "]" : "";
      text += "," + laboratory::csvField(key + unit);
    }
  text += ",status";
  for (const auto& name : names) text += "," + laboratory::csvField(name);
  text += "\n";
  for (const auto& outcome : outcomes) {
    text += outcome.run.name;
    for (const auto& set : outcome.run.sets) text += "," + laboratory::csvField(set.second);
    text += "," + laboratory::csvField(outcome.status);
    for (const auto& name : names) {
      const auto found = std::find_if(outcome.features.begin(), outcome.features.end(),
                                      [&](const auto& feature) { return feature.first == name; });
      text += ",";
      if (found != outcome.features.end()) text += laboratory::numberText(found->second);
    }
    text += "\n";
  }
  return text;
}

}  // namespace squat::commands

#include "studies/EvaluationFiles.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>

#include "analysis/FeatureTable.h"
#include "case/RightSide.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::studies {
namespace {

constexpr std::size_t kLargestParameters = std::size_t{16} << 20;
constexpr const char* kParametersAdvice = "A parameters file of Dakota is expected, standard or for APREPRO";

struct Entry {
  std::string value, name;
  std::size_t line = 0;
};

bool isAprepro(const std::string& text) { return text.find_first_not_of(" \t\r\n") == text.find('{'); }

// "{ name = value }", the value of a text in quotes.
std::optional<Entry> apreproEntry(const std::string& line) {
  const auto open = line.find('{'), equals = line.find('='), close = line.rfind('}');
  if (open == std::string::npos || equals == std::string::npos || close == std::string::npos || equals > close)
    return std::nullopt;
  auto value = std::string(text::trimmed(line.substr(equals + 1, close - equals - 1)));
  if (value.size() > 1 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
  return Entry{value, std::string(text::trimmed(line.substr(open + 1, equals - open - 1))), 0};
}

// "value name"
std::optional<Entry> standardEntry(const std::string& line) {
  std::istringstream words(line);
  Entry entry;
  if (!(words >> entry.value >> entry.name)) return std::nullopt;
  return entry;
}

std::vector<Entry> entriesOf(const std::string& path) {
  const auto text = readWholeFile(path, kLargestParameters);
  const bool aprepro = isAprepro(text);
  std::vector<Entry> entries;
  std::istringstream lines(text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (text::trimmed(line).empty()) continue;
    auto entry = aprepro ? apreproEntry(line) : standardEntry(line);
    if (!entry) throw FileError(path, "line " + std::to_string(number), "is no value with a name", kParametersAdvice);
    entry->line = number;
    entries.push_back(*entry);
  }
  return entries;
}

// "right__pad__stiffness": dots are not allowed in Dakota's names.
std::string keyOf(std::string name) {
  if (cases::findOnEitherSide(name)) return name;
  for (auto at = name.find("__"); at != std::string::npos; at = name.find("__", at)) name.replace(at, 2, ".");
  return name;
}

std::size_t countIn(const Entry& entry, const std::string& path) {
  const auto count = text::numberFromText(entry.value);
  if (!count || *count < 0 || *count > 1e6 || *count != std::floor(*count))
    throw FileError(path, "line " + std::to_string(entry.line), "'" + entry.value + "' is no count", kParametersAdvice);
  return static_cast<std::size_t>(*count);
}

}  // namespace

EvaluationRequest readRequest(const std::string& path) {
  const auto entries = entriesOf(path);
  if (entries.empty() || (entries[0].name != "variables" && entries[0].name != "DAKOTA_VARS"))
    throw FileError(path, "line 1", "does not say how many variables there are", kParametersAdvice);
  const auto variables = countIn(entries[0], path);
  if (entries.size() <= variables + 1) throw FileError(path, "", "is cut off", kParametersAdvice);
  EvaluationRequest request;
  for (std::size_t i = 1; i <= variables; ++i) request.values.emplace_back(keyOf(entries[i].name), entries[i].value);
  const auto functions = countIn(entries[variables + 1], path);
  if (entries.size() < variables + 2 + functions) throw FileError(path, "", "is cut off", kParametersAdvice);
  for (std::size_t i = 0; i < functions; ++i) {
    const auto& entry = entries[variables + 2 + i];  // "1 ASV_1:name", "{ ASV_1:name = 1 }"
    const auto colon = entry.name.find(':');
    const auto asked = countIn(entry, path);
    if (asked > 1)
      throw FileError(path, "line " + std::to_string(entry.line), "asks for derivatives",
                      "Choose no_gradients and no_hessians, or numerical_gradients, in Dakota's responses");
    if (asked == 1 && colon != std::string::npos) request.features.push_back(entry.name.substr(colon + 1));
  }
  return request;
}

std::string answerText(const FeatureRow& features, const std::vector<std::string>& names) {
  std::string answer;
  std::vector<CaseProblem> problems;
  for (const auto& name : names) {
    const auto found = std::find_if(features.begin(), features.end(), [&](const auto& feature) {
      return feature.first == name || analysis::featureWord(feature.first) == name;
    });
    if (found == features.end()) {
      std::string all;
      for (const auto& feature : features) all += (all.empty() ? "" : ", ") + analysis::featureWord(feature.first);
      problems.push_back({"--features", name, "one of " + all, ""});
      continue;
    }
    if (std::isnan(found->second)) throw RunError(found->first + " has no value in this run", 0, 0, "");
    char number[40];
    std::snprintf(number, sizeof number, "%.16e", found->second);
    answer += std::string(number) + " " + analysis::featureWord(found->first) + "\n";
  }
  if (!problems.empty()) throw CaseError(problems);
  return answer;
}

}  // namespace squat::studies

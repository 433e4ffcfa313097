#include "estimation/ModelSpread.h"

#include <algorithm>
#include <cmath>

#include "case/BeforeDefect.h"
#include "case/InputPresets.h"
#include "core/Errors.h"

namespace squat::estimation {

namespace {

constexpr const char* kKey = "wheelset.preset";

// The case with the wheelset of a name; nothing where it cannot be read so.
std::optional<cases::CaseDescription> caseWith(const EstimateDefinition& definition, const std::string& name) {
  auto overrides = definition.overrides;
  auto& values = overrides.values;
  values.erase(std::remove_if(values.begin(), values.end(), [](const auto& each) { return each.first == kKey; }),
               values.end());
  values.emplace_back(kKey, name);
  try {
    return cases::loadCase(definition.caseName, overrides);
  } catch (const CaseError&) {
    return std::nullopt;
  }
}

ProfilePoints scaled(ProfilePoints points, double factor) {
  for (auto& point : points) point.height *= factor;
  return points;
}

// The factor by which the computed signal falls short of the measured one.
double ratioOf(const std::vector<PositionSeries>& response, const std::vector<ComparedPassage>& passages) {
  double both = 0, own = 0;
  for (const auto& passage : passages) {
    const auto& computed = response[passage.model];
    const auto ours = valuesAt(computed, passage.locations, 0);
    const auto theirs = valuesAt(passage.measured, passage.locations, shiftOf(passage, computed));
    for (const double value : theirs) both += value * value / (passage.noise * passage.noise);
    for (const double value : ours) own += value * value / (passage.noise * passage.noise);
  }
  return own > 0 ? std::clamp(std::sqrt(both / own), 0.25, 4.0) : 1;
}

}  // namespace

std::optional<std::vector<OtherWheelset>> otherWheelsets(const SpreadQuestion& question, const ProfilePoints& points,
                                                         int& runs, Monitor& monitor) {
  constexpr int rounds = 3;
  const auto& definition = question.definition;
  const auto own = cases::loadCase(definition.caseName, definition.overrides);
  std::vector<std::string> known{cases::hashBeforeDefect(own)};
  std::vector<OtherWheelset> found;
  for (const auto& name : cases::inputPresetNames(kKey)) {
    const auto description = caseWith(definition, name);
    if (!description) continue;
    const auto hash = cases::hashBeforeDefect(*description);
    if (std::find(known.begin(), known.end(), hash) != known.end()) continue;
    known.push_back(hash);
    try {
      simulation::RunOptions options;
      options.threads = question.options.threads, options.isa = question.options.isa;
      options.wheelsetModes = false, options.snapshots = false;
      std::vector<PassageModel> models;
      for (const double speed : question.speeds)
        models.emplace_back(caseForSearch(*description, question.window, speed, definition.cutoff), options);
      for (auto& model : models)
        if (!model.warmUp(question.options.threads * question.options.jobs, monitor)) return std::nullopt;
      ProfileRuns other(models, question.options.jobs, rounds, monitor);
      other.setPhase("wheelset " + name);
      double factor = 1;
      for (int round = 0; round < rounds; ++round) {
        const auto response = other.all({scaled(points, factor)}).front();
        if (monitor.cancelled()) return std::nullopt;
        if (!response) break;
        factor *= ratioOf(*response, question.passages);
      }
      runs += other.done();
      found.push_back({name, factor});
    } catch (const CaseError&) {
      continue;
    } catch (const RunError&) {
      continue;
    }
  }
  return found;
}

}  // namespace squat::estimation

#include "studies/SharedStart.h"

#include <algorithm>
#include <utility>

#include "case/BeforeDefect.h"
#include "case/Resolve.h"
#include "case/RightSide.h"
#include "core/Errors.h"
#include "text/Numbers.h"

namespace squat::studies {

namespace {

bool variesOnlyTheDefect(const StudyDefinition& definition) {
  return std::all_of(definition.variations.begin(), definition.variations.end(), [](const Variation& variation) {
    const auto* parameter = cases::findOnEitherSide(variation.key);
    const bool isZone = variation.key == "mesh.zone_before" || variation.key == "mesh.zone_behind";
    return parameter && !isZone && !cases::countsBeforeDefect(*parameter);
  });
}

void setZone(cases::CaseDescription& description, const cases::DefectZone& zone) {
  if (cases::defectZone(description) == zone) return;
  description.mesh.zoneBefore = zone.before, description.mesh.zoneBehind = zone.behind;
}

// The first case of the study that can be run, with a zone for the defects of all; none where some have moved nodes.
std::optional<cases::CaseDescription> caseOfAll(const StudyDefinition& definition,
                                                const cases::CaseOverrides& overrides) {
  std::optional<cases::CaseDescription> base;
  cases::DefectZone zone;
  for (const auto& point : gridOf(definition)) {
    try {
      const auto description = caseAt(definition, overrides, point);
      if (cases::hasMovedNodes(description)) return std::nullopt;
      const auto own = cases::defectZone(description);
      zone = {std::max(zone.before, own.before), std::max(zone.behind, own.behind)};
      if (!base) base = description;
    } catch (const CaseError&) {
      // a failed row of the table
    } catch (const FileError&) {
    }
  }
  if (base) setZone(*base, zone);
  return base;
}

bool concernsTheState(const CaseError& error) { return error.problems().front().key == "--warm"; }

}  // namespace

SharedStart::SharedStart(const StudyDefinition& definition, const cases::CaseOverrides& overrides,
                         simulation::RunOptions options, int threads)
    : options_(std::move(options)), threads_(threads) {
  if (variesOnlyTheDefect(definition)) base_ = caseOfAll(definition, overrides);
}

std::string SharedStart::text() const {
  if (!base_) return {};
  const auto zone = cases::defectZone(*base_);
  return "zone " + text::numberText(zone.before) + ":" + text::numberText(zone.behind);
}

SharedStart::Made SharedStart::stateFor(Monitor& monitor) {
  const std::lock_guard lock(mutex_);
  if (isMade_) return {state_, false};
  auto options = options_;
  options.threads = threads_;
  try {
    auto made = simulation::makeWarmState(*base_, options, monitor);
    if (!made) return {nullptr, true};
    state_ = std::make_shared<const simulation::WarmState>(*std::move(made));
  } catch (const CaseError&) {
    // Each run says itself what is wrong with it, or that nothing is but that there is no room to start in.
  } catch (const RunError&) {
  }
  isMade_ = true;
  return {state_, false};
}

results::RunResult SharedStart::run(const cases::CaseDescription& description, Monitor& monitor) {
  if (!base_) return simulation::runCase(description, options_, monitor);
  auto meshed = description;
  setZone(meshed, cases::defectZone(*base_));
  const auto made = stateFor(monitor);
  if (made.cancelled) return {};
  auto options = options_;
  if (made.state && simulation::fits(*made.state, meshed)) options.warm = made.state;
  try {
    return simulation::runCase(meshed, options, monitor);
  } catch (const CaseError& error) {
    if (!options.warm || !concernsTheState(error)) throw;
  }
  options.warm.reset();  // a profile that the wheel feels earlier than the others
  return simulation::runCase(meshed, options, monitor);
}

}  // namespace squat::studies

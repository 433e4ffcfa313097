#include "simulation/WarmStateFile.h"

#include <cmath>

#include "case/BeforeDefect.h"
#include "case/CaseFile.h"
#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "results/StateFile.h"

namespace squat::simulation {

namespace {

constexpr results::StateKind kKind{"squat-warm-state", 1, "a warm state", "make it again with squat warm"};

cases::CaseDescription caseIn(const results::ArrayTree& state, const std::string& path) {
  const auto damaged = [&](const std::string& why) {
    return FileError(path, "attribute case_toml", why, results::asSentence(kKind.insteadOf));
  };
  cases::CaseDescription description;
  try {
    description = cases::parseCaseOfResult(results::textAttribute(state.attributes, "case_toml"), path);
  } catch (const std::runtime_error& error) {  // CaseError, FileError
    throw damaged(std::string("is no case that this version can read: ") + error.what());
  }
  if (cases::hashBeforeDefect(description) != results::textAttribute(state.attributes, "shared_hash"))
    throw damaged("does not match the stored hash");
  return description;
}

}  // namespace

void writeWarmState(const std::string& path, const WarmState& warm) {
  auto state = warm.state;
  setAttribute(state.attributes, "case_toml", cases::writeCase(warm.description));
  setAttribute(state.attributes, "shared_hash", cases::hashBeforeDefect(warm.description));
  setAttribute(state.attributes, "position", warm.position);
  results::writeState(path, std::move(state), kKind, Previous::replaced);
}

WarmState readWarmState(const std::string& path) {
  WarmState warm;
  warm.file = path;
  warm.state = results::readState(path, kKind);
  if (const auto version = results::textAttribute(warm.state.attributes, "code_version"); version != programVersion())
    throw FileError(path, "attribute code_version", "was written by version " + version + " of the program",
                    results::asSentence(kKind.insteadOf));
  warm.description = caseIn(warm.state, path);
  warm.position = results::numberAttribute(warm.state.attributes, "position", std::nan(""));
  if (!std::isfinite(warm.position))
    throw FileError(path, "attribute position", "is missing or wrong", results::asSentence(kKind.insteadOf));
  return warm;
}

}  // namespace squat::simulation

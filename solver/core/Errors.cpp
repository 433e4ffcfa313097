#include "core/Errors.h"

#include <cstdio>

namespace squat {

namespace {

std::string sentence(const CaseProblem& problem, const std::string& verb) {
  std::string text = problem.key;
  if (!problem.value.empty()) text += " is " + problem.value;
  if (!problem.allowed.empty()) text += (problem.value.empty() ? " " : ", ") + verb + " be " + problem.allowed;
  if (!problem.advice.empty()) text += (problem.allowed.empty() ? ": " : ". ") + problem.advice;
  return text;
}

}  // namespace

std::string toText(const CaseProblem& problem) { return sentence(problem, "must"); }

std::string toWarning(const CaseProblem& problem) { return sentence(problem, "should"); }

namespace {

std::string joined(const std::vector<CaseProblem>& problems) {
  std::string text;
  for (const auto& problem : problems) {
    if (!text.empty()) text += "\n";
    text += toText(problem);
  }
  return text;
}

std::string runText(const std::string& what, long step, double time, const std::string& location) {
  char where[96];
  std::snprintf(where, sizeof where, " (step %ld, time %.6f ms", step, time * 1e3);
  return what + where + (location.empty() ? ")" : ", " + location + ")");
}

std::string fileText(const std::string& path, const std::string& location, const std::string& what,
                     const std::string& advice) {
  std::string text = path;
  if (!location.empty()) text += ", " + location;
  text += ": " + what;
  if (!advice.empty()) text += ". " + advice;
  return text;
}

}  // namespace

CaseError::CaseError(std::vector<CaseProblem> problems)
    : std::runtime_error(joined(problems)), problems_(std::move(problems)) {}

RunError::RunError(const std::string& what, long step, double time, std::string location)
    : std::runtime_error(runText(what, step, time, location)),
      step_(step),
      time_(time),
      location_(std::move(location)) {}

FileError::FileError(std::string path, std::string location, const std::string& what, const std::string& advice)
    : std::runtime_error(fileText(path, location, what, advice)),
      path_(std::move(path)),
      location_(std::move(location)) {}

}  // namespace squat

// solver/core/Errors.h - the three kinds of error: invalid case, failed run, invalid file. Cancelling is an outcome,
// not an error.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace squat {

// One error in a case: where it is, what was found, what is allowed, and what to do.
struct CaseProblem {
  std::string key;      // path in the case, e.g. "pad.stiffness", or the option of the call; with the line of the file
  std::string value;    // what was found, as text; empty where the key itself is the error, or its value a long list
  std::string allowed;  // range or list of allowed values, with unit, as it reads after "must be"; may be empty
  std::string advice;   // what the user can do
};

// "pad.stiffness is 0 MN/m, must be 1 to 20000 MN/m. Advice"; without allowed values: "pad.stifness: advice".
std::string toText(const CaseProblem& problem);

// The same for a case that can be run nevertheless: "should be" in place of "must be".
std::string toWarning(const CaseProblem& problem);

// Invalid case or call (exit code 2). Carries every problem found, not only the first.
class CaseError : public std::runtime_error {
 public:
  explicit CaseError(std::vector<CaseProblem> problems);
  const std::vector<CaseProblem>& problems() const { return problems_; }

 private:
  std::vector<CaseProblem> problems_;
};

// Failed run (exit code 3): what happened, at which step and time, in which element or node.
class RunError : public std::runtime_error {
 public:
  RunError(const std::string& what, long step, double time, std::string location);
  long step() const { return step_; }
  double time() const { return time_; }  // [s] simulated
  const std::string& location() const { return location_; }

 private:
  long step_;
  double time_;
  std::string location_;
};

// Invalid file, or one that cannot be written (exit code 4): its path, the line or object in it, advice.
class FileError : public std::runtime_error {
 public:
  FileError(std::string path, std::string location, const std::string& what, const std::string& advice = {});
  const std::string& path() const { return path_; }
  const std::string& location() const { return location_; }

 private:
  std::string path_;
  std::string location_;
};

}  // namespace squat

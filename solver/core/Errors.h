// solver/core/Errors.h - the three kinds of error that a user can meet. Cancelling is an outcome, not an error.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace squat {

// One mistake in a case: where it stands, what stands there, what may stand there, and what to do.
struct CaseProblem {
  std::string key;      // path in the case, e.g. "pad.stiffness"; with the line where the file has one
  std::string value;    // what was found, as text
  std::string allowed;  // range or list of allowed values, with unit
  std::string advice;   // what the user can do
};

std::string toText(const CaseProblem& problem);

// The case or the call is wrong (exit code 2). Carries every problem found, not only the first.
class CaseError : public std::runtime_error {
 public:
  explicit CaseError(std::vector<CaseProblem> problems);
  const std::vector<CaseProblem>& problems() const { return problems_; }

 private:
  std::vector<CaseProblem> problems_;
};

// The run failed (exit code 3): what happened, at which step and time, in which element or node.
class RunError : public std::runtime_error {
 public:
  RunError(const std::string& what, long step, double time, std::string place);
  long step() const { return step_; }
  double time() const { return time_; }  // [s] simulated
  const std::string& place() const { return place_; }

 private:
  long step_;
  double time_;
  std::string place_;
};

// A file is wrong or cannot be written (exit code 4): its path, the line or object in it, advice.
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

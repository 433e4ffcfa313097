// app/commands/TerminalMonitor.h - progress of a run on a terminal or in a log.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <set>
#include <string>

#include "core/Monitor.h"

namespace squat::commands {

// "rolling  42 %  t 12.30 ms  x -0.123 m  N 86.1 kN  ABA -3.2 m/s²  about 2 min left"; fields not known are left out.
// The phase is never cut; values in the middle that would make the line longer than `maximumLength` are left out.
std::string progressText(const Progress& progress, std::size_t maximumLength = 1000);

// One line that is written over on a terminal; else plain lines, at most one every two seconds and one for each phase.
class TerminalMonitor : public Monitor {
 public:
  explicit TerminalMonitor(std::FILE* stream);  // a terminal or not
  TerminalMonitor(std::FILE* stream, bool isTerminal) : stream_(stream), isTerminal_(isTerminal) {}
  ~TerminalMonitor() override { clearLine(); }
  void report(const Progress& progress) override;
  void message(const std::string& text) override;
  bool cancelled() override;
  void clearLine();

 private:
  using Clock = std::chrono::steady_clock;
  std::FILE* stream_;
  bool isTerminal_, lineStands_ = false;
  std::string phase_;
  std::set<std::string> reported_;  // phases that had their line; jobs of a study take turns
  Clock::time_point last_{};
};

}  // namespace squat::commands

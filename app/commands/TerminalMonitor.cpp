#include "commands/TerminalMonitor.h"

#include <cmath>

#include "commands/Interrupt.h"

namespace squat::commands {

namespace {

constexpr auto kBetweenLines = std::chrono::seconds(2);
constexpr auto kBetweenRefreshes = std::chrono::milliseconds(100);

template <typename... Values>
void append(std::string& text, const char* format, Values... values) {
  char part[96];
  std::snprintf(part, sizeof part, format, values...);
  text += part;
}

void appendRemaining(std::string& text, double seconds) {
  if (!(seconds >= 0) || seconds > 1e7) return;
  if (seconds < 90)
    append(text, "  about %.0f s left", std::ceil(seconds));
  else if (seconds < 5400)
    append(text, "  about %.0f min left", seconds / 60);
  else
    append(text, "  about %.1f h left", seconds / 3600);
}

}  // namespace

std::string progressText(const Progress& progress) {
  std::string text;
  append(text, "%-12s %3.0f %%", progress.phase.substr(0, 40).c_str(), 100 * progress.fraction);
  if (progress.simulatedTime > 0) append(text, "  t %.2f ms", 1e3 * progress.simulatedTime);
  if (progress.simulatedTime > 0) append(text, "  x %.3f m", progress.position);
  if (progress.contactForce != 0) append(text, "  N %.1f kN", 1e-3 * progress.contactForce);
  if (progress.axleBoxAcceleration != 0) append(text, "  ABA %.1f m/s2", progress.axleBoxAcceleration);
  appendRemaining(text, progress.remainingSeconds);
  return text;
}

void TerminalMonitor::report(const Progress& progress) {
  const auto now = Clock::now();
  const bool newPhase = progress.phase != phase_ && told_.insert(progress.phase).second;
  if (!newPhase && now - last_ < (isTerminal_ ? Clock::duration(kBetweenRefreshes) : Clock::duration(kBetweenLines)))
    return;
  last_ = now;
  phase_ = progress.phase;
  const auto text = progressText(progress);
  if (isTerminal_) {
    std::fprintf(stream_, "\r\033[K%s", text.c_str());
    lineStands_ = true;
  } else {
    std::fprintf(stream_, "%s\n", text.c_str());
  }
  std::fflush(stream_);
}

void TerminalMonitor::message(const std::string& text) {
  clearLine();
  std::fprintf(stream_, "%s\n", text.c_str());
  std::fflush(stream_);
}

bool TerminalMonitor::cancelled() { return InterruptGuard::asked(); }

void TerminalMonitor::clearLine() {
  if (!lineStands_) return;
  std::fputs("\r\033[K", stream_);
  std::fflush(stream_);
  lineStands_ = false;
}

}  // namespace squat::commands

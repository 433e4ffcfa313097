#include "commands/TerminalMonitor.h"

#include <cmath>

#include "commands/Interrupt.h"
#include "core/platform/Terminal.h"
#include "text/Numbers.h"

namespace squat::commands {

using text::formatted;

namespace {

constexpr auto kBetweenLines = std::chrono::seconds(2);
constexpr auto kBetweenRefreshes = std::chrono::milliseconds(100);

std::string remainingText(double seconds) {
  if (!(seconds >= 0) || seconds > 1e7) return {};
  if (seconds < 90) return formatted("  about %.0f s left", std::ceil(seconds));
  if (seconds < 5400) return formatted("  about %.0f min left", seconds / 60);
  return formatted("  about %.1f h left", seconds / 3600);
}

// Characters in a line of the terminal; what is longer would wrap, and the carriage return would not take it back.
std::size_t columnsOf(std::FILE* stream) {
  constexpr std::size_t usual = 80;
  const auto columns = platform::columnsOfTerminal(stream);
  return columns > 1 ? columns : usual;
}

}  // namespace

std::string progressText(const Progress& progress, std::size_t maximumLength) {
  std::string text = progress.phase;
  if (text.size() < 12) text.resize(12, ' ');
  text += formatted(" %3.0f %%", 100 * progress.fraction);
  const std::string remaining = remainingText(progress.remainingSeconds);
  const auto add = [&](const std::string& field) {
    if (text.size() + field.size() + remaining.size() <= maximumLength) text += field;
  };
  if (progress.simulatedTime > 0) add(formatted("  t %.2f ms", 1e3 * progress.simulatedTime));
  if (progress.simulatedTime > 0) add(formatted("  x %.3f m", progress.position));
  if (progress.contactForce != 0) add(formatted("  N %.1f kN", 1e-3 * progress.contactForce));
  if (progress.axleBoxAcceleration != 0) add(formatted("  ABA %.1f m/s²", progress.axleBoxAcceleration));
  return text + remaining;
}

TerminalMonitor::TerminalMonitor(std::FILE* stream) : TerminalMonitor(stream, platform::isTerminal(stream)) {}

void TerminalMonitor::report(const Progress& progress) {
  const auto now = Clock::now();
  const bool newPhase = progress.phase != phase_ && reported_.insert(progress.phase).second;
  if (!newPhase && now - last_ < (isTerminal_ ? Clock::duration(kBetweenRefreshes) : Clock::duration(kBetweenLines)))
    return;
  last_ = now;
  phase_ = progress.phase;
  const auto text = isTerminal_ ? progressText(progress, columnsOf(stream_) - 1) : progressText(progress);
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

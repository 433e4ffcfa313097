#include "results/SignalTable.h"

#include <charconv>

#include "core/DurableFile.h"

namespace squat::results {

namespace {

void append(std::string& text, double value) {
  char digits[40];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;  // never asks the locale
  text.append(digits, end);
}

}  // namespace

std::string signalTable(const RunResult& result) {
  std::string text = "time [s],position [m]";
  for (const auto& channel : result.signals) text += "," + channel.name + " [" + channel.unit + "]";
  text += "\n";
  for (std::size_t i = 0; i < result.time.size() && i < result.position.size(); ++i) {
    append(text, result.time[i]);
    text += ",";
    append(text, result.position[i]);
    for (const auto& channel : result.signals) {
      text += ",";
      if (i < channel.values.size()) append(text, channel.values[i]);
    }
    text += "\n";
  }
  return text;
}

void writeSignalTable(const std::string& path, const RunResult& result) { writeDurably(path, signalTable(result)); }

}  // namespace squat::results

#include "results/SignalTable.h"

#include "core/DurableFile.h"
#include "text/Csv.h"

namespace squat::results {

std::string signalTable(const RunResult& result) {
  std::vector<std::string> names{"time [s]", "position [m]"};
  std::vector<const std::vector<double>*> columns{&result.time, &result.position};
  for (const auto& channel : result.signals) {
    names.push_back(channel.name + " [" + channel.unit + "]");
    columns.push_back(&channel.values);
  }
  return text::csvColumns(names, columns);
}

void writeSignalTable(const std::string& path, const RunResult& result) { writeDurably(path, signalTable(result)); }

}  // namespace squat::results

#include "commands/RoughnessOptions.h"

#include <cstdio>
#include <tuple>

#include "case/Resolve.h"
#include "core/Errors.h"
#include "text/Numbers.h"

namespace squat::commands {

namespace {

// "10-1000" in mm.
std::pair<double, double> wavesFrom(const std::string& text) {
  const auto dash = text.find('-');
  const auto low = dash == std::string::npos ? std::nullopt : text::numberIn(text.substr(0, dash), '.');
  const auto high = dash == std::string::npos ? std::nullopt : text::numberIn(text.substr(dash + 1), '.');
  if (!low || !high || !(*low >= 1) || !(*high >= *low) || !(*high <= 5000))
    throw CaseError({{"--waves", text, "SHORTEST-LONGEST in mm, 1 to 5000", "Write for example 10-315"}});
  return {1e-3 * *low, 1e-3 * *high};
}

}  // namespace

void addRoughnessOptions(CLI::App& command, RoughnessOptions& options) {
  auto* asked = command
                    .add_option("--roughness", options.caseOptions.name,
                                "Also give the roughness of rail and wheel that the record implies with vehicle and "
                                "track of this case: third octaves of wavelength and corrugation indices")
                    ->type_name("CASE");
  command
      .add_option("--roughness-set", options.caseOptions.sets,
                  "Set one key of the case of --roughness, as --set of squat run; repeatable")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE")
      ->needs(asked);
  command
      .add_option("--contact-filter", options.filter,
                  "What the contact patch passes on of short waves: remington (real rails), uniform (heights that are "
                  "the same across the rail, as those of computed records) or none (default: remington)")
      ->type_name("NAME")
      ->needs(asked);
  command.add_option("--waves", options.waves, "Shortest and longest wavelength in mm (default: 10-1000)")
      ->type_name("LOW-HIGH")
      ->needs(asked);
}

roughness::GaugeOptions gaugeOptions(const RoughnessOptions& options) {
  roughness::GaugeOptions gauge;
  std::tie(gauge.shortest, gauge.longest) = wavesFrom(options.waves);
  gauge.filter = roughness::contactFilterFromText(options.filter, "--contact-filter");
  return gauge;
}

roughness::TransferFunction transferFunctionOf(const RoughnessOptions& options, int threads, TerminalMonitor& monitor) {
  roughness::TransferOptions transfer;
  transfer.threads = threads;
  return roughness::transferFunction(cases::resolve(readCase(options.caseOptions)), transfer, monitor);
}

void printRoughness(const std::vector<roughness::NamedRoughness>& all, std::FILE* list) {
  for (const auto& each : all) std::fprintf(list, "\n%s", roughness::roughnessSummary(each).c_str());
}

std::vector<std::string> writeRoughnessOutput(const std::vector<roughness::NamedRoughness>& all,
                                              const roughness::TransferFunction& transfer,
                                              const RoughnessOptions& options, const std::string& folder,
                                              const FigureChoice& figures) {
  auto paths = roughness::writeRoughness(all, transfer, options.caseOptions.name, folder);
  for (const auto& path : writeRoughnessFigures(all, folder, figures)) paths.push_back(path);
  return paths;
}

}  // namespace squat::commands

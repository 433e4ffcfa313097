#include <cmath>
#include <cstdio>

#include "analysis/Analysis.h"
#include "analysis/AnalysisFiles.h"
#include "analysis/OptionText.h"
#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/FigureSheets.h"
#include "commands/Interrupt.h"
#include "commands/NumberRange.h"
#include "commands/RoughnessOptions.h"
#include "commands/SignalOptions.h"
#include "commands/TerminalMonitor.h"
#include "core/Errors.h"
#include "roughness/RecordRoughness.h"
#include "text/Numbers.h"
#include "text/TextTable.h"
#include "text/Units.h"

namespace squat::commands {

namespace {

using text::roundedText;
using text::TextTable;

struct AnalyseOptions {
  std::vector<std::string> files, bands;
  std::string folder, window = "hann", detrend = "constant";
  SignalOptions signal;
  analysis::AnalysisOptions analysis;
  FigureChoice figures;
  RoughnessOptions roughness;
  bool noAlignment = false, json = false, amplitude = false;
};

void printSpectrum(const char* name, const signals::PowerSpectrum& spectrum) {
  const auto unit = spectrum.unit.empty() ? std::string("unit") : text::printedUnit(spectrum.unit);
  std::printf("  PSD of the %s: integral %s, mean square %s (%s)²; %s\n", name, roundedText(spectrum.integral).c_str(),
              roundedText(spectrum.meanSquare).c_str(), unit.c_str(), spectrum.window.c_str());
}

void printAnalysis(const analysis::Analysis& analysis) {
  if (analysis.signals.empty()) return;
  std::vector<std::string> head{"feature"};
  for (const auto& signal : analysis.signals) head.push_back(signal.run);
  TextTable table(head);
  const auto features = analysis::featureTable(analysis);
  for (std::size_t row = 0; row < features.names.size(); ++row) {
    std::vector<std::string> cells{text::withPrintedUnit(features.names[row])};
    for (const auto& column : features.values)
      cells.push_back(std::isnan(column[row]) ? "-" : roundedText(column[row]));
    table.add(cells);
  }
  for (const auto& signal : analysis.signals) {
    std::printf("%s, %s\n", signal.file.c_str(), signal.run.c_str());
    std::printf("  features anchored at: %s, %s\n", signals::toText(signal.features.anchor).c_str(),
                roundedText(1e3 * signal.features.impactTime, "ms").c_str());
    printSpectrum("whole record", signal.spectrum);
    printSpectrum("window around the anchor", signal.features.spectrum);
    for (const auto& note : signal.notes) std::printf("  note: %s\n", note.c_str());
  }
  std::printf("\n%s", table.text().c_str());
  if (analysis.dispersion) {
    const auto& [peak, wave] = *analysis.dispersion;
    std::printf("\n%zu runs aligned: largest peak, mean %s, range / mean %s", analysis.signals.size(),
                roundedText(peak.mean, text::printedUnit(analysis.signals.front().features.unit)).c_str(),
                roundedText(100 * peak.range, "%").c_str());
    if (!std::isnan(wave.mean))
      std::printf("; wavelength, mean %s, range / mean %s", roundedText(1e3 * wave.mean, "mm").c_str(),
                  roundedText(100 * wave.range, "%").c_str());
    std::printf("\n");
  }
  for (const auto& note : analysis.notes) std::printf("note: %s\n", note.c_str());
}

// Of the signals as they were read, before any filter.
std::vector<roughness::NamedRoughness> roughnessOfAll(const analysis::Analysis& analysis,
                                                      const roughness::TransferFunction& transfer,
                                                      const RoughnessOptions& options) {
  std::vector<roughness::NamedRoughness> all;
  if (!transfer.complete) return all;
  for (const auto& signal : analysis.signals)
    all.emplace_back(signal.run, roughness::roughnessOf(signal.passage, transfer, gaugeOptions(options)));
  return all;
}

int analyse(const AnalyseOptions& given) {
  auto options = given.analysis;
  options.file = fileOptions(given.signal);
  options.align = !given.noAlignment;
  if (given.amplitude) options.wavelet.normalisation = signals::WaveletNormalisation::amplitude;
  analysis::setWindow(options.spectrum, given.window);
  analysis::setDetrend(options.spectrum, given.detrend);
  for (const auto& text : given.bands) {
    auto band = analysis::bandFromText(text);
    for (const auto& other : options.features.bands)
      if (other.name == band.name)
        throw CaseError({{"--band", text, "a unique name", "Band '" + band.name + "' already exists"}});
    options.features.bands.push_back(std::move(band));
  }

  if (given.roughness.asked()) gaugeOptions(given.roughness);  // what is wrong with it is said before the work
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  const auto analysis = analysis::analyse(given.files, options, monitor);
  roughness::TransferFunction transfer;
  if (given.roughness.asked() && !InterruptGuard::asked()) transfer = transferFunctionOf(given.roughness, 0, monitor);
  monitor.clearLine();
  const auto rough = roughnessOfAll(analysis, transfer, given.roughness);
  if (given.json)
    std::printf("%s\n", analysis::featureJson(analysis).c_str());
  else
    printAnalysis(analysis);
  printRoughness(rough, given.json ? stderr : stdout);
  if (InterruptGuard::asked()) return kCancelled;
  if (given.folder.empty()) return kDone;
  const auto tables = analysis::writeAnalysis(analysis, given.folder);
  std::FILE* const list = given.json ? stderr : stdout;
  std::fprintf(list, "\nwritten:\n");
  for (const auto& path : tables) std::fprintf(list, "  %s\n", path.c_str());
  if (!rough.empty())
    for (const auto& path : writeRoughnessOutput(rough, transfer, given.roughness, given.folder, given.figures))
      std::fprintf(list, "  %s\n", path.c_str());
  for (const auto& path : writeAnalysisFigures(analysis, given.folder, given.figures))
    std::fprintf(list, "  %s\n", path.c_str());
  return kDone;
}

}  // namespace

void addAnalyseCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("analyse", "Compute spectra and features of measured or computed signals");
  auto options = std::make_shared<AnalyseOptions>();
  command->add_option("signals", options->files, "CSV, HDF5 or MATLAB files")->required()->type_name("SIGNAL...");
  command->add_option("-o,--output", options->folder, "Folder for tables and figures (default: print only)")
      ->type_name("DIR");
  addSignalOptions(*command, options->signal);
  auto& analysis = options->analysis;
  command
      ->add_option("--low-pass", analysis.lowPass, "Zero-phase low-pass filter applied first; 0: none (default: 2000)")
      ->check(between(0.0, 1e7))
      ->type_name("HZ");
  command->add_option("--band", options->bands, "Additional band: 250-350 or name=250-350; repeatable")
      ->allow_extra_args(false)
      ->type_name("LOW-HIGH");
  command->add_option("--window", options->window, "boxcar, hann, hamming or blackman (default: hann)")
      ->type_name("NAME");
  command->add_option("--detrend", options->detrend, "none, constant or linear (default: constant)")->type_name("NAME");
  command
      ->add_option("--segment", analysis.spectrum.segment,
                   "Samples per segment of Welch's method, whole record (default: automatic)")
      ->check(zeroOrBetween(2, 1 << 30))
      ->type_name("N");
  command->add_option("--overlap", analysis.spectrum.overlap, "Overlap of segments, 0 to 0.99 (default: 0.5)")
      ->check(between(0.0, 0.99))
      ->type_name("SHARE");
  command->add_option("--stft-segment", analysis.stft.segment, "Samples per STFT window (default: 10 ms)")
      ->check(CLI::Range(2, 1 << 24))
      ->type_name("N");
  command->add_option("--stft-hop", analysis.stft.hop, "Samples between STFT windows (default: at most 2000 columns)")
      ->check(CLI::Range(1, 1 << 24))
      ->type_name("N");
  command->add_option("--voices", analysis.wavelet.voicesPerOctave, "Voices per octave of the scalogram (default: 16)")
      ->check(between(1.0, 200.0))
      ->type_name("N");
  command->add_option("--lowest", analysis.wavelet.lowest, "Lowest frequency of the scalogram (default: 50)")
      ->check(between(1e-3, 1e7))
      ->type_name("HZ");
  command->add_option("--highest", analysis.wavelet.highest, "Highest frequency of the scalogram (default: 2500)")
      ->check(between(1e-3, 1e7))
      ->type_name("HZ");
  command->add_flag("--amplitude", options->amplitude,
                    "Amplitude scalogram: a tone of amplitude 1 gives 1 (default: equation 1 of the paper)");
  command->add_flag("--no-alignment", options->noAlignment, "Do not align repeated runs");
  addRoughnessOptions(*command, options->roughness);
  addFigureOptions(*command, options->figures);
  command->add_flag("--json", options->json, "Print the features as JSON");
  command->callback([options, &action] { action = [options] { return analyse(*options); }; });
}

}  // namespace squat::commands

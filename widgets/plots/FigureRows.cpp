// The rows of the registry: one for each figure of a run.
#include <algorithm>

#include "case/CaseDescription.h"
#include "plots/CatalogueFigure.h"
#include "plots/FigureBuilders.h"
#include "plots/FigureRegistry.h"
#include "plots/Overlays.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

using results::RunResult;

// A builder that has nothing to be set.
template <auto builder>
std::unique_ptr<Figure> plain(const RunResult& result, const Style& style, const FigureSettings&) {
  return builder(result, style);
}

std::unique_ptr<Figure> shortTime(const RunResult& result, const Style& style, const FigureSettings& settings) {
  return stftFigure(result, style, settings.segment, settings.hop);
}

bool hasAcceleration(const RunResult& result) {
  return result.signal(signals::names::axleBoxFiltered) || result.signal(signals::names::axleBox) ||
         result.signal(signals::names::wheelFiltered);
}
bool hasSpectrum(const RunResult& result) {
  return result.frequency.size() > 1 && result.psd.size() == result.frequency.size();
}
bool hasShortTime(const RunResult& result) {
  const auto* values = result.signal(signals::names::axleBoxFiltered);
  return values && values->size() == result.time.size() && values->size() > FigureSettings{}.segment;
}
bool hasScalogram(const RunResult& result) { return !result.scalogramPower.empty(); }
bool hasPatch(const RunResult& result) { return shownPatch(result) != nullptr; }
bool hasProfile(const RunResult& result) { return !result.profilePosition.empty(); }
bool hasPlasticFlow(const RunResult& result) { return !result.permanent.empty(); }
bool hasSurface(const RunResult& result) { return !result.surface.quads.empty(); }
bool mayYield(const cases::CaseDescription& description) { return description.rail.plastic; }

Curve boxAgainstPosition(const OverlaidRun& other, const RunResult&, const FigureSettings&) {
  return againstPosition(*other.record, signals::names::axleBoxFiltered);
}
Curve boxAgainstTime(const OverlaidRun& other, const RunResult& shown, const FigureSettings&) {
  return againstTime(*other.record, shown, signals::names::axleBoxFiltered);
}
Curve spectrum(const OverlaidRun& other, const RunResult&, const FigureSettings& settings) {
  return spectrumCurve(other.spectrum.frequency, other.spectrum.density, settings.spectrum);
}
void fitSpectra(Figure& figure, const FigureSettings& settings) { fitSpectrum(figure, settings.spectrum); }

std::unique_ptr<Figure> spectrumFigure(const RunResult& result, const Style& style, const FigureSettings& settings) {
  return psdFigure(result, style, settings.spectrum,
                   settings.section ? settings.section->to - settings.section->from : 0);
}
std::unique_ptr<Figure> patch(const RunResult& result, const Style& style, const FigureSettings& settings) {
  return patchFigure(result, style, settings.moment);
}
QByteArray patchNumbers(const RunResult& result, const FigureSettings& settings) {
  return patchTable(result, settings.moment);
}

constexpr const char* kNeedsAcceleration = "Needs the signal aba_filtered, aba or wheel_acceleration_filtered.";
constexpr const char* kNeedsPlasticFlow = "Needs a rail that may yield (rail.plastic = true).";

std::vector<FigureRow> accelerationRows() {
  return {{.name = "aba_position",
           .tab = "ABA",
           .title = "Axle box acceleration against position",
           .needs = kNeedsAcceleration,
           .applies = hasAcceleration,
           .build = plain<abaPositionFigure>,
           .overlay = boxAgainstPosition,
           .marks = FigureMarks::extremes},
          {.name = "aba_time",
           .tab = "ABA(t)",
           .title = "Axle box acceleration against time",
           .needs = kNeedsAcceleration,
           .applies = hasAcceleration,
           .build = plain<abaTimeFigure>,
           .overlay = boxAgainstTime,
           .axis = FigureAxis::time,
           .marks = FigureMarks::extremes},
          {.name = "psd",
           .tab = "PSD",
           .title = "Power spectral density of the axle box acceleration",
           .needs = "Needs a spectrum of the axle box acceleration.",
           .shows = "How the strength of the vibration is spread over the frequencies; peaks are its lines.",
           .applies = hasSpectrum,
           .build = spectrumFigure,
           .overlay = spectrum,
           .fit = fitSpectra,
           .axis = FigureAxis::frequency,
           .control = FigureControl::spectrumSection},
          {.name = "stft",
           .tab = "STFT",
           .title = "Short-time Fourier transform of the axle box acceleration",
           .needs = "Needs more than 128 samples of the signal aba_filtered.",
           .shows = "Which frequencies are strong at which place: all with the same window.",
           .applies = hasShortTime,
           .build = shortTime,
           .marks = FigureMarks::lines,
           .control = FigureControl::shortTime},
          {.name = "scalogram",
           .tab = "CWT",
           .title = "Scalogram (continuous wavelet transform) of the axle box acceleration",
           .needs = "Needs a scalogram of the axle box acceleration.",
           .shows =
               "Which frequencies are strong at which place: high ones with short windows, low ones with long windows.",
           .applies = hasScalogram,
           .build = plain<scalogramFigure>,
           .marks = FigureMarks::lines,
           .drawsScalogram = true}};
}

// A figure of the catalogue with more in it.
FigureRow decorated(const std::string& figure, std::unique_ptr<Figure> (*build)(const RunResult&, const Style&)) {
  FigureRow row = catalogueRow(figure);
  row.build = [build](const RunResult& result, const Style& style, const FigureSettings&) {
    return build(result, style);
  };
  return row;
}

std::vector<FigureRow> contactRows() {
  return {decorated("contact_force", contactForceFigure),
          {.name = "contact_patch",
           .tab = "Patch",
           .title = "Contact pressure and slip in the contact patch",
           .needs = "Needs the pressures of a contact patch.",
           .applies = hasPatch,
           .build = patch,
           .axis = FigureAxis::patch,
           .control = FigureControl::moment,
           .table = patchNumbers}};
}

std::vector<FigureRow> tracksideRows() {
  FigureRow row = decorated("trackside", tracksideFigure);
  row.needs = "Needs the signals rail_acceleration or sleeper_acceleration (output.rail_accelerometer).";
  row.marks = FigureMarks::none;
  return {row};
}

// Signals whose figure has nothing but their curves.
std::vector<FigureRow> furtherSignals(const std::vector<FigureRow>& before) {
  std::vector<FigureRow> rows;
  for (const auto& figure : catalogueFigures())
    if (std::none_of(before.begin(), before.end(), [&](const auto& row) { return row.name == figure; }))
      rows.push_back(catalogueRow(figure));
  return rows;
}

std::vector<FigureRow> railRows() {
  return {{.name = "defect_profile",
           .tab = "Defect",
           .title = "Profile of the defect and path of a rigid wheel",
           .needs = "Needs the profile of the rail.",
           .applies = hasProfile,
           .build = plain<defectProfileFigure>,
           .axis = FigureAxis::railPosition},
          {.name = "permanent_change",
           .tab = "Dent",
           .title = "Permanent change of the running surface",
           .needs = kNeedsPlasticFlow,
           .applies = hasPlasticFlow,
           .expected = mayYield,
           .build = plain<permanentChangeFigure>,
           .axis = FigureAxis::railPosition},
          {.name = "residual_stress",
           .tab = "Stress",
           .title = "Residual stress against depth",
           .needs = kNeedsPlasticFlow,
           .applies = hasPlasticFlow,
           .expected = mayYield,
           .build = plain<residualStressFigure>,
           .axis = FigureAxis::stress}};
}

std::vector<FigureRow> modelRows() {
  return {{.name = "model",
           .tab = "3-D",
           .title = "Model near the contact (3-D, PNG only)",
           .needs = "Needs the surface of the model.",
           .kind = FigureKind::model,
           .applies = hasSurface}};
}

}  // namespace

const std::vector<FigureRow>& figureRegistry() {
  static const std::vector<FigureRow> all = [] {
    std::vector<FigureRow> rows;
    const auto add = [&](const std::vector<FigureRow>& part) { rows.insert(rows.end(), part.begin(), part.end()); };
    for (const auto& part : {accelerationRows(), contactRows(), tracksideRows(), railRows()}) add(part);
    add(furtherSignals(rows));
    add(modelRows());
    return rows;
  }();
  return all;
}

}  // namespace squat::plots

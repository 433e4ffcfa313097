// The rows of the registry: one for each figure of a run.
#include "case/CaseDescription.h"
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
bool hasForce(const RunResult& result) { return result.signal(signals::names::contactForce) != nullptr; }
bool hasPatch(const RunResult& result) { return shownPatch(result) != nullptr; }
bool hasTrackside(const RunResult& result) {
  return result.signal(signals::names::rail) || result.signal(signals::names::sleeper);
}
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
Curve forceAgainstPosition(const OverlaidRun& other, const RunResult&, const FigureSettings&) {
  return againstPosition(*other.record, signals::names::contactForce, 1e-3);
}
Curve railAgainstPosition(const OverlaidRun& other, const RunResult&, const FigureSettings&) {
  return againstPosition(*other.record, signals::names::rail);
}
Curve spectrum(const OverlaidRun& other, const RunResult&, const FigureSettings& settings) {
  return spectrumCurve(other.spectrum.frequency, other.spectrum.density, settings.spectrum);
}
void fitSpectra(Figure& figure, const FigureSettings& settings) { fitSpectrum(figure, settings.spectrum); }
void fitForce(Figure& figure, const FigureSettings&) { fitWithZero(figure); }

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
           .applies = hasShortTime,
           .build = shortTime,
           .marks = FigureMarks::lines,
           .control = FigureControl::shortTime},
          {.name = "scalogram",
           .tab = "CWT",
           .title = "Scalogram (continuous wavelet transform) of the axle box acceleration",
           .needs = "Needs a scalogram of the axle box acceleration.",
           .applies = hasScalogram,
           .build = plain<scalogramFigure>,
           .marks = FigureMarks::lines,
           .drawsScalogram = true}};
}

std::vector<FigureRow> contactRows() {
  return {{.name = "contact_force",
           .tab = "Force",
           .title = "Contact force",
           .needs = "Needs the signal contact_force.",
           .applies = hasForce,
           .build = plain<contactForceFigure>,
           .overlay = forceAgainstPosition,
           .fit = fitForce,
           .marks = FigureMarks::extremes},
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

std::vector<FigureRow> railRows() {
  return {{.name = "trackside",
           .tab = "Track",
           .title = "Acceleration of rail and sleeper beside the track",
           .needs = "Needs the signals rail_acceleration or sleeper_acceleration (output.rail_accelerometer).",
           .applies = hasTrackside,
           .build = plain<tracksideFigure>,
           .overlay = railAgainstPosition},
          {.name = "defect_profile",
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
           .axis = FigureAxis::stress},
          {.name = "model",
           .tab = "3-D",
           .title = "Model near the contact (3-D, PNG only)",
           .needs = "Needs the surface of the model.",
           .kind = FigureKind::model,
           .applies = hasSurface}};
}

}  // namespace

const std::vector<FigureRow>& figureRegistry() {
  static const std::vector<FigureRow> rows = [] {
    std::vector<FigureRow> all;
    for (auto& part : {accelerationRows(), contactRows(), railRows()}) all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return rows;
}

}  // namespace squat::plots

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/Maps.h"
#include "contact/ContactSurfaces.h"
#include "contact/Hertz.h"
#include "model/ContactPenalty.h"
#include "model/WheelsetModes.h"
#include "scenario/DefectSurface.h"
#include "signals/Features.h"
#include "signals/SignalCatalogue.h"
#include "simulation/Describe.h"

namespace squat::simulation {

namespace {

double weightOf(const scenario::Scenario& d) {
  return d.motion.gravity * (d.suspension.sprungMass + d.wheelset.totalMass);
}

}  // namespace

void describeEquilibrium(const model::Model& model, const statics::Equilibrium& e, results::RunResult& result) {
  const auto& d = model.scenario;
  const double weight = weightOf(d);
  const auto& s = model.surfaces;
  // Two bodies of 2 (1 - nu2) E* each give way as rail and wheel together, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
  const auto compliance = [](const auto& m) { return (1 - m.poisson * m.poisson) / m.young; };
  const double nu = d.rail.material.poisson;
  const double young = 2 * (1 - nu * nu) / (compliance(d.rail.material) + compliance(d.wheelset.material));
  const auto hertz = contact::hertzContact(s.radius, s.crownRadius, young, nu, weight / s.treadCosine);
  const double peak = e.peakPressure;
  result.equilibrium = {
      {"contact_force", "N", "vertical", e.contactForce},
      {"lateral_force", "N", "of the wheel on the rail, outwards positive", e.lateralForce},
      {"touch_lateral", "m", "where wheel and rail touch before they deform, y on the crown", s.touchY},
      {"patch_centre_lateral", "m", "y of the pressure's centre", e.centreLateral},
      {"weight", "N", "of wheelset and sprung mass", weight},
      {"residual", "1", "2-norm of the unbalanced forces over the weight", e.residual},
      {"half_axis_rolling", "m", "sqrt(5 <x2>) of the pressure", e.halfAxisRolling},
      {"half_axis_lateral", "m", "sqrt(5 <y2>) of the pressure", e.halfAxisLateral},
      {"peak_pressure", "Pa", "3 N / (2 pi a b)", peak},
      {"approach", "m", "of wheel centre and rail section", e.approach},
      {"hertz_half_axis_rolling", "m", "Hertz, crown and straight tread", hertz.halfAxisX},
      {"hertz_half_axis_lateral", "m", "Hertz", hertz.halfAxisY},
      {"hertz_peak_pressure", "Pa", "Hertz", hertz.peakPressure},
      {"hertz_approach", "m", "Hertz", hertz.approach},
      {"penalty_approach", "m", "p0 / 2k that the penalty adds to the approach",
       hertz.peakPressure / (2 * model::normalPenalty(d))},
      {"strain_energy", "J", "solids, springs and contact", e.strainEnergy},
      {"newton_steps", "1", "", static_cast<double>(e.newtonSteps)},
      {"iterations", "1", "of conjugate gradients", static_cast<double>(e.iterations)},
  };
}

void describeRightEquilibrium(const model::Model& right, const statics::Equilibrium& e, results::RunResult& result) {
  result.equilibrium.insert(
      result.equilibrium.end(),
      {{"contact_force_right", "N", "vertical", e.contactForce},
       {"lateral_force_right", "N", "of the right wheel on its rail, outwards positive", e.lateralForce},
       {"weight_right", "N", "of the right half of the wheelset and its sprung mass", weightOf(right.scenario)},
       {"patch_centre_lateral_right", "m", "y of the pressure's centre, outwards positive", e.centreLateral},
       {"peak_pressure_right", "Pa", "3 N / (2 pi a b)", e.peakPressure},
       {"approach_right", "m", "of wheel centre and rail section", e.approach}});
}

void describeMesh(const model::Model& model, const dynamics::StableStep& stable, double step,
                  results::RunResult& result) {
  const auto quality = model::meshQuality(model);
  const bool isWhole = model.scenario.extent == scenario::ModelExtent::whole;
  const double halves = isWhole ? 2 : 1;
  result.meshFigures = {
      {"elements", "1", isWhole ? "of both sides" : "", halves * static_cast<double>(model.elements())},
      {"nodes", "1", isWhole ? "of both sides, those of the centre plane twice" : "",
       halves * static_cast<double>(model.nodeCount())},
      {"smallest_jacobian", "1", quality.jacobianLocation, quality.smallestJacobian},
      {"largest_aspect", "1", quality.aspectLocation, quality.largestAspect},
      {"stable_step", "s", stable.location, stable.step},
      {"step", "s", "as run", step},
      {"highest_frequency", "rad/s", "of the assembled model, undamped, contact open", stable.highestFrequency},
      {"beta", "s", "stiffness-proportional damping", stable.beta},
      {"damping_at_1_khz", "1", "of critical, by that damping", std::numbers::pi * 1000 * stable.beta},
      {"wheelset_mass", "kg", "half wheelset", model.wheelset.mass},
      {"wheelset_solid_mass", "kg", "of it meshed as solid", model.wheelset.solidMass},
      {"wheelset_inertia", "kg m2", "about the axis", model.wheelset.inertia},
  };
}

std::vector<results::WheelsetMode> naturalModes(const scenario::Scenario& scenario) {
  std::vector<results::WheelsetMode> modes;
  for (const auto& mode : model::wheelsetModes(scenario, 2000, 3))
    modes.push_back({mode.frequency, mode.boxAmplitude, mode.wheelAmplitude, mode.contactAmplitude});
  return modes;
}

void describeProfile(const scenario::Scenario& d, results::RunResult& result) {
  const auto& surface = d.defectSurface;
  const double y = contact::seatOf(d).touchY;        // along the line on which the wheel runs
  const double treadY = y - d.motion.lateralOffset;  // but for terms of the rail's lean
  double first = surface.first(), last = surface.last();
  if (d.tread.isLocal()) {
    first = std::min(first, d.tread.position() - d.tread.dipBefore());
    last = std::max(last, d.tread.position() + d.tread.dipBehind());
  }
  const double from = std::max(-d.motion.runUp, std::min(-0.1, first - 0.03));
  const double to = std::min(d.motion.beyond, std::max(0.15, last + 0.03)), step = 0.5e-3;
  for (const auto& point : scenario::rigidWheelPath(surface, d.tread, d.wheelset.radius, from, to, step, y, treadY)) {
    result.profilePosition.push_back(point.position);
    result.profileHeight.push_back(surface.height(point.position, y));
    result.wheelPath.push_back(point.height);
  }
}

namespace {

// Nothing shakes the wheel: the scalogram shows what is left of the start, and its maximum means nothing. Of a whole
// model the other side is not known here.
bool isQuiet(const scenario::Scenario& d) {
  const auto& defect = d.defectSurface;
  return d.extent == scenario::ModelExtent::half && defect.first() == defect.last() && d.tread.isRound() &&
         d.irregularity.isSmooth();
}

// The maximum near the defect, where it stands in the cone of influence: the ends of the record shape it.
std::string remarkOnCone(const results::RunResult& result) {
  const std::size_t columns = result.scalogramPosition.size();
  double largest = 0, frequency = 0, position = 0, trusted = 0;
  for (std::size_t row = 0; row < result.scalogramFrequency.size(); ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double at = result.scalogramPosition[column];
      const double power = result.scalogramPower[row * columns + column];
      if (at < result.psdFrom || at > result.psdTo || !(power > largest)) continue;
      largest = power, frequency = result.scalogramFrequency[row], position = at;
      trusted = result.coneOfInfluence[column];
    }
  if (!(largest > 0) || frequency >= trusted) return {};
  char text[240];
  std::snprintf(text, sizeof text,
                "the scalogram's maximum (%.0f Hz at %.0f mm) lies where the ends of the record distort it: below the "
                "cone of influence, %.0f Hz there; lengthen motion.run_up and motion.beyond",
                frequency, 1e3 * position, trusted);
  return text;
}

}  // namespace

std::string addSpectra(const scenario::Scenario& d, results::RunResult& result) {
  const auto tooShort = [](std::size_t samples, const char* where, std::size_t minimum) {
    return "no spectra: " + std::to_string(samples) + " samples " + where + ", at least " + std::to_string(minimum) +
           " are needed; raise output.rate or lengthen motion.run_up and motion.beyond";
  };
  constexpr std::size_t minimumRecord = 64, minimumWindow = 32;
  const auto* filtered = result.signal(signals::names::axleBoxFiltered);
  if (!filtered) return "no spectra: nothing was recorded";
  if (filtered->size() < minimumRecord) return tooShort(filtered->size(), "in the record", minimumRecord);
  // Window of the paper's figures: from 0.1 m before to 0.28 m beyond the defect, as far as the record goes.
  result.psdFrom = std::max(-0.1, result.position.front()), result.psdTo = std::min(0.28, result.position.back());
  const auto within = std::count_if(result.position.begin(), result.position.end(),
                                    [&](double x) { return x >= result.psdFrom && x <= result.psdTo; });
  if (static_cast<std::size_t>(within) < minimumWindow)
    return tooShort(static_cast<std::size_t>(within), "from 0.1 m before to 0.28 m beyond the defect", minimumWindow);
  try {
    const auto spectrumOf = [&](const char* channel) {
      return signals::stretchSpectrum(signals::passageOf(result, channel), result.psdFrom, result.psdTo);
    };
    auto spectrum = spectrumOf(signals::names::axleBoxFiltered);
    result.frequency = std::move(spectrum.frequency), result.psd = std::move(spectrum.density);
    result.psdWindow = spectrum.window;
    result.psdWheel = spectrumOf(signals::names::wheelFiltered).density;
    signals::WaveletOptions wavelet;
    wavelet.voicesPerOctave = d.output.cwtVoices > 0 ? d.output.cwtVoices : 16;
    std::vector<std::string> notes;
    const auto scalogram =
        analysis::scalogramMap(signals::seriesOf(result, signals::names::axleBoxFiltered), wavelet, notes);
    result.scalogramFrequency = scalogram.frequency, result.scalogramTime = scalogram.time;
    result.scalogramPower = scalogram.power, result.coneOfInfluence = scalogram.coneOfInfluence;
    for (const double t : scalogram.time)
      result.scalogramPosition.push_back(result.position.front() + d.motion.speed * (t - result.time.front()));
  } catch (const std::exception& error) {
    return std::string("no spectra: ") + error.what();
  }
  return isQuiet(d) ? std::string() : remarkOnCone(result);
}

}  // namespace squat::simulation

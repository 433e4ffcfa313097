#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "model/InvertedElement.h"
#include "signals/Butterworth.h"
#include "signals/SignalError.h"
#include "simulation/RunParts.h"

namespace squat::simulation {

namespace {

struct ChannelName {
  const char *name, *unit, *description;
};
constexpr ChannelName channelNames[] = {
    {"aba", "m/s2", "vertical acceleration of the axle box, up positive, anti-aliased"},
    {"aba_longitudinal", "m/s2", "longitudinal acceleration of the axle box, rolling direction positive"},
    {"wheel_acceleration", "m/s2", "vertical acceleration of the wheel centre, up positive"},
    {"contact_force", "N", "vertical force of the wheel on the rail, down positive"},
    {"creep_force", "N", "longitudinal force of the wheel on the rail, rolling direction positive"},
    {"wheel_speed", "rad/s", "angular velocity of the wheelset"},
    {"patch_length", "m", "2 sqrt(5 <x2>) of the pressure"},
    {"patch_width", "m", "2 sqrt(5 <y2>) of the pressure"},
    {"position", "m", "wheel centre relative to the deepest point of the defect"},
};
constexpr std::size_t channels = std::size(channelNames);

}  // namespace

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Recorder::Recorder(double step, std::size_t stepsPerSample) : filter_(step, stepsPerSample, channels) {}

void Recorder::observe(const dynamics::StepView& view) {
  const double sample[channels] = {view.boxAcceleration.z, view.boxAcceleration.x,  view.wheelAcceleration.z,
                                   view.patch.vertical,    view.patch.longitudinal, view.spinRate,
                                   view.patch.length,      view.patch.width,        view.position};
  filter_.push(sample);
}

double Recorder::latestPosition() const { return filter_.latest(channels - 1); }

void Recorder::store(results::RunResult& result, double cutoff) const {
  const auto series = filter_.finish();
  result.time.clear(), result.signals.clear();
  if (series.empty() || series[0].values.empty()) return;
  for (std::size_t i = 0; i < series[0].values.size(); ++i) result.time.push_back(series[0].timeAt(i));
  result.position = series[channels - 1].values;
  for (std::size_t c = 0; c + 1 < channels; ++c)
    result.signals.push_back(
        {channelNames[c].name, channelNames[c].unit, channelNames[c].description, series[c].values});
  for (const auto& [from, name] :
       {std::pair<std::size_t, const char*>{0, "aba_filtered"}, {2, "wheel_acceleration_filtered"}}) {
    std::vector<double> values = series[from].values;
    if (values.size() > 30) values = signals::lowPass(series[from], cutoff).values;
    result.signals.push_back(
        {name, "m/s2", std::string(channelNames[from].name) + ", Butterworth of order 4 forward and back", values});
  }
}

void Recorder::save(results::ArrayTree& tree) const {
  const auto& state = filter_.state();
  tree.addScalar("/recorder/pushed", static_cast<double>(state.pushed), "1");
  tree.add("/recorder/last", state.last, "1");
  tree.add("/recorder/pending", state.pending, "1");
  for (std::size_t c = 0; c < state.complete.size(); ++c)
    tree.add("/recorder/complete" + std::to_string(c), state.complete[c], "1");
}

void Recorder::load(const results::ArrayTree& tree, const std::string& file) {
  signals::DecimatingFilterState state;
  const auto& pushed = results::valuesOf<double>(tree, "/recorder/pushed", file);
  if (pushed.size() != 1 || !(pushed[0] >= 0 && pushed[0] < 1e15))
    throw FileError(file, "/recorder/pushed", "is no number of samples");
  state.pushed = static_cast<std::uint64_t>(pushed[0]);
  state.last = results::valuesOf<double>(tree, "/recorder/last", file);
  state.pending = results::valuesOf<double>(tree, "/recorder/pending", file);
  for (std::size_t c = 0; c < channels; ++c)
    state.complete.push_back(results::valuesOf<double>(tree, "/recorder/complete" + std::to_string(c), file));
  try {
    filter_.restore(std::move(state));
  } catch (const signals::SignalError& error) {
    throw FileError(file, "/recorder", error.what());
  }
}

void saveRolling(const dynamics::Rolling& rolling, results::ArrayTree& tree) {
  const auto& s = rolling.state();
  const auto plain = [](const AlignedVector& v) { return std::vector<double>(v.begin(), v.end()); };
  tree.add("/rolling/displaced", plain(s.displaced), "m");
  tree.add("/rolling/velocity", plain(s.velocity), "m/s");
  tree.add("/rolling/traction", s.friction.traction, "Pa");
  if (!s.plastic.values.empty()) tree.add("/rolling/plastic", plain(s.plastic.values), "1");
  tree.add("/rolling/closed", std::vector<std::int64_t>(s.friction.closed.begin(), s.friction.closed.end()), "1");
  tree.add("/rolling/small",
           std::vector<double>{static_cast<double>(s.step), s.time, s.rotation, s.spinRate, s.sums.friction,
                               s.sums.damping, s.sums.torqueWork, s.turningMoment, s.addedMoment},
           "1");
}

// A wheel of 0.3 m turns by less on the longest track, and with less at the highest speed, even where it spins.
constexpr double mostRotation = 1e4, mostSpin = 1e5;  // [rad], [rad/s]

void requireFittingState(const results::ArrayTree& tree, const dynamics::Rolling& rolling, long lastStep,
                         const std::string& file) {
  results::ArrayTree own;
  saveRolling(rolling, own);
  std::vector<std::string> needed{"/rolling/displaced", "/rolling/velocity", "/rolling/traction", "/rolling/small"};
  if (own.find("/rolling/plastic")) needed.push_back("/rolling/plastic");
  for (const auto& path : needed)
    if (results::valuesOf<double>(tree, path, file).size() != results::valuesOf<double>(own, path, file).size())
      throw FileError(file, path, "has another length than this case and mesh need", "Start anew without --resume");
  const auto points = static_cast<std::int64_t>(results::valuesOf<double>(own, "/rolling/traction", file).size() / 2);
  std::int64_t before = -1;
  for (const auto point : results::valuesOf<std::int64_t>(tree, "/rolling/closed", file)) {
    if (point <= before || point >= points)
      throw FileError(file, "/rolling/closed", "names points of contact that are not there");
    before = point;
  }
  const auto& small = results::valuesOf<double>(tree, "/rolling/small", file);
  const double step = small[0];
  if (!(step >= 0 && step <= static_cast<double>(lastStep)))
    throw FileError(file, "/rolling/small", "names a step beyond the end of the run");
  const double change = rolling.stepSize() / rolling.model().wheelset.inertia;  // of the spin by a moment
  if (!(std::abs(small[1] - step * rolling.stepSize()) < 1e-9) || !(std::abs(small[2]) < mostRotation) ||
      !(std::abs(small[3]) < mostSpin) || !((std::abs(small[7]) + std::abs(small[8])) * change < mostSpin))
    throw FileError(file, "/rolling/small", "names a time, rotation, spin or moment that no run of this case has");
  const auto ledger = results::valuesOf<double>(tree, "/ledger", file).size();
  if (ledger < 13 || (ledger - 13) % 8 != 0) throw FileError(file, "/ledger", "has a wrong length");
}

dynamics::RollingState loadRolling(const results::ArrayTree& tree) {
  dynamics::RollingState s;
  const auto& u = results::valuesOf<double>(tree, "/rolling/displaced", "checkpoint");
  const auto& v = results::valuesOf<double>(tree, "/rolling/velocity", "checkpoint");
  s.displaced.assign(u.begin(), u.end()), s.velocity.assign(v.begin(), v.end());
  s.friction.traction = results::valuesOf<double>(tree, "/rolling/traction", "checkpoint");
  if (tree.find("/rolling/plastic")) {
    const auto& flow = results::valuesOf<double>(tree, "/rolling/plastic", "checkpoint");
    s.plastic.values.assign(flow.begin(), flow.end());
  }
  const auto* closed = tree.find("/rolling/closed");
  if (const auto* list = closed ? std::get_if<std::vector<std::int64_t>>(&closed->values) : nullptr)
    s.friction.closed.assign(list->begin(), list->end());
  const auto& small = results::valuesOf<double>(tree, "/rolling/small", "checkpoint");
  s.step = static_cast<long>(small.at(0)), s.time = small.at(1), s.rotation = small.at(2), s.spinRate = small.at(3);
  s.sums = {small.at(4), small.at(5), small.at(6)};
  s.turningMoment = small.at(7), s.addedMoment = small.at(8);
  return s;
}

void DivergenceGuard::checkEverything(const dynamics::Rolling& rolling) {
  constexpr double absurd = 1e4;  // [m], [m/s] beyond the speed of sound in steel; a not-a-number is not below it
  const auto& state = rolling.state();
  for (const auto* values : {&state.displaced, &state.velocity})
    for (std::size_t i = 0; i < values->size(); ++i)
      if (!(std::abs((*values)[i]) < absurd))
        throw RunError("the run diverges: a displacement or velocity is not a number or grows without bound",
                       state.step, state.time, model::placeName(rolling.model(), i));
  if (!(std::abs(state.rotation) < mostRotation) || !(std::abs(state.spinRate) < mostSpin))
    throw RunError("the run diverges: the spin of the wheel grows without bound", state.step, state.time, "wheelset");
  if (const auto place = model::invertedElement(rolling.model(), rolling.displacement()); !place.empty())
    throw RunError("an element is turned inside out", state.step, state.time, place);
}

void DivergenceGuard::check(const dynamics::Rolling& rolling, const EnergyLedger& ledger) {
  const auto& view = rolling.view();
  const auto& state = rolling.state();
  const auto fail = [&](const std::string& what, const std::string& place) {
    throw RunError(what, state.step, state.time, place);
  };
  const auto diverges = [&] {
    std::size_t worst = 0;
    for (std::size_t i = 0; i < state.velocity.size(); ++i)
      if (!(std::abs(state.velocity[i]) <= std::abs(state.velocity[worst]))) worst = i;
    fail("the run diverges: a velocity is not a number or grows without bound",
         model::placeName(rolling.model(), worst));
  };
  if (!std::isfinite(view.patch.vertical) || !std::isfinite(view.boxAcceleration.z) ||
      !(std::abs(state.spinRate) < mostSpin))
    diverges();
  if (view.patch.deepest > 2e-3)
    fail("runaway penetration of " + std::to_string(view.patch.deepest * 1e3) + " mm", "contact");
  if (std::abs(view.patch.vertical) > 1e3 * rolling.wheelLoad()) diverges();
  if (view.patch.points > 0) lastContact_ = state.time;
  if (state.time - lastContact_ > 0.010) fail("the wheel has lost contact for 10 ms", "contact");
  if (std::abs(ledger.relativeResidual()) > 0.005)
    fail("the energy ledger does not close: residual " + std::to_string(100 * ledger.relativeResidual()) +
             " % of the strain energy at the start plus all dissipation",
         "energy");
}

results::PatchSnapshot patchSnapshot(const std::string& name, const dynamics::Rolling& rolling) {
  results::PatchSnapshot shot;
  shot.name = name, shot.time = rolling.state().time;
  shot.position = rolling.view().position;
  for (const auto& p : rolling.patchPoints()) {
    shot.x.push_back(static_cast<float>(p.x)), shot.y.push_back(static_cast<float>(p.y));
    shot.pressure.push_back(static_cast<float>(p.pressure));
    shot.tractionX.push_back(static_cast<float>(p.tractionX)),
        shot.tractionY.push_back(static_cast<float>(p.tractionY));
    shot.slipping.push_back(p.slips), shot.area.push_back(static_cast<float>(p.area));
  }
  return shot;
}

}  // namespace squat::simulation

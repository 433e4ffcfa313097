#include "roughness/TransferFunction.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "contact/ContactSurfaces.h"
#include "contact/Hertz.h"
#include "receptance/Receptance.h"
#include "scenario/Scenario.h"
#include "scenario/WheelsetMass.h"

namespace squat::roughness {

namespace {

using Complex = std::complex<double>;
using Values = std::vector<Complex>;

constexpr double frequencyStep = 2;       // [Hz]
constexpr double receptanceLimit = 2000;  // [Hz] that the track's mesh is made for

// The wheel held sideways by creep on a rail of this lateral receptance. The contact gives way sideways as well, by
// (2 - nu) / (2 (1 - nu)) of what it does vertically (Mindlin, round patch).
std::vector<WheelsetReceptance> heldByCreep(const TransferFunction& transfer, std::vector<WheelsetReceptance> wheel,
                                            const Values& railLateral, const scenario::Scenario& scenario) {
  const double poisson = scenario.rail.material.poisson;
  const double shear = (2 - poisson) / (2 * (1 - poisson)) / transfer.contactStiffness;
  for (std::size_t i = 0; i < wheel.size(); ++i) {
    const double omega = 2 * std::numbers::pi * transfer.frequency[i];
    const Complex creep = scenario.motion.speed / (Complex(0, omega) * transfer.lateralCreep);
    const Complex resists = wheel[i].contactLateral / (wheel[i].lateral + railLateral[i] + shear + creep);
    wheel[i].contact -= wheel[i].contactLateral * resists;
    wheel[i].box -= wheel[i].boxLateral * resists;
  }
  return wheel;
}

Values meanOf(const Values& one, const Values& other) {
  Values mean;
  for (std::size_t i = 0; i < one.size(); ++i) mean.push_back(0.5 * (one[i] + other[i]));
  return mean;
}

// Of the box per height with one receptance of the track.
Values responseWith(const TransferFunction& transfer, const std::vector<WheelsetReceptance>& wheel,
                    const Values& track) {
  Values response;
  for (std::size_t i = 0; i < transfer.frequency.size(); ++i) {
    const double omega = 2 * std::numbers::pi * transfer.frequency[i];
    response.push_back(-omega * omega * wheel[i].box / (wheel[i].contact + track[i] + 1 / transfer.contactStiffness));
  }
  return response;
}

TransferVariant variantOf(const char* name, const Values& response) {
  TransferVariant variant{name, {}};
  for (const auto& value : response) variant.power.push_back(std::norm(value));
  return variant;
}

TransferVariant meanOf(const char* name, const Values& one, const Values& other) {
  TransferVariant variant{name, {}};
  for (std::size_t i = 0; i < one.size(); ++i) variant.power.push_back(0.5 * (std::norm(one[i]) + std::norm(other[i])));
  return variant;
}

scenario::Scenario withPads(scenario::Scenario scenario, double factor) {
  scenario.pad.stiffness *= factor;
  for (auto& row : scenario.pad.dynamic) row.vertical *= factor;
  for (auto& point : scenario.pad.curve) point.force *= factor;
  scenario.pad.preload *= factor;
  for (auto& seat : scenario.track.seats)
    if (seat.padStiffness) *seat.padStiffness *= factor;
  return scenario;
}

void addContact(const scenario::Scenario& scenario, TransferFunction& transfer) {
  const auto seat = contact::seatOf(scenario);
  transfer.wheelsetMass = scenario::wheelsetMass(scenario.wheelset);
  transfer.load = (transfer.wheelsetMass + scenario.suspension.sprungMass) * scenario.motion.gravity;
  const auto& steel = scenario.rail.material;
  const auto hertz = contact::hertzContact(seat.radius, seat.crownRadius, steel.young, steel.poisson, transfer.load);
  transfer.contactStiffness = 1.5 * transfer.load / hertz.approach;
  transfer.halfPatch = hertz.halfAxisX;
  // J. J. Kalker (1967) for a round patch and Poisson's ratio 0.25 to 0.3; from memory. It matters little: G a b C22 is
  // some 10 MN, which at 60 Hz and 20 m/s holds with 200 MN/m, several times what the rail does sideways.
  constexpr double kalker22 = 3.7;
  transfer.lateralCreep = steel.young / (2 * (1 + steel.poisson)) * hertz.halfAxisX * hertz.halfAxisY * kalker22;
}

}  // namespace

TransferFunction transferFunction(const scenario::Scenario& scenario, const TransferOptions& options,
                                  Monitor& monitor) {
  TransferFunction transfer;
  addContact(scenario, transfer);
  receptance::ReceptanceOptions asked;
  asked.lowest = options.lowest, asked.highest = options.highest, asked.frequencyStep = frequencyStep;
  asked.threads = options.threads, asked.wheelset = false;
  auto withLateral = asked;
  const double midspan = -scenario.track.sleeperSpacing / 2;
  using enum receptance::RailDirection;
  withLateral.places = {{"over a sleeper", 0, 0, vertical},
                        {"midspan", midspan, midspan, vertical},
                        {"over a sleeper, lateral", 0, 0, lateral},
                        {"midspan, lateral", midspan, midspan, lateral}};
  const auto track = receptance::trackReceptance(scenario, withLateral, monitor);
  if (!track.complete) return transfer;
  transfer.frequency = track.frequency;
  transfer.notes = track.notes;
  const auto wheel = heldByCreep(transfer, wheelsetReceptances(scenario, transfer.frequency),
                                 meanOf(track.points[2].receptance, track.points[3].receptance), scenario);
  const auto both = [&](const receptance::TrackReceptance& of) {
    return std::pair(responseWith(transfer, wheel, of.points[0].receptance),
                     responseWith(transfer, wheel, of.points[1].receptance));
  };
  const auto [sleeper, between] = both(track);
  transfer.response = responseWith(transfer, wheel, meanOf(track.points[0].receptance, track.points[1].receptance));
  transfer.power = meanOf("", sleeper, between).power;
  transfer.overSleeper = variantOf("over a sleeper", sleeper);
  transfer.midspan = variantOf("midspan", between);
  for (const bool soft : {true, false}) {
    if (options.padSpread <= 0) break;
    const auto other =
        receptance::trackReceptance(withPads(scenario, 1 + (soft ? -1 : 1) * options.padSpread), asked, monitor);
    if (!other.complete) return transfer;
    const auto [over, amid] = both(other);
    (soft ? transfer.softPads : transfer.stiffPads) = meanOf(soft ? "softer pads" : "stiffer pads", over, amid);
  }
  if (options.highest > receptanceLimit)
    transfer.notes.emplace_back("above 2 kHz the mesh of the track's receptance is coarse");
  transfer.complete = true;
  return transfer;
}

}  // namespace squat::roughness

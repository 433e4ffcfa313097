#include "verification/TrackBeam.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "verification/SectionTorsion.h"

namespace squat::verification {

namespace {

constexpr int padsAlong = 6, padsAcross = 4;  // springs of a pad
constexpr int sleeperParts = 24;
constexpr double railStep = 0.025;  // [m]

double padLocation(int index, int count, double length) { return ((index + 0.5) / count - 0.5) * length; }

double shearModulus(const scenario::Material& m) { return m.young / 2 / (1 + m.poisson); }

// St Venant's constant of a rectangle (Timoshenko and Goodier, Theory of Elasticity, art. 109).
double rectangleTorsion(double a, double b) {
  const double longer = std::max(a, b), shorter = std::min(a, b), pi = std::acos(-1.0);
  double sum = 0;
  for (int n = 1; n < 20; n += 2) sum += std::tanh(n * pi * longer / (2 * shorter)) / std::pow(n, 5);
  return longer * std::pow(shorter, 3) / 3 * (1 - 192 / std::pow(pi, 5) * shorter / longer * sum);
}

void append(Terms& terms, const Terms& others) { terms.insert(terms.end(), others.begin(), others.end()); }

}  // namespace

double sleeperHeight(const scenario::Scenario& d, double fromCentre) {
  const auto& s = d.sleeper;
  if (s.middleHeight == 0) return s.height;
  const double from = s.middleHalfLength, to = d.wheelset.trackCentre - d.pad.width / 2;
  return s.middleHeight + (s.height - s.middleHeight) * std::clamp((fromCentre - from) / (to - from), 0.0, 1.0);
}

BeamSection beamSection(const geometry::SectionMesh& section) {
  const auto integrals = geometry::sectionIntegrals(section);
  const auto torsion = sectionTorsion(section);
  double base = 0;
  for (const auto& p : section.nodes) base = std::min(base, p[1]);
  BeamSection beam{integrals.area, integrals.momentCC, integrals.centroidC - base};
  beam.lateralInertia = integrals.momentBB;
  beam.torsion = torsion.torsion, beam.warping = torsion.warping;
  beam.shearCentreAboveBase = torsion.shearCentre - base;
  return beam;
}

TrackBeam::TrackBeam(const scenario::Scenario& description, const BeamSection& section, double railStart,
                     const std::vector<double>& sleeperPositions, Rails rails)
    : case_(description), section_(section), railStart_(railStart) {
  layRail(sleeperPositions);
  for (const double x : sleeperPositions) {
    const int sleeper = addSleeper(rails);
    addBallast(sleeper, seatAt(x));
    addPad(sleeper, x, seatAt(x));
  }
}

void TrackBeam::layRail(const std::vector<double>& sleeperPositions) {
  const double length = case_.track.length, end = railStart_ + length;
  const int parts = static_cast<int>(std::ceil(length / railStep));
  for (int i = 0; i <= parts; ++i) railX_.push_back(railStart_ + length * i / parts);
  for (const double x : sleeperPositions)
    for (int p = 0; p < padsAlong; ++p)
      railX_.push_back(std::clamp(x + padLocation(p, padsAlong, case_.pad.length), railStart_, end));
  std::sort(railX_.begin(), railX_.end());
  railX_.erase(std::unique(railX_.begin(), railX_.end(), [](double a, double b) { return b - a < 1e-6; }),
               railX_.end());
  const auto& steel = case_.rail.material;
  const auto& s = section_;
  const double shear = shearModulus(steel) * s.area, mass = steel.density * s.area;
  const double fromShearCentre = s.centroidAboveBase - s.shearCentreAboveBase;
  system_.add(railUnknowns * static_cast<int>(railX_.size()));
  for (int i = 0; i + 1 < static_cast<int>(railX_.size()); ++i) {
    const int l = railUnknowns * i, r = l + railUnknowns;
    const double step = railX_[i + 1] - railX_[i];
    system_.addBar(l + along, r + along, step, steel.young * s.area, mass);
    system_.addBeam(l + up, l + upSlope, r + up, r + upSlope, step, steel.young * s.inertia, s.shearCoefficient * shear,
                    mass, steel.density * s.inertia);
    system_.addBeam(l + across, l + acrossSlope, r + across, r + acrossSlope, step, steel.young * s.lateralInertia,
                    s.lateralShearCoefficient * shear, 0, steel.density * s.lateralInertia);
    system_.addTwist(l + turn, l + turnRate, r + turn, r + turnRate, step, shearModulus(steel) * s.torsion,
                     steel.young * s.warping, steel.density * (s.inertia + s.lateralInertia));
    for (const int at : {l, r}) {
      system_.addMass({{at + across, 1}, {at + turn, -fromShearCentre}}, 0.5 * step * mass);
      system_.addMass({{at + turnRate, 1}}, 0.5 * step * steel.density * s.warping);
      weights_.emplace_back(at + up, 0.5 * step * mass);
    }
  }
}

int TrackBeam::addSleeper(Rails rails) {
  const auto& s = case_.sleeper;
  const double step = s.halfLength / sleeperParts;
  const double young = s.material.young, shear = shearModulus(s.material), density = s.material.density;
  const int first = system_.add(sleeperUnknowns * (sleeperParts + 1));
  for (int j = 0; j < sleeperParts; ++j) {
    const int l = first + sleeperUnknowns * j, r = l + sleeperUnknowns;
    const double height = sleeperHeight(case_, (j + 0.5) * step), area = s.width * height;
    const double upright = s.width * std::pow(height, 3) / 12, flat = height * std::pow(s.width, 3) / 12;
    const double torsion = rectangleTorsion(s.width, height);
    // The middle of a lower section lies below the axis.
    const double below = (s.height - height) / 2;
    system_.addSpring({{l + stretch, 1}, {l + liftSlope, below}, {r + stretch, -1}, {r + liftSlope, -below}},
                      young * area / step, 0);
    for (const int at : {l, r})
      system_.addMass({{at + stretch, 1}, {at + liftSlope, below}}, 0.5 * step * density * area);
    system_.addBeam(l + lift, l + liftSlope, r + lift, r + liftSlope, step, young * upright, 5.0 / 6 * area * shear,
                    density * area, density * upright);
    system_.addBeam(l + shift, l + shiftSlope, r + shift, r + shiftSlope, step, young * flat, 5.0 / 6 * area * shear,
                    density * area, density * flat);
    system_.addBar(l + twist, r + twist, step, shear * torsion, density * (upright + flat));
    for (const int at : {l, r}) weights_.emplace_back(at + lift, 0.5 * step * density * area);
  }
  const auto fixed =
      rails == Rails::alike ? std::array{stretch, liftSlope, shiftSlope} : std::array{lift, shift, twist};
  for (const int unknown : fixed) system_.hold(first + unknown);
  if (s.fixed)
    for (int unknown = 0; unknown < sleeperUnknowns * (sleeperParts + 1); ++unknown) system_.hold(first + unknown);
  return first;
}

// Seats count from the sleeper nearest to the defect, which is as far behind it as the case says.
scenario::Seat TrackBeam::seatAt(double x) const {
  const auto index = std::lround((x + case_.track.defectFromSleeper) / case_.track.sleeperSpacing);
  for (const auto& seat : case_.track.seats)
    if (seat.sleeper == index) return seat;
  return {};
}

// Point of a sleeper at x from its axis and z above it: lift + twist x, shift - twist z, stretch - slope z - slope x.
void TrackBeam::addBallast(int sleeper, const scenario::Seat& seat) {
  const auto& ballast = case_.ballast;
  const double base = -case_.sleeper.height / 2;
  for (int j = 0; j <= sleeperParts; ++j) {
    const int at = sleeper + sleeperUnknowns * j;
    const double share = (j == 0 || j == sleeperParts ? 0.5 : 1.0) / sleeperParts;
    for (const double side : {-0.5, 0.5}) {  // two lines: second moment of the even pressure
      const double offset = side * case_.sleeper.width / std::sqrt(3.0);
      const Terms vertical{{at + lift, 1}, {at + twist, offset}};
      const double stiffness = 0.5 * share * seat.ballastStiffness.value_or(ballast.stiffness);
      if (seat.gap)
        system_.addGapSpring(vertical, stiffness, *seat.gap);
      else
        system_.addSpring(vertical, stiffness, 0.5 * share * seat.ballastDamping.value_or(ballast.damping));
    }
    system_.addSpring({{at + shift, 1}, {at + twist, -base}}, share * ballast.longitudinalStiffness,
                      share * ballast.longitudinalDamping);
    system_.addSpring({{at + stretch, 1}, {at + liftSlope, -base}}, share * ballast.lateralStiffness,
                      share * ballast.lateralDamping);
  }
}

// Point of the rail's base at y from its axis: up + turn y, along + slope centroid - slope y, across + turn shear
// centre.
void TrackBeam::addPad(int sleeper, double at, const scenario::Seat& seat) {
  const auto& pad = case_.pad;
  const double top = case_.sleeper.height / 2, share = 1.0 / (padsAlong * padsAcross);
  for (int p = 0; p < padsAlong; ++p) {
    const double x = padLocation(p, padsAlong, pad.length);
    const int rail = railUnknowns * railNode(at + x);
    int foot = rail + up;
    if (section_.footFlexibility > 0) {
      foot = system_.add(1);
      system_.addSpring({{rail + up, 1}, {foot, -1}}, pad.length / padsAlong / section_.footFlexibility, 0);
    }
    for (int q = 0; q < padsAcross; ++q) {
      const double y = padLocation(q, padsAcross, pad.width), location = y + case_.wheelset.trackCentre;
      Terms vertical{{foot, 1}, {rail + turn, y}};
      append(vertical, sleeperAt(sleeper, lift, location, -1)),
          append(vertical, sleeperAt(sleeper, twist, location, -x));
      system_.addSpring(vertical, share * seat.padStiffness.value_or(pad.stiffness),
                        share * seat.padDamping.value_or(pad.damping));
      Terms lengthwise{{rail + along, 1}, {rail + upSlope, section_.centroidAboveBase}, {rail + acrossSlope, -y}};
      append(lengthwise, sleeperAt(sleeper, shift, location, -1)),
          append(lengthwise, sleeperAt(sleeper, twist, location, top));
      system_.addSpring(lengthwise, share * pad.longitudinalStiffness, share * pad.longitudinalDamping);
      Terms lateral{{rail + across, 1}, {rail + turn, section_.shearCentreAboveBase}};
      append(lateral, sleeperAt(sleeper, stretch, location, -1)),
          append(lateral, sleeperAt(sleeper, liftSlope, location, top));
      append(lateral, sleeperAt(sleeper, shiftSlope, location, x));
      system_.addSpring(lateral, share * pad.lateralStiffness, share * pad.lateralDamping);
    }
  }
}

Terms TrackBeam::sleeperAt(int sleeper, int unknown, double y, double factor) const {
  const double location = y / case_.sleeper.halfLength * sleeperParts;
  const int j = std::clamp(static_cast<int>(location), 0, sleeperParts - 1);
  const int left = sleeper + sleeperUnknowns * j + unknown;
  return {{left, factor * (1 - location + j)}, {left + sleeperUnknowns, factor * (location - j)}};
}

int TrackBeam::railNode(double x) const {
  const auto next = std::lower_bound(railX_.begin(), railX_.end(), x - 2e-6);
  return std::min(static_cast<int>(next - railX_.begin()), static_cast<int>(railX_.size()) - 1);
}

// Hermite interpolation of the deflection.
Eigen::VectorXd TrackBeam::railShape(double x) const {
  Eigen::VectorXd shape = Eigen::VectorXd::Zero(system_.unknowns());
  int i = static_cast<int>(std::upper_bound(railX_.begin(), railX_.end(), x) - railX_.begin()) - 1;
  i = std::clamp(i, 0, static_cast<int>(railX_.size()) - 2);
  const double l = railX_[i + 1] - railX_[i], t = (x - railX_[i]) / l;
  const int left = railUnknowns * i, right = left + railUnknowns;
  shape[left + up] = 1 - 3 * t * t + 2 * t * t * t, shape[right + up] = 3 * t * t - 2 * t * t * t;
  shape[left + upSlope] = l * (t - 2 * t * t + t * t * t), shape[right + upSlope] = l * (t * t * t - t * t);
  return shape;
}

Eigen::VectorXd TrackBeam::atRest(double loadX, double force, bool withWeight) const {
  Eigen::VectorXd load = -force * railShape(loadX);
  if (withWeight)
    for (const auto& [unknown, mass] : weights_) load[unknown] -= mass * case_.motion.gravity;
  return system_.atRest(load);
}

double TrackBeam::deflection(double x, double loadX, double force, bool withWeight) const {
  return railShape(x).dot(atRest(loadX, force, withWeight));
}

double TrackBeam::voidedLoad(double loadX, double force) const { return system_.gapLoad(atRest(loadX, force, true)); }

Eigen::MatrixXd TrackBeam::railShapes(const std::vector<double>& at) const {
  Eigen::MatrixXd shapes(system_.unknowns(), static_cast<Eigen::Index>(at.size()));
  for (std::size_t i = 0; i < at.size(); ++i) shapes.col(static_cast<Eigen::Index>(i)) = railShape(at[i]);
  return shapes;
}

std::vector<std::complex<double>> TrackBeam::receptance(const std::vector<double>& at, double frequency) const {
  return system_.answers(railShapes(at), 2 * std::acos(-1.0) * frequency);
}

Eigen::MatrixXcd TrackBeam::transfers(const std::vector<double>& at, std::complex<double> omega) const {
  return system_.transfers(railShapes(at), omega);
}

}  // namespace squat::verification

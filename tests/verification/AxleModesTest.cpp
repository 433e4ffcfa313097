// Natural modes of a free wheelset with two stiff wheels against a Timoshenko shaft with two rigid discs: bending and
// torsion, both sides alike and oppositely.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "case/Resolve.h"
#include "model/WheelsetModes.h"

namespace squat {
namespace {

using model::Centre;
using std::numbers::pi;

// A uniform shaft of 80 mm radius with a bore, wheels that are 150 mm thick almost down to the hub, next to no axle
// box. Steps of radii below 12 mm are not meshed (geometry/WheelSection.h); the case must have them.
scenario::Scenario stiffWheels() {
  return cases::loadScenario("smooth-rail", {"tiny",
                                             {{"wheelset.preset", "none"},
                                              {"wheelset.hub_width", "100"},
                                              {"wheelset.web_thickness", "96"},
                                              {"wheelset.rim_width", "150"},
                                              {"wheelset.rim_inner_radius", "150"},
                                              {"wheelset.seat_radius", "81"},
                                              {"wheelset.axle_radius", "80"},
                                              {"wheelset.shoulder_radius", "80.5"},
                                              {"wheelset.shoulder_end", "60"},
                                              {"wheelset.journal_radius", "80"},
                                              {"wheelset.journal_end", "186"},
                                              {"wheelset.bearing_centre", "146"},
                                              {"wheelset.bearing_width", "40"},
                                              {"wheelset.axle_box_mass", "1"},
                                              {"wheelset.total_mass", "0"}}});
}

struct Disc {
  double mass = 0, polar = 0, transverse = 0;  // [kg], [kg m2] about the axle and about a diameter
};

// Rings of the wheel outside the shaft.
Disc discOf(const scenario::Wheelset& w) {
  const double rings[3][3] = {{w.axleRadius, w.hubRadius, w.hubWidth},
                              {w.hubRadius, w.rimInnerRadius, w.webThickness},
                              {w.rimInnerRadius, w.radius, w.rimWidth}};
  Disc disc;
  for (const auto& [inner, outer, width] : rings) {
    const double mass = w.material.density * pi * (outer * outer - inner * inner) * width;
    const double square = inner * inner + outer * outer;
    disc.mass += mass, disc.polar += mass * square / 2;
    disc.transverse += mass * (square / 4 + width * width / 12);
  }
  return disc;
}

// Half the shaft from the track centre to the end of the journal in elements of some 20 mm, a node at wheel and box.
class HalfShaft {
 public:
  explicit HalfShaft(const scenario::Wheelset& wheelset) : w_(wheelset) {
    const double marks[] = {-w_.trackCentre, 0, w_.bearingCentre, w_.journalEnd};
    nodes_.push_back(marks[0]);
    for (int i = 0; i < 3; ++i) {
      const int count = static_cast<int>(std::ceil((marks[i + 1] - marks[i]) / 0.02));
      for (int k = 1; k <= count; ++k) nodes_.push_back(marks[i] + (marks[i + 1] - marks[i]) * k / count);
      if (i == 0) wheel_ = static_cast<int>(nodes_.size()) - 1;
      if (i == 1) box_ = static_cast<int>(nodes_.size()) - 1;
    }
  }

  // [Hz] ascending, rigid motions left out. Deflection and slope at each node: Przemieniecki, Theory of Matrix
  // Structural Analysis (1968), 5.6; rotary inertia as of Archer (1963); shear coefficient of hollow circles: Cowper
  // (1966).
  std::vector<double> bending(Centre centre) const {
    const auto n = static_cast<Eigen::Index>(2 * nodes_.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n), mass = stiffness;
    const double r = w_.axleRadius, b = w_.boreRadius, nu = w_.material.poisson, m2 = b * b / (r * r);
    const double area = pi * (r * r - b * b), second = pi / 4 * (std::pow(r, 4) - std::pow(b, 4));
    const double shear =
        6 * (1 + nu) * (1 + m2) * (1 + m2) / ((7 + 6 * nu) * (1 + m2) * (1 + m2) + (20 + 12 * nu) * m2);
    const double rigidity = w_.material.young * second;
    for (std::size_t e = 0; e + 1 < nodes_.size(); ++e) {
      const double l = nodes_[e + 1] - nodes_[e];
      const double phi = 12 * rigidity / (shear * w_.material.young / (2 * (1 + nu)) * area * l * l);
      Eigen::Matrix4d k, translation, rotation;
      k << 12, 6 * l, -12, 6 * l,  //
          6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l, -12, -6 * l, 12, -6 * l, 6 * l, (2 - phi) * l * l,
          -6 * l, (4 + phi) * l * l;
      translation << 156, 22 * l, 54, -13 * l,  //
          22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l, -13 * l, -3 * l * l, -22 * l, 4 * l * l;
      rotation << 36, 3 * l, -36, 3 * l,  //
          3 * l, 4 * l * l, -3 * l, -l * l, -36, -3 * l, 36, -3 * l, 3 * l, -l * l, -3 * l, 4 * l * l;
      const auto at = static_cast<Eigen::Index>(2 * e);
      stiffness.block<4, 4>(at, at) += rigidity / (l * l * l * (1 + phi)) * k;
      mass.block<4, 4>(at, at) += w_.material.density * (area * l / 420 * translation + second / (30 * l) * rotation);
    }
    const Disc disc = discOf(w_);
    mass(2 * wheel_, 2 * wheel_) += disc.mass, mass(2 * wheel_ + 1, 2 * wheel_ + 1) += disc.transverse;
    mass(2 * box_, 2 * box_) += w_.axleBoxMass;
    // In the middle a symmetric shaft has no slope, an antisymmetric one no deflection.
    return frequencies(stiffness, mass, centre == Centre::symmetric ? 1 : 0);
  }

  std::vector<double> torsion(Centre centre) const {
    const auto n = static_cast<Eigen::Index>(nodes_.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n), mass = stiffness;
    const double polar = pi / 2 * (std::pow(w_.axleRadius, 4) - std::pow(w_.boreRadius, 4));
    const double shear = w_.material.young / (2 * (1 + w_.material.poisson));
    for (std::size_t e = 0; e + 1 < nodes_.size(); ++e) {
      const double l = nodes_[e + 1] - nodes_[e];
      Eigen::Matrix2d k, m;
      k << 1, -1, -1, 1;
      m << 2, 1, 1, 2;
      const auto at = static_cast<Eigen::Index>(e);
      stiffness.block<2, 2>(at, at) += shear * polar / l * k;
      mass.block<2, 2>(at, at) += w_.material.density * polar * l / 6 * m;
    }
    mass(wheel_, wheel_) += discOf(w_).polar;
    mass(box_, box_) += w_.axleBoxMass * w_.journalRadius * w_.journalRadius;  // as the model spreads it
    return frequencies(stiffness, mass, centre == Centre::antisymmetric ? 0 : -1);
  }

 private:
  // Without one unknown of the middle; -1: with all.
  static std::vector<double> frequencies(Eigen::MatrixXd stiffness, Eigen::MatrixXd mass, int fixed) {
    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0; i < stiffness.rows(); ++i)
      if (i != fixed) kept.push_back(i);
    stiffness = stiffness(kept, kept).eval(), mass = mass(kept, kept).eval();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass, Eigen::EigenvaluesOnly);
    std::vector<double> found;
    for (const double value : solver.eigenvalues())
      if (const double f = std::sqrt(std::max(0.0, value)) / (2 * pi); f > 1) found.push_back(f);
    return found;
  }

  scenario::Wheelset w_;
  std::vector<double> nodes_;
  int wheel_ = 0, box_ = 0;
};

// The mode of a harmonic nearest to a frequency.
double nearest(const std::vector<model::HarmonicMode>& modes, int harmonic, double frequency) {
  double best = INFINITY;
  for (const auto& mode : modes)
    if (mode.harmonic == harmonic && std::abs(mode.frequency - frequency) < std::abs(best - frequency))
      best = mode.frequency;
  return best;
}

// Below 1500 Hz: above, the outer ends of a shaft this thick are no beams. What is left, up to 1.7 %: within the hubs
// the shaft is stiffer than by itself, and the wheels are not quite rigid. Wheels of 100 mm instead make the first
// antisymmetric bending 2.8 % slower.
TEST(AxleModes, OfStiffWheelsAreThoseOfAShaftWithTwoDiscs) {
  constexpr double highest = 1500, tolerance = 0.02;
  const auto scenario = stiffWheels();
  const HalfShaft shaft(scenario.wheelset);
  int compared = 0;
  for (const auto centre : {Centre::symmetric, Centre::antisymmetric}) {
    const auto modes = model::wheelsetModes(scenario, 2000, 1, centre);
    const auto compare = [&](const std::vector<double>& expected, int harmonic) {
      for (const double f : expected) {
        if (f > highest) break;
        const double off = nearest(modes, harmonic, f) / f - 1;
        EXPECT_NEAR(off, 0, tolerance) << f << " Hz, harmonic " << harmonic;
        ++compared;
      }
    };
    compare(shaft.torsion(centre), 0);
    compare(shaft.bending(centre), 1);
  }
  // Two torsions (46, 1075 Hz), three symmetric bendings (67, 363, 1473 Hz), two antisymmetric ones (127, 841 Hz).
  EXPECT_EQ(compared, 7);
}

}  // namespace
}  // namespace squat

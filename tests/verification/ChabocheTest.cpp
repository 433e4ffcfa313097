// Steel whose back-stresses recover, one element of it: under stress that is pulled and pressed unequally it ratchets.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "OneElement.h"
#include "scenario/Track.h"

namespace squat::plasticity {
namespace {

using elasticity::steel;
using tests::Brick;

scenario::Rail steelOf(double yield, std::array<scenario::Backstress, 3> backstresses, double exponent) {
  scenario::Rail rail;
  rail.material = steel, rail.yieldStress = yield;
  rail.hardening = scenario::Hardening::chaboche;
  rail.backstresses = backstresses, rail.recoveryExponent = exponent;
  return rail;
}

// Goes to a uniaxial stress: the plastic strain that fits it, by halving.
double goTo(Brick& brick, double stress, double low, double high) {
  const auto before = brick.keep();
  const auto rest = [&](double plastic) {
    brick.giveBack(before);
    const double along = stress / steel.young + plastic, across = -steel.poisson * stress / steel.young - plastic / 2;
    brick.strain({along, across, across, 0, 0, 0});
    return brick.plastic()[0] - plastic;
  };
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (low + high);
    (rest(middle) > 0 ? low : high) = middle;
  }
  rest(0.5 * (low + high));
  return 0.5 * (low + high);
}

class OneElement : public testing::TestWithParam<std::string> {};

// Armstrong and Frederick, one back-stress, stress between s1 and s2 (J. Lemaitre, J.-L. Chaboche, Mechanics of Solid
// Materials, 1990, 5.4): each cycle adds
//   (1/g) ln{[(C/g)^2 - (s1 + s_y)^2] / [(C/g)^2 - (s2 - s_y)^2]}, 3.798834e-3 for 50 GPa, 200, 400 MPa, +600, -520
//   MPa.
// Within 1 %: implicit Euler is first order; steps of 1/200 of the way leave 4.5 %, of 1/1000 less than 1 %.
TEST_P(OneElement, RatchetsAsArmstrongAndFrederickSay) {
  Brick brick(steelOf(400e6, {{{50e9, 200}, {}, {}}}, 0), GetParam());
  double plastic = 0, atPeak = 0, last = 0;
  const double upper = 600e6, lower = -520e6;
  double from = 0;
  for (int cycle = 0; cycle < 3; ++cycle) {
    for (const double goal : {upper, lower}) {
      for (int k = 1; k <= 1000; ++k)
        plastic = goTo(brick, from + (goal - from) * k / 1000, plastic - 0.002, plastic + 0.002);
      from = goal;
      if (goal == upper) last = atPeak, atPeak = plastic;
    }
  }
  const double limit = 50e9 / 200;
  const double theory =
      std::log((limit * limit - std::pow(lower + 400e6, 2)) / (limit * limit - std::pow(upper - 400e6, 2))) / 200;
  EXPECT_NEAR(theory, 3.798834e-3, 1e-9);
  EXPECT_NEAR((atPeak - last) / theory, 1, 0.01);
}

// Symmetric cycles between +s and -s close at once: in each half cycle X goes from -(s - s_y) to s - s_y, and with one
// back-stress the strain grows by (1/g) ln[(C/g + s - s_y) / (C/g - s + s_y)] each way. 1 % as above.
TEST_P(OneElement, SymmetricCyclesClose) {
  Brick brick(steelOf(400e6, {{{50e9, 200}, {}, {}}}, 0), GetParam());
  double plastic = 0, from = 0, lowest = 0, highest = 0;
  for (int cycle = 0; cycle < 3; ++cycle)
    for (const double goal : {520e6, -520e6}) {
      for (int k = 1; k <= 500; ++k)
        plastic = goTo(brick, from + (goal - from) * k / 500, plastic - 0.005, plastic + 0.005);
      from = goal;
      (goal > 0 ? highest : lowest) = plastic;
    }
  const double width = std::log((250e6 + 120e6) / (250e6 - 120e6)) / 200;
  EXPECT_NEAR(highest - lowest, width, 0.01 * width);
}

// The law by itself, in tensors, with steps so short that explicit steps do: strains go round a path on which a
// rolling contact could take them (pressure, and shear in antiphase).
struct Plain {
  scenario::Rail rail;
  using Tensor = Eigen::Matrix3d;
  Tensor plastic = Tensor::Zero(), back[3] = {Tensor::Zero(), Tensor::Zero(), Tensor::Zero()};
  double p = 0, growth = 0, work = 0;

  void step(const Tensor& strain) {
    const double shear = steel.young / (2 * (1 + steel.poisson));
    Tensor deviator = strain - strain.trace() / 3 * Tensor::Identity();
    Tensor relative = 2 * shear * (deviator - plastic);
    for (const auto& x : back) relative -= x;
    const double size = std::sqrt(1.5) * relative.norm(), beyond = size - rail.yieldStress - growth;
    if (beyond <= 0) return;
    const Tensor flow = 1.5 * relative / size;
    double stiffness = 3 * shear + rail.isotropicRate * (rail.isotropicSaturation - growth);
    double fading[3];
    for (int i = 0; i < 3; ++i) {
      const double equivalent = std::sqrt(1.5) * back[i].norm();
      fading[i] = rail.backstresses[i].recovery;
      if (rail.recoveryExponent > 0 && fading[i] > 0) {
        const double along = equivalent > 0 ? std::max(0.0, back[i].cwiseProduct(flow).sum() / equivalent) : 0;
        fading[i] *=
            std::pow(equivalent * rail.backstresses[i].recovery / rail.backstresses[i].modulus, rail.recoveryExponent) *
            along;
      }
      stiffness += rail.backstresses[i].modulus - fading[i] * back[i].cwiseProduct(flow).sum();
    }
    const double dp = beyond / stiffness;
    Tensor stress = 2 * shear * (deviator - plastic);
    work += stress.cwiseProduct(flow).sum() * dp;
    plastic += dp * flow, p += dp;
    for (int i = 0; i < 3; ++i)
      back[i] += 2.0 / 3 * rail.backstresses[i].modulus * dp * flow - fading[i] * dp * back[i];
    growth += rail.isotropicRate * (rail.isotropicSaturation - growth) * dp;
  }
};

// Steps of the program are 1/400 of a round, as a passage makes; those of the plain law 1/40000. Tolerance 2 % of the
// plastic strain's size: implicit against explicit Euler, first order in steps of 1e-5 against a curvature of 1/1500.
TEST_P(OneElement, FollowsTheLawRoundAPath) {
  for (const double exponent : {0.0, 5.0}) {
    auto rail = steelOf(335e6, {{{191e9, 1500}, {8.2e9, 150}, {9.9e9, 12}}}, exponent);
    rail.isotropicSaturation = -60e6, rail.isotropicRate = 20;
    Brick brick(rail, GetParam());
    Plain plain{rail};
    const auto strainAt = [](double turn) {
      const double t = 2 * M_PI * turn, press = 0.5 * (1 - std::cos(t));
      return std::array<double, 6>{-0.001 * press,
                                   -0.0005 * press,
                                   -0.006 * press,
                                   0.001 * std::sin(2 * t),
                                   0,
                                   0.004 * std::sin(t) + 0.001 * press};
    };
    for (int round = 0; round < 3; ++round)
      for (int k = 1; k <= 400; ++k) {
        brick.strain(strainAt(k / 400.0));
        for (int fine = 1; fine <= 100; ++fine) {
          const auto e = strainAt((k - 1 + fine / 100.0) / 400.0);
          Plain::Tensor strain;
          strain << e[0], e[3] / 2, e[5] / 2, e[3] / 2, e[1], e[4] / 2, e[5] / 2, e[4] / 2, e[2];
          plain.step(strain);
        }
      }
    const auto flow = brick.plastic();
    const double scale = plain.plastic.norm();
    ASSERT_GT(scale, 5e-4);
    EXPECT_NEAR(brick.equivalent(), plain.p, 0.02 * plain.p) << exponent;
    EXPECT_NEAR(flow[0], plain.plastic(0, 0), 0.02 * scale) << exponent;
    EXPECT_NEAR(flow[2], plain.plastic(2, 2), 0.02 * scale) << exponent;
    EXPECT_NEAR(flow[5] / 2, plain.plastic(0, 2), 0.02 * scale) << exponent;
    EXPECT_NEAR(brick.dissipated(), plain.work, 0.02 * plain.work) << exponent;
  }
}

INSTANTIATE_TEST_SUITE_P(Chaboche, OneElement, testing::ValuesIn(elasticity::availableInstructionSets()));

}  // namespace
}  // namespace squat::plasticity

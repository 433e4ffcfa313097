// Sizes and masses of the half wheelset.
//
// Mass by the theorem of Pappus: a piece of the section with area A and centroid at radius r weighs rho 2 pi r A. The
// mesh has flat sectors, so a turn counts sum of sin(angle) instead of 2 pi. First moment along the axle likewise:
// lumping keeps both. Tolerance: round-off.
#include <gtest/gtest.h>

#include <cmath>

#include "core/Errors.h"
#include "keys/Keys.h"
#include "model/WheelsetDamping.h"

namespace squat {
namespace {

using scenario::Wheelset;
using tests::modelWith;
using tests::scenarioWith;

struct Moments {
  double mass = 0, lever = 0;  // [kg], [kg m] along the axle, outwards positive
  void add(double turn, double inner, double outer, double from, double to, double density) {
    const double own = density * turn * (outer * outer - inner * inner) / 2 * (to - from);
    mass += own, lever += own * (from + to) / 2;
  }
};

double turnOf(const elasticity::SweptBlock& ring) {
  double sum = 0;
  for (int i = 0; i < ring.intervals; ++i) sum += std::sin(ring.positions[i + 1] - ring.positions[i]);
  return sum;
}

// The web from the hub (inner radius) to the rim: thickness and middle linear in the radius, so Simpson's rule over the
// cubic integrand is exact.
void addWeb(Moments& sum, const Wheelset& w, double turn) {
  const double atHub = w.webHubThickness > 0 ? w.webHubThickness : w.webThickness;
  const double depth = w.rimInnerRadius - w.hubRadius;
  const double weights[] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
  for (int i = 0; i < 3; ++i) {
    const double t = 0.5 * i, radius = w.hubRadius + t * depth;
    const double own = w.material.density * turn * weights[i] * depth * radius * (atHub + t * (w.webThickness - atHub));
    sum.mass += own, sum.lever += own * (1 - t) * w.webOffset;
  }
}

Moments expectedOf(const Wheelset& w, double rimDepth, double bodyTurn, double rimTurn) {
  const double hub = w.hubWidth / 2, rim = w.rimWidth / 2, tied = w.radius - rimDepth, density = w.material.density;
  Moments sum;
  sum.add(rimTurn, tied, w.radius, -rim, rim, density);
  sum.add(bodyTurn, w.rimInnerRadius, tied, -rim, rim, density);
  addWeb(sum, w, bodyTurn);
  sum.add(bodyTurn, w.boreRadius, w.hubRadius, -hub, hub, density);
  sum.add(bodyTurn, w.boreRadius, w.axleRadius, -w.trackCentre, -hub, density);
  sum.add(bodyTurn, w.boreRadius, w.shoulderRadius, hub, w.shoulderEnd, density);
  sum.add(bodyTurn, w.boreRadius, w.journalRadius, w.shoulderEnd, w.journalEnd, density);
  return sum;
}

Moments meshed(const model::Model& model) {
  Moments sum;
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    const auto mass = elasticity::lumpedMass(block);
    for (int n = 0; n < block.nodes; ++n)
      for (int s = 0; s < block.stationCount; ++s) {
        const double m = mass[n * block.stride + s];
        sum.mass += m, sum.lever += m * block.section.nodes[n][1];
      }
  }
  return sum;
}

TEST(WheelsetKeys, SizesMakeTheSolid) {
  struct {
    const char *key, *text;
    double Wheelset::*member;
    double value;  // SI
  } const rows[] = {{"wheelset.radius", "0.45", &Wheelset::radius, 0.45},
                    {"wheelset.rim_width", "125", &Wheelset::rimWidth, 0.125},
                    {"wheelset.rim_inner_radius", "400", &Wheelset::rimInnerRadius, 0.4},
                    {"wheelset.web_thickness", "24", &Wheelset::webThickness, 0.024},
                    {"wheelset.web_hub_thickness", "36", &Wheelset::webHubThickness, 0.036},
                    {"wheelset.web_offset", "-20", &Wheelset::webOffset, -0.020},
                    {"wheelset.hub_radius", "130", &Wheelset::hubRadius, 0.13},
                    {"wheelset.hub_width", "165", &Wheelset::hubWidth, 0.165},
                    {"wheelset.axle_radius", "78", &Wheelset::axleRadius, 0.078},
                    {"wheelset.bore_radius", "35", &Wheelset::boreRadius, 0.035},
                    {"wheelset.shoulder_radius", "84", &Wheelset::shoulderRadius, 0.084},
                    {"wheelset.shoulder_end", "160", &Wheelset::shoulderEnd, 0.16},
                    {"wheelset.journal_radius", "60", &Wheelset::journalRadius, 0.06},
                    {"wheelset.journal_end", "340", &Wheelset::journalEnd, 0.34},
                    {"wheelset.track_centre", "0.72", &Wheelset::trackCentre, 0.72}};
  const auto plain = scenarioWith({});
  for (const auto& row : rows) {
    const auto model = modelWith({{row.key, row.text}});
    Wheelset changed = plain.wheelset;
    changed.*row.member = row.value;
    const double body = turnOf(model.blocks[model.body]), rim = turnOf(model.blocks[model.rim]);
    const auto expected = expectedOf(changed, plain.mesh.rimDepth, body, rim);
    const auto before = expectedOf(plain.wheelset, plain.mesh.rimDepth, body, rim), found = meshed(model);
    EXPECT_NEAR(found.mass, expected.mass, 1e-9 * expected.mass) << row.key;
    EXPECT_NEAR(found.lever, expected.lever, 1e-9 * expected.mass) << row.key;
    EXPECT_GT(std::hypot(expected.mass - before.mass, expected.lever - before.lever), 0.1)
        << row.key << " does nothing";
  }
}

// Where the wheel's own motion is read: the seat under the hub, in the wheel plane.
TEST(WheelsetKeys, TheCentreStandsOnTheSeat) {
  const auto model = modelWith({{"wheelset.seat_radius", "95"}});
  double y = 0;
  for (std::size_t i = 0; i < model.centre.nodes.size(); ++i) {
    const auto& p = model.blocks[model.body].section.nodes[model.centre.nodes[i]];
    EXPECT_NEAR(p[0], 0.095, 1e-12);
    y += model.centre.weight[i] * p[1];
  }
  EXPECT_NEAR(y, 0, 1e-12);
}

double massBeyond(const model::Model& model, double y) {
  const auto& body = model.blocks[model.body];
  double sum = 0;
  for (int n = 0; n < body.nodes; ++n)
    for (int s = 0; s < body.stationCount && body.section.nodes[n][1] > y; ++s)
      sum += model.mass[model.body][n * body.stride + s];
  return sum;
}

// The axle box is spread over its bearing seat; what is left of the total sits on the axle between the wheels.
TEST(WheelsetKeys, AxleBoxAndDiscsMakeUpTheMass) {
  const auto plain = modelWith({}), heavy = modelWith({{"wheelset.axle_box_mass", "210"}});
  const double more = 210 - plain.scenario.wheelset.axleBoxMass;
  EXPECT_NEAR(massBeyond(heavy, 0.151) - massBeyond(plain, 0.151), more, 1e-9);
  EXPECT_NEAR(massBeyond(heavy, -1), massBeyond(plain, -1), 1e-9 * heavy.wheelset.mass);
  const auto large = modelWith({{"wheelset.total_mass", "1000"}});
  EXPECT_NEAR(large.wheelset.mass - plain.wheelset.mass, 1000 - plain.scenario.wheelset.totalMass, 1e-9);
  EXPECT_NEAR(massBeyond(large, -0.1), massBeyond(plain, -0.1), 1e-9);
  EXPECT_NEAR(massBeyond(large, -1) - massBeyond(plain, -1), 1000 - plain.scenario.wheelset.totalMass, 1e-9);
}

double firstMoment(const model::Model& model) {
  double sum = 0;
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int n = 0; n < block.nodes; ++n)
      for (int s = 0; s < block.stationCount; ++s)
        sum += model.mass[b][n * block.stride + s] * block.section.nodes[n][1];
  }
  return sum;
}

double massOfRim(const model::Model& model) {
  double sum = 0;
  const auto& rim = model.blocks[model.rim];
  for (int n = 0; n < rim.nodes; ++n)
    for (int s = 0; s < rim.stationCount; ++s) sum += model.mass[model.rim][n * rim.stride + s];
  return sum;
}

// Distance from the wheel plane [m] of the middle of what is spread over the axle: found by adding some more.
double spreadMiddle(const model::Model& plain) {
  const auto heavy = modelWith({{"wheelset.total_mass", "1000"}});
  return -(firstMoment(heavy) - firstMoment(plain)) / (heavy.wheelset.mass - plain.wheelset.mass);
}

// A total mass of 0 is that of the parts: solids of revolution (Pappus with a whole turn), axle box and brake discs.
TEST(WheelsetKeys, PartsMakeTheMassWhereNoneIsStated) {
  const double turn = 2 * std::acos(-1.0);
  for (const char* discs : {"0", "1", "3"}) {
    const auto model = modelWith({{"wheelset.total_mass", "0"},
                                  {"wheelset.brake_discs", discs},
                                  {"wheelset.brake_disc_mass", "80"},
                                  {"wheelset.web_hub_thickness", "40"}});
    const auto& w = model.scenario.wheelset;
    const double solids = expectedOf(w, model.scenario.mesh.rimDepth, turn, turn).mass;
    const double expected = solids + w.axleBoxMass + 80 * std::stod(discs);
    EXPECT_NEAR(model.wheelset.mass, expected, 1e-9 * expected) << discs;
    EXPECT_NEAR(massBeyond(model, -1), expected - massOfRim(model), 1e-9 * expected) << discs;
  }
}

// Discs are rings on the surface of the axle: each adds its mass, its lever about the wheel plane and mass times radius
// squared to the inertia. Two stand at 300 mm and two thirds of the rest further, where the distance to each other,
// 300 mm, is that to the mirror image beyond the track centre.
TEST(WheelsetKeys, BrakeDiscsSitOnTheAxle) {
  const tests::Values derived{{"wheelset.total_mass", "0"}};
  const auto with = [&](const char* discs) {
    auto values = derived;
    values.insert(
        values.end(),
        {{"wheelset.brake_discs", discs}, {"wheelset.brake_disc_mass", "95"}, {"wheelset.brake_disc_position", "300"}});
    return modelWith(values);
  };
  const auto none = modelWith(derived), one = with("1"), two = with("2");
  const double radius = none.scenario.wheelset.axleRadius;
  EXPECT_NEAR(one.wheelset.mass - none.wheelset.mass, 95, 1e-9);
  EXPECT_NEAR(firstMoment(one) - firstMoment(none), -95 * 0.3, 1e-9);
  EXPECT_NEAR(firstMoment(two) - firstMoment(one), -95 * 0.6, 1e-9);
  EXPECT_NEAR(two.wheelset.inertia - none.wheelset.inertia, 2 * 95 * radius * radius, 1e-9);
}

// A stated total mass stays what it is: what the discs weigh is no longer spread over the axle.
TEST(WheelsetKeys, AStatedMassHoldsTheDiscs) {
  const auto plain = modelWith({}), disc = modelWith({{"wheelset.brake_discs", "1"}});
  EXPECT_NEAR(massBeyond(disc, -1), massBeyond(plain, -1), 1e-9);
  EXPECT_NEAR(disc.wheelset.mass, plain.wheelset.mass, 1e-9);
  // It moves from the middle of what is spread to the place of the disc.
  const auto& w = disc.scenario.wheelset;
  EXPECT_NEAR(firstMoment(disc) - firstMoment(plain), w.brakeDiscMass * (spreadMiddle(plain) - w.brakeDiscPosition),
              1e-9);
}

TEST(WheelsetKeys, TheBearingCoversItsSeat) {
  const auto model = modelWith({{"wheelset.bearing_centre", "240"}, {"wheelset.bearing_width", "120"}});
  double first = 9, last = -9, middle = 0;
  for (std::size_t i = 0; i < model.bearing.nodes.size(); ++i) {
    const double y = model.blocks[model.body].section.nodes[model.bearing.nodes[i]][1];
    first = std::min(first, y), last = std::max(last, y), middle += model.bearing.weight[i] * y;
  }
  EXPECT_NEAR(first, 0.18, 1e-9);
  EXPECT_NEAR(last, 0.30, 1e-9);
  EXPECT_NEAR(middle, 0.24, 1e-9);
}

// Damped are the modes below the limit and no others: those found with 2 kHz, up to 900 Hz.
TEST(WheelsetKeys, ModesAboveTheLimitAreNotDamped) {
  const auto frequencies = [](const char* limit) {
    const auto model = modelWith({{"wheelset.damping_ratio", "0.02"}, {"wheelset.damping_limit", limit}});
    const model::WheelsetDamping damping(model, 1e-6);
    std::vector<double> list;
    for (int k = 0; k < damping.modes(); ++k) list.push_back(damping.frequency(k));
    std::sort(list.begin(), list.end());
    return list;
  };
  const auto all = frequencies("2000"), low = frequencies("900");
  ASSERT_FALSE(low.empty());
  ASSERT_GT(all.size(), low.size());
  for (std::size_t k = 0; k < low.size(); ++k) EXPECT_NEAR(low[k], all[k], 1e-6 * all[k]);
  EXPECT_LT(low.back(), 900);
  EXPECT_GT(all[low.size()], 900);
}

}  // namespace
}  // namespace squat

// A conical tread on a leaning rail, undeformed bodies: where they touch, along which direction they press, and the
// spin that a cone brings with it.
//
// Geometry: crown R300 turned by its inclination i, straight tread of slope c. They touch where the slopes agree, at
// y = 300 mm (atan i - atan c) from the middle of the crown while that lies on R300. Pressure acts along the common
// normal: lateral over vertical force is c. Lowered by d, the gap along the normal is that of Hertz's bodies: d cos c -
// x^2 cos c / 2R - y^2 / 2r, y from the touching point.
// Spin: a wheel whose axis leans by the contact angle g against the contact plane turns with sin g / R of its speed in
// that plane, slip (spin y, -spin x) (J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, 1990, 1.3).
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "contact/RollingContact.h"
#include "model/Model.h"

namespace squat::contact {
namespace {

constexpr ContactLaw inclinedLaw{1e14, 0.7e14, 0.3};
constexpr double lowered = 8e-5, inclinedStep = 2e-7, railCrown = 0.300;

// Everything that one evaluation of the contact needs, the wheelset lowered as a rigid body.
struct Stand {
  model::Model model;
  AlignedVector displaced, velocity;
  FrictionHistory history;
  WheelRolling wheel;
  std::vector<int> railLines, rimLines;
  std::vector<double> railForces, rimForces;
  std::vector<PatchPoint> points;

  Stand(const std::string& inclination, const std::string& cone, const std::string& offset) {
    model = model::buildModel(cases::loadScenario(
        tests::fixtureCase("smooth-rail"),
        {"tiny", {{"rail.inclination", inclination}, {"wheelset.cone", cone}, {"motion.lateral_offset", offset}}}));
    displaced.assign(model.stateSize, 0.0), velocity.assign(model.stateSize, 0.0);
    history.traction.assign(2 * model.surfaces.points(), 0.0);
    wheel.placement = {model.startX, model.wheelset.centreHeight - lowered, 0, 0, 0};
    lines(model.surfaces.railLine, model.rail, railLines, railForces);
    lines(model.surfaces.treadLine, model.rim, rimLines, rimForces);
  }

  void lines(const std::vector<int>& nodes, int block, std::vector<int>& lineOfNode, std::vector<double>& buffer) {
    lineOfNode.assign(model.blocks[block].nodes, -1);
    int next = 0;
    for (const int node : nodes) lineOfNode[node] = next++;
    buffer.assign(static_cast<std::size_t>(next) * 3 * model.blocks[block].stride, 0.0);
  }

  PatchState roll(const ContactLaw& with = inclinedLaw) {
    points.clear();
    return rollContact({model.surfaces, model.blocks[model.rail], model.blocks[model.rim], with},
                       {wheel, displaced.data(), velocity.data(), inclinedStep}, history,
                       {{railForces.data(), railLines.data()}, {rimForces.data(), rimLines.data()}},
                       {nullptr, &points, nullptr});
  }

  Eigen::Vector3d resultant(int block, const std::vector<int>& lineOfNode, const std::vector<double>& buffer) const {
    const auto& b = model.blocks[block];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int n = 0; n < b.nodes; ++n)
      for (int s = 0; s <= b.intervals && lineOfNode[n] >= 0; ++s) {
        Eigen::Vector3d local;
        for (int c = 0; c < 3; ++c) local[c] = buffer[(static_cast<std::size_t>(lineOfNode[n]) * 3 + c) * b.stride + s];
        sum += elasticity::localBasis(b, b.positions[s]) * local;
      }
    return sum;
  }
};

struct Location {
  const char *inclination, *cone, *offset;
  double touch;  // [m] on the crown
};

class InclinedContact : public testing::TestWithParam<Location> {};

TEST_P(InclinedContact, TouchesWhereTheSlopesAgree) {
  const auto& location = GetParam();
  Stand stand(location.inclination, location.cone, location.offset);
  EXPECT_NEAR(stand.model.surfaces.touchY, location.touch, 1e-9);
  stand.wheel.placement.centreZ += lowered - 1e-9;  // a nanometre deep: only the touching point is near
  const auto& s = stand.model.surfaces;
  const auto [first, last] = reachableIntervals(s, stand.model.blocks[stand.model.rail], stand.model.startX, 0.01);
  double deepest = -1;
  for (int i = first; i < last; ++i)
    for (int j = s.firstColumn; j < s.firstColumn + s.columns; ++j)
      for (int p = 0; p < 4; ++p) {
        TouchPoint t;
        if (evaluatePoint(s, stand.model.blocks[stand.model.rail], stand.model.blocks[stand.model.rim],
                          stand.displaced.data(), stand.wheel.placement, i, j, p, 1.0, t))
          deepest = std::max(deepest, t.penetration);
      }
  // Nothing overlaps, and points of 5 mm quads come within 2.5 mm of the touching point: 2 * 2.5^2 / (2 * 300) mm.
  EXPECT_LE(deepest, 1.1e-9);
  EXPECT_GE(deepest, -2 * 0.0025 * 0.0025 / (2 * railCrown));
}

// Terms of fourth order over an ellipse of 9 x 7 mm: 1e-3 of the depth.
TEST_P(InclinedContact, PenetrationIsTheGapAlongTheCommonNormal) {
  const auto& location = GetParam();
  Stand stand(location.inclination, location.cone, location.offset);
  stand.roll({inclinedLaw.normalPenalty, inclinedLaw.tangentialPenalty, 0});
  ASSERT_GT(stand.points.size(), 8u);
  const auto& s = stand.model.surfaces;
  const double lean = std::atan(std::stod(location.inclination));
  const double z = -location.touch * location.touch / (2 * railCrown);  // crown height at the touching point, R300
  const double touchY = location.touch * std::cos(lean) - z * std::sin(lean);
  for (const auto& p : stand.points) {
    const double y = (p.y - touchY) / s.treadCosine;  // along the common tangent
    const double expected = s.treadCosine * (lowered - p.x * p.x / (2 * s.radius)) - y * y / (2 * railCrown);
    EXPECT_NEAR(p.pressure / inclinedLaw.normalPenalty, expected, 1e-3 * lowered) << p.x << ", " << p.y;
  }
}

TEST_P(InclinedContact, ForcesAreEqualOppositeAndAlongTheNormal) {
  const auto& location = GetParam();
  Stand stand(location.inclination, location.cone, location.offset);
  const auto patch = stand.roll({inclinedLaw.normalPenalty, inclinedLaw.tangentialPenalty, 0});
  const Eigen::Vector3d onRail = stand.resultant(stand.model.rail, stand.railLines, stand.railForces);
  const Eigen::Vector3d onWheel = stand.resultant(stand.model.rim, stand.rimLines, stand.rimForces);
  EXPECT_LT((onRail + onWheel).norm(), 1e-9 * patch.vertical);
  EXPECT_NEAR(-onRail[2], patch.vertical, 1e-9 * patch.vertical);
  EXPECT_NEAR(onRail[1], patch.lateral, 1e-9 * patch.vertical);
  // The slope of crown and tread at the touching point; e_r leans by up to 9 mm / 460 mm, squared over two.
  const double slope = std::tan(std::atan(std::stod(location.inclination)) - std::asin(location.touch / railCrown));
  EXPECT_NEAR(patch.lateral / patch.vertical, slope, 3e-4 * std::abs(slope) + 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Locations, InclinedContact,
                         testing::Values(Location{"0.025", "0.025", "0", 0}, Location{"0.025", "0.025", "4", 0.004},
                                         Location{"0.025", "0.025", "-4", -0.004}, Location{"0", "0", "4", 0.004},
                                         Location{"0.025", "0.0125", "0",
                                                  railCrown* std::sin(std::atan(0.025) - std::atan(0.0125))},
                                         Location{"0", "0.01", "0", -railCrown* std::sin(std::atan(0.01))}));

// On the first step after standing still, the traction is the tangential penalty times slip times the step.
TEST(InclinedContactSpin, AConeSpinsOnThePatch) {
  Stand stand("0.025", "0.025", "0");
  const auto& s = stand.model.surfaces;
  const double speed = 30, spin = s.treadSine / s.radius;
  stand.wheel.speed = speed, stand.wheel.angularVelocity = speed / s.radius;
  stand.roll({inclinedLaw.normalPenalty, inclinedLaw.tangentialPenalty, 1e3});  // nothing slips
  ASSERT_GT(stand.points.size(), 8u);
  for (const auto& p : stand.points) {
    const double slipX = p.tractionX / (inclinedLaw.tangentialPenalty * inclinedStep * speed);
    const double slipY = p.tractionY / (inclinedLaw.tangentialPenalty * inclinedStep * speed);
    // Undeformed bodies: the tread's material also falls behind by 1 - cos(angle).
    EXPECT_NEAR(slipX, spin * p.y - 0.5 * std::pow(p.x / s.radius, 2), 0.01 * spin * 0.005);
    EXPECT_NEAR(slipY, -spin * p.x, 0.01 * spin * 0.005);
  }
}

// 10.1 mm beside the middle a level tread touches R80 on a 54E1, whose R300 ends at 10.012 mm, and R300 on a 60E1,
// where it ends at 10.228 mm.
TEST(InclinedContact, CrownRadiusIsThatOfTheSection) {
  auto scenario = cases::loadScenario(tests::fixtureCase("smooth-rail"), {"tiny", {}});
  scenario.motion.lateralOffset = 0.0101;
  EXPECT_EQ(seatOf(scenario).crownRadius, 0.080);
  scenario.rail.section = scenario::RailSection::rail60E1;
  const WheelSeat seat = seatOf(scenario);
  EXPECT_EQ(seat.crownRadius, 0.300);
  EXPECT_EQ(seat.touchY, 0.0101);
}

}  // namespace
}  // namespace squat::contact

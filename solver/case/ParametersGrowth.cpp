// Rows of the parameter table: growth.
#include "case/ParameterRows.h"

namespace squat::cases::rows {

namespace {

using Case = CaseDescription;
using scenario::WearModel;

void addWear(Rows& rows) {
  rows.push_back(choice(
      "growth.wear", {"none", "archard", "t-gamma"}, WearModel::archard,
      +[](Case& c) -> WearModel& { return c.growth.wear; },
      "law of wear: none, Archard's, or the rates of twin-disc tests over T gamma per area (Lewis and Olofsson)",
      "assumed: both are proportional to frictional work where wear is mild"));
  rows.push_back(appliesIf(
      "growth.wear", {"archard"},
      number(
          "growth.wear_coefficient", none, 0.0001, {0, 1}, [](Case& c) -> double& { return c.growth.wearCoefficient; },
          "Archard's coefficient: worn volume times hardness over load times sliding distance",
          "assumed: 1e-4 to 1e-3 in the mild regime of dry discs (Jendel, Wear 253, 2002, unverified); the "
          "lowest, since rails in track lose less than discs")));
  rows.push_back(
      appliesIf("growth.wear", {"archard"},
                number(
                    "growth.hardness", gigapascal, 2.6, {0.1, 20}, [](Case& c) -> double& { return c.growth.hardness; },
                    "hardness of the rail", "EN 13674-1: R260 has 260 to 300 HB; 9.81 MPa each")));
}

void addTraffic(Rows& rows) {
  rows.push_back(wholeNumber(
      "growth.wheelsets", 4, {1, 64}, +[](Case& c) -> int& { return c.growth.wheelsets; },
      "wheelsets that stand for the traffic: all of them roll over the rail in turn",
      "assumed: few enough to roll again and again"));
  rows.push_back(number(
      "growth.lateral_scatter", millimetre, 3, {0, 6}, [](Case& c) -> double& { return c.growth.lateralScatter; },
      "standard deviation of where wheels touch the crown", "assumed: 2 to 6 mm on straight track (unverified)"));
  rows.push_back(number(
      "growth.load_scatter", none, 0.2, {0, 0.5}, [](Case& c) -> double& { return c.growth.loadScatter; },
      "standard deviation of the sprung mass, as a share of it",
      "assumed: mixed passenger trains, about 20 kN of 75 kN (unverified)"));
  rows.push_back(number(
      "growth.speed_scatter", none, 0.1, {0, 0.3}, [](Case& c) -> double& { return c.growth.speedScatter; },
      "standard deviation of the speed, as a share of it", "assumed"));
  rows.push_back(number(
      "growth.traction", none, 0, {-0.3, 0.3}, [](Case& c) -> double& { return c.growth.traction; },
      "torque over wheel load times radius, mean of the traffic; negative: braking; the torque of the case is that of "
      "the measuring wheelset alone",
      "assumed: most wheels roll freely"));
  rows.push_back(number(
      "growth.traction_scatter", none, 0.05, {0, 0.3}, [](Case& c) -> double& { return c.growth.tractionScatter; },
      "standard deviation of torque over wheel load times radius",
      "assumed: most wheels roll nearly free, some drive or brake with 0.05 to 0.15 (unverified)"));
  rows.push_back(wholeNumber(
      "growth.seed", 1, {0, 1000000}, +[](Case& c) -> int& { return c.growth.seed; },
      "seed of the random draw of wheelsets", "assumed"));
  rows.push_back(number(
      "growth.block_change", millimetre, 0.01, {0.0001, 1}, [](Case& c) -> double& { return c.growth.blockChange; },
      "how much the shape of the surface may change, at most, before all wheelsets roll over it again", "assumed"));
}

}  // namespace

Rows growthRows() {
  Rows rows;
  addWear(rows);
  addTraffic(rows);
  return rows;
}

}  // namespace squat::cases::rows

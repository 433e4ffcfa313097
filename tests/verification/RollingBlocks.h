// tests/verification/RollingBlocks.h - a piece of wheel rolls on a piece of rail, with nothing but the contact between.
//
// Two steel blocks large against the patch: a straight one with the rail's crown and a sector of a wheel, stations one
// on one. Explicit steps, contact, friction and its history are the program's own. The far faces of the rail block
// stand still, those of the sector turn and travel with the wheel's reference, so that the creepage is prescribed
// exactly; the sector sinks until the contact carries the load.
//
// What the blocks lack of a half space does not enter steady rolling: it adds a displacement to the patch that is
// smooth over the distance to the far faces and even about the load, whose gradient, all that creepage and slip feel,
// vanishes below the load. Steady rolling needs many patch lengths: after each element the blocks are cut off behind
// and continued ahead, state and friction history move back by one station. Mass-proportional damping takes out the
// waves that cannot leave.
#pragma once

#include <memory>
#include <vector>

#include "contact/RollingContact.h"
#include "elasticity/SweptWork.h"

namespace squat::contact {

struct RolledCase {
  double size = 0.0013;                             // [m] of elements in the patch
  double radius = 0.46;                             // [m] of the wheel; the rail has the crown of 54E1
  bool plane = false;                               // plane strain: one element across, lateral motion held
  double load = 87.8e3;                             // [N]; in plane strain on the one element's width
  double approach = 0.0955e-3, halfAxis = 6.86e-3;  // [m] about, after Hertz: stiffness of the control, size of blocks
  double friction = 0.3;
  double normalPenalty = 2.5, tangentialShare = 1;  // in units of E / size; of the normal one
  double extent = 6;                                // half axes from patch to far faces
  double speed = 150;                               // [m/s], 5 % of that of shear waves
};

class RollingBlocks {
 public:
  explicit RollingBlocks(const RolledCase& with);

  // Means over one element's length of rolling.
  struct Steady {
    double load = 0, force = 0;  // [N] on the rail; force against the direction of rolling
    double share = 0;            // force over friction times load
    double length = 0;           // [m] 2 sqrt(5 <x^2>) of the pressure
    double stick = 0;            // [m] length of the stick zone along the patch's centre
  };
  void press();
  // Rolls on with the creepage (rim faster than the rail: positive) over so many elements, the last one judged.
  Steady roll(double creepage, int elements);
  // Rolls until the force stands. It follows the creepage over a distance of about two half axes, as both bodies yield
  // to it; what is missing in the end is taken from the last three of equally spaced forces (A. C. Aitken).
  Steady settle(double creepage);

  std::size_t elements() const;

 private:
  void build();
  double stableStep();
  void moveBack();
  void step(double speed, double angularVelocity, PatchState& patch, std::vector<PatchPoint>* points);

  RolledCase with_;
  std::vector<elasticity::SweptBlock> blocks_;  // rail, wheel
  Surfaces surfaces_;
  ContactLaw law_;
  double step_ = 0, width_ = 1;
  WheelPlacement placement_;
  AlignedVector displaced_, target_, velocity_;
  FrictionHistory history_;
  std::vector<AlignedVector> inverseMass_, massChunks_, acceleration_, forces_;
  std::vector<std::vector<double>> freeMask_;
  std::vector<std::vector<int>> lineOfNode_;
  std::vector<std::vector<unsigned char>> slave_;
  std::vector<elasticity::BlockStep> blockSteps_;
  std::unique_ptr<elasticity::KernelScratch> scratch_;
};

}  // namespace squat::contact

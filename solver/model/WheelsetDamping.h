// solver/model/WheelsetDamping.h - modal damping of the wheelset while it rolls: of the modes of half a wheelset that
// is symmetric, or antisymmetric (CentrePlane.h).
//
// Every flexible mode of the free wheelset below a limit loses velocity at the rate 2 zeta omega; rigid motion and
// everything else lose nothing. Damping proportional to the stiffness would do this to the highest modes of the mesh
// first and cost the time step. Modes are slow against the step, so they are damped in kicks, at least twenty in the
// shortest period and two in a sample of the output: the modal velocities are taken to exp(-2 zeta omega t) of what
// they were, t from kick to kick, the solution of q'' = -2 zeta omega q'; no step makes that unstable, and its energy
// is known exactly. Velocities are those that an observer beside the track sees, as in all damping of this program: a
// wheel that turns under a steady load is not braked.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/CentrePlane.h"
#include "model/Model.h"

namespace squat::model {

class WheelsetDamping {
 public:
  // Nothing is computed, and due() stays false, where the case asks for no damping. `step` [s] of the time loop.
  WheelsetDamping(const Model& model, double step, Centre centre = Centre::symmetric);

  bool due(long step) const { return every_ > 0 && step % every_ == 0; }

  // Damps velocities (state layout) of a wheelset turned by `rotation`; returns the energy that they lose [J]. The time
  // loop keeps u + beta v, so that u moves by beta of what is taken: 2 zeta w beta of the loss, 1e-5 at usual damping.
  double apply(double rotation, double* velocity);

  long every() const { return every_; }  // steps between kicks; 0: none
  int modes() const { return static_cast<int>(rate_.size()); }
  double frequency(int mode) const { return frequency_[static_cast<std::size_t>(mode)]; }  // [Hz]
  // Adds a damped mode, orthonormal in the masses of the model, to velocities of the wheelset as it stood unturned.
  void addMode(int mode, double amount, double* velocity);

 private:
  // Vectors come in pairs about the axis, cos and sin; those of the rigid motions stand first.
  struct Vector {
    int harmonic = 0;
    bool turned = false;               // the second of a pair: u_r, u_y ~ sin(n alpha), u_alpha ~ -cos(n alpha)
    double box = 0;                    // of an axle box on its spring, along z (first) or against x (second)
    std::vector<double> amplitude[2];  // per section node of rim and body: alpha, r, y
  };
  struct Block {
    int index = 0;
    Eigen::MatrixXd waves;  // stations in whole chunks x waves: 1, cos, sin, cos 2, ...; zero beyond the stations
  };
  // Components of the vectors, weighed by mass, in velocities.
  Eigen::VectorXd project(const double* velocity, double boxX, double boxZ);
  void add(const Eigen::VectorXd& amounts, double* velocity, double& boxX, double& boxZ);
  void addPair(const Vector& first);

  const Model& model_;
  long every_ = 0;
  std::vector<Vector> vectors_;
  Block blocks_[2];
  std::vector<double> frequency_;     // per mode
  std::vector<double> rate_;          // per mode: share of its velocity that a kick takes
  Eigen::MatrixXd toModes_, toKick_;  // components -> orthonormal modal velocities -> amounts of the vectors
  Eigen::MatrixXd weighed_, field_;   // workspace
};

}  // namespace squat::model

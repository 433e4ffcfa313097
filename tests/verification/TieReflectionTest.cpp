// Plane wave through a tie between a fine and a coarse block.
// Theory: a plane wave at normal incidence on a welded joint of equal materials is not reflected (impedance rho c on
// both sides); what comes back is the numerical mismatch of the two meshes. For wavelengths of ten coarse elements and
// more less than 2 % of the amplitude is asked for. Motion along the normal only, lateral motion held: speed c = sqrt(E
// (1 - nu) / ((1 + nu)(1 - 2 nu) rho)).
#include <gtest/gtest.h>

#include <cmath>

#include "elasticity/SweptSamples.h"
#include "elasticity/SweptTie.h"
#include "elasticity/SweptWork.h"
#include "verification/Seen.h"

namespace squat::elasticity {
namespace {

constexpr double fineSize = 0.005, coarseSize = 0.010, height = 0.8;  // [m] of each block across the tie

struct Joined {
  std::vector<SweptBlock> blocks;
  std::size_t size = 0;
  std::vector<SweptTie> ties;
  AlignedVector mass;  // per unknown, slaves passed on
};

SweptBlock column(const char* name, double size, double from, double to) {
  SweptBlock block;
  block.name = name, block.material = steel;
  const int across = static_cast<int>(std::lround(0.02 / size)), up = static_cast<int>(std::lround((to - from) / size));
  block.section = gridSection(evenly(0, 0.02, across), evenly(from, to, up));
  block.stations = {0, false, {{static_cast<int>(std::lround(0.08 / size)), size}}};
  return block;
}

// Slave block above (z > 0), master below.
Joined join(double slaveSize, double masterSize) {
  Joined j;
  j.blocks = {column("upper", slaveSize, 0, height), column("lower", masterSize, -height, 0)};
  j.size = layOut(j.blocks);
  j.ties.push_back(makeTie(j.blocks, 0, 1,
                           geometry::nodesWhere(
                               j.blocks[0].section, [](const auto& p) { return std::abs(p[1]) < 1e-9; }, 0)));
  j.mass.assign(j.size, 0.0);
  for (const auto& block : j.blocks) {
    const auto lumped = lumpedMass(block);
    for (int n = 0; n < block.nodes; ++n)
      for (int s = 0; s < block.stationCount; ++s)
        for (int c = 0; c < 3; ++c) j.mass[block.index(n, c, s)] = lumped[n * block.stride + s];
  }
  return j;
}

void transfer(const Joined& j, AlignedVector& values) {
  const AlignedVector from = values;
  passToMasters(j.ties[0], j.blocks, from, values);
}

// Sends a pulse of the given width (standard deviation) down from the upper block and returns the largest displacement
// that is left above the tie when the pulse is in the lower block, over the pulse's height.
double reflected(double slaveSize, double masterSize, double width) {
  Joined j = join(slaveSize, masterSize);
  AlignedVector workspace(tieWorkspace(j.ties[0]));
  transfer(j, j.mass);
  const double nu = steel.poisson;
  const double speed = std::sqrt(steel.young * (1 - nu) / ((1 + nu) * (1 - 2 * nu) * steel.density));
  const double centre = 0.4, step = 0.5 * std::min(slaveSize, masterSize) / speed;
  const auto pulse = [&](double z) { return std::exp(-0.5 * std::pow((z - centre) / width, 2)); };
  AlignedVector u(j.size, 0.0), v(j.size, 0.0);
  for (const auto& block : j.blocks) {
    setField(
        block, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(0, 0, pulse(p[2])); }, u);
    // Half a step before; running downwards: u(z + c t), v = c u'.
    setField(
        block,
        [&](const Eigen::Vector3d& p) {
          const double z = p[2] - speed * step / 2;
          return Eigen::Vector3d(0, 0, -speed * (z - centre) / (width * width) * pulse(z));
        },
        v);
  }
  const int steps = static_cast<int>(2 * centre / speed / step);
  for (int k = 0; k < steps; ++k) {
    interpolateSlaves(j.ties[0], j.blocks, u.data(), workspace.data());
    AlignedVector force = applySwept(j.blocks, u, "");
    transfer(j, force);
    for (const auto& block : j.blocks)
      for (int n = 0; n < block.nodes; ++n)
        for (int s = 0; s < block.stationCount; ++s) {
          const std::size_t i = block.index(n, 2, s);
          v[i] -= step * force[i] / j.mass[i];
          u[i] += step * v[i];
        }
  }
  const auto& upper = j.blocks[0];
  double maximum = 0, passed = 0;
  for (int n = 0; n < upper.nodes; ++n)
    if (upper.section.nodes[n][1] > 0.05)
      for (int s = 0; s < upper.stationCount; ++s) maximum = std::max(maximum, std::abs(u[upper.index(n, 2, s)]));
  for (int n = 0; n < j.blocks[1].nodes; ++n)
    for (int s = 0; s < j.blocks[1].stationCount; ++s) passed = std::max(passed, u[j.blocks[1].index(n, 2, s)]);
  EXPECT_NEAR(passed, 1, 0.05) << "the pulse has gone through";
  return maximum;
}

// A Gaussian of standard deviation s holds wavelengths from about 2 pi s / 2 upwards (two standard deviations of its
// spectrum, 1/s): ten coarse elements are 100 mm, s = 32 mm.
TEST(TieReflection, StaysBelowTwoPercentFromFineToCoarse) {
  const double share = reflected(fineSize, coarseSize, 0.032);
  EXPECT_LT(share, 0.02);
  verification::seen("reflected", 100 * share, "%");
}

// The measure itself: without a change of mesh nothing comes back but the pulse's own tail and the dispersion of the
// mesh.
TEST(TieReflection, VanishesBetweenEqualMeshes) { EXPECT_LT(reflected(coarseSize, coarseSize, 0.05), 0.005); }

}  // namespace
}  // namespace squat::elasticity

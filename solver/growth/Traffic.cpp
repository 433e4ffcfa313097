#include "growth/Traffic.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace squat::growth {

namespace {

// Means of equally likely strata of the standard normal distribution, scaled to variance 1; 0 for a single one.
std::vector<double> strata(int count) {
  const auto density = [count](int edge) {
    if (edge == 0 || edge == count) return 0.0;
    const double z = std::numbers::sqrt2 * boost::math::erf_inv(2.0 * edge / count - 1);
    return std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
  };
  std::vector<double> means;
  double squares = 0;
  for (int i = 0; i < count; ++i) {
    means.push_back(count * (density(i) - density(i + 1)));
    squares += means.back() * means.back() / count;
  }
  for (double& mean : means) mean = squares > 0 ? mean / std::sqrt(squares) : 0;
  return means;
}

std::vector<double> shuffled(std::vector<double> values, std::mt19937_64& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random() % i]);
  return values;
}

}  // namespace

std::vector<Draw> drawTraffic(const scenario::Growth& growth) {
  const auto normal = strata(growth.wheelsets);
  std::mt19937_64 random(static_cast<std::uint64_t>(growth.seed));
  const auto lateral = shuffled(normal, random), load = shuffled(normal, random), speed = shuffled(normal, random),
             traction = shuffled(normal, random);
  std::vector<Draw> draws;
  for (std::size_t i = 0; i < normal.size(); ++i)
    draws.push_back({growth.lateralScatter * lateral[i], 1 + growth.loadScatter * load[i],
                     1 + growth.speedScatter * speed[i], growth.traction + growth.tractionScatter * traction[i]});
  return draws;
}

cases::CaseDescription withDraw(cases::CaseDescription c, const Draw& draw) {
  c.suspension.sprungMass *= draw.load;
  c.motion.lateralOffset += draw.lateral;
  c.motion.speed *= draw.speed;
  c.motion.angularVelocity *= draw.speed;
  c.motion.torque = 0, c.motion.tractionCoefficient = draw.traction;
  return c;
}

double axleMass(const cases::CaseDescription& c) { return 2 * (c.suspension.sprungMass + c.wheelset.totalMass); }

}  // namespace squat::growth

#include "estimation/ProfileBounds.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/DenseAlgebra.h"
#include "scenario/DefectSurface.h"

namespace squat::estimation {

namespace {

constexpr double ofNinety = 1.645;  // standard deviations on either side of 90 % of a normal distribution

Eigen::VectorXd heightsIn(const SmoothProfile& profile, const LinearSolution& solution) {
  return solution.unknowns.head(profile.unknowns());
}

Eigen::MatrixXd covarianceIn(const SmoothProfile& profile, const LinearSolution& solution) {
  return solution.covariance.topLeftCorner(profile.unknowns(), profile.unknowns());
}

// Whether a rigid wheel touches each sample: its path there is no higher than the profile.
std::vector<bool> touchedBy(double radius, const ProfilePoints& points) {
  constexpr double untouched = 2e-6;  // [m] that contact flattens without notice
  std::vector<bool> touched(points.size(), false);
  const auto reach = static_cast<long>(std::ceil(0.06 / SmoothProfile::sampleStep));
  const auto count = static_cast<long>(points.size());
  // A wheel whose centre stands above x has its lowest gap at some sample; it touches all samples next to that gap.
  for (long centre = -reach; centre < count + reach; ++centre) {
    const double x = points.front().position + static_cast<double>(centre) * SmoothProfile::sampleStep;
    double highest = -1;
    const auto heightAt = [&](long i) {
      const double s = points[static_cast<std::size_t>(i)].position - x;
      return points[static_cast<std::size_t>(i)].height - (radius - std::sqrt(radius * radius - s * s));
    };
    const long from = std::max(0L, centre - reach), to = std::min(count - 1, centre + reach);
    for (long i = from; i <= to; ++i) highest = std::max(highest, heightAt(i));
    for (long i = from; i <= to; ++i)
      if (heightAt(i) > highest - untouched) touched[static_cast<std::size_t>(i)] = true;
  }
  return touched;
}

}  // namespace

double depthOf(const Eigen::VectorXd& samples) { return std::max(0.0, -samples.minCoeff()); }

double lengthOf(const Eigen::VectorXd& samples, const std::vector<double>& positions) {
  Eigen::Index lowest = 0;
  const double edge = 0.05 * samples.minCoeff(&lowest);
  if (!(edge < 0)) return 0;
  Eigen::Index from = lowest, to = lowest;
  while (from > 0 && samples[from] < edge) --from;
  while (to + 1 < samples.size() && samples[to] < edge) ++to;
  return positions[static_cast<std::size_t>(to)] - positions[static_cast<std::size_t>(from)];
}

std::vector<ProfileSample> profileWithBounds(const SmoothProfile& profile, const LinearSolution& solution,
                                             double radius) {
  const auto points = profile.points(heightsIn(profile, solution));
  const Eigen::MatrixXd spread = profile.basis() * covarianceIn(profile, solution) * profile.basis().transpose();
  const auto touched = touchedBy(radius, points);
  const auto deepest =
      std::min_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.height < b.height; });
  std::vector<ProfileSample> samples;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double half = ofNinety * std::sqrt(std::max(0.0, spread(k, k)));
    samples.push_back({points[i].position - deepest->position, points[i].height, points[i].height - half,
                       points[i].height + half, touched[i]});
  }
  return samples;
}

Extent extentOf(const SmoothProfile& profile, const LinearSolution& solution) {
  constexpr int draws = 2000;
  constexpr unsigned seed = 1;
  const Eigen::VectorXd mean = heightsIn(profile, solution);
  const Eigen::MatrixXd root = algebra::PositiveFactor(covarianceIn(profile, solution)).lower();
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> depths, lengths;
  for (int i = 0; i < draws; ++i) {
    Eigen::VectorXd drawn(mean.size());
    for (Eigen::Index k = 0; k < drawn.size(); ++k) drawn[k] = normal(random);
    const Eigen::VectorXd samples = profile.basis() * (mean + root * drawn);
    depths.push_back(depthOf(samples)), lengths.push_back(lengthOf(samples, profile.positions()));
  }
  const auto interval = [](std::vector<double> values, double own) {
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) { return values[static_cast<std::size_t>(share * (draws - 1))]; };
    return Interval{own, std::min(own, at(0.05)), std::max(own, at(0.95))};
  };
  const Eigen::VectorXd own = profile.basis() * mean;
  return {interval(depths, depthOf(own)), interval(lengths, lengthOf(own, profile.positions()))};
}

}  // namespace squat::estimation

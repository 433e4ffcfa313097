#include "detection/SizeModel.h"

#include <algorithm>
#include <cmath>

#include "core/DenseAlgebra.h"

namespace squat::detection {
namespace {

constexpr std::ptrdiff_t minimumVehicles = 8;
constexpr double ridge = 0.3;      // of the sum of squares: from 0.03 to 3 the answers differ by less than a hundredth
constexpr double usualSpeed = 28;  // [m/s]
constexpr double minimumVariance = 1e-3;  // of log10 energy between vehicles, so that the covariance has an inverse

double logEnergy(double energy) { return std::log10(std::max(energy, 1e-12)); }

std::vector<SquatForm> possibleForms(const Example& example) {
  using enum scenario::DefectShape;
  if (example.form.shape != none) return {example.form};
  // The middle of the ranges of exampleSquats().
  return {{cosine}, {wshape, 0.3}, {dipWithWave, 0, 0.03, 0.25 * example.depth, 2}};
}

struct Table {
  std::vector<std::string> vehicles;
  std::vector<Eigen::Index> vehicle;  // of each row
  Eigen::VectorXd speed, counts;      // of each vehicle, means: of the logarithm by usualSpeed, of the weight
  Eigen::VectorXd weight;             // of each row
  Eigen::MatrixXd path, measured;     // a row for each squat
};

Table tableOf(const std::vector<Example>& examples) {
  Table table;
  const auto count = std::count_if(examples.begin(), examples.end(), hasSize);
  table.path.resize(count, eigenBands), table.measured.resize(count, eigenBands), table.weight.resize(count);
  std::vector<double> speeds, weights, squats;
  Eigen::Index row = 0;
  for (const auto& example : examples) {
    if (!hasSize(example)) continue;
    const auto found = std::find(table.vehicles.begin(), table.vehicles.end(), example.vehicle);
    const auto vehicle = static_cast<std::size_t>(found - table.vehicles.begin());
    if (found == table.vehicles.end()) {
      table.vehicles.push_back(example.vehicle);
      speeds.push_back(0), weights.push_back(0), squats.push_back(0);
    }
    const double weight = std::max(example.weight, leastWeight);
    speeds[vehicle] += std::log(example.speed / usualSpeed), weights[vehicle] += weight, squats[vehicle] += 1;
    table.weight[row] = weight;
    table.vehicle.push_back(static_cast<Eigen::Index>(vehicle));
    table.path.row(row) = pathEnergies(example);
    table.measured.row(row) = measuredEnergies(example);
    ++row;
  }
  const auto vehicles = static_cast<Eigen::Index>(speeds.size());
  table.speed.resize(vehicles), table.counts.resize(vehicles);
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    const auto at = static_cast<Eigen::Index>(v);
    table.speed[at] = speeds[v] / squats[v], table.counts[at] = weights[v] / squats[v];
  }
  return table;
}

// Weighted mean of the products of what a fit of so many numbers has left, for the rows that the numbers leave free.
BandMatrix covariance(const Eigen::MatrixXd& left, const Eigen::VectorXd& weight, Eigen::Index fitted) {
  const double rows = static_cast<double>(left.rows());
  const double free = static_cast<double>(std::max<Eigen::Index>(1, left.rows() - fitted)) / rows;
  return left.transpose() * weight.asDiagonal() * left / (weight.sum() * free);
}

}  // namespace

bool hasSize(const Example& example) {
  // Several squats as one profile: the size of the deepest does not give their path.
  if (example.form.shape == scenario::DefectShape::profile) return false;
  return example.kind == Kind::squat && example.length > 0 && example.depth > 0;
}

BandValues pathEnergies(const PathSpectrum& path, double speed) {
  BandValues values;
  for (std::size_t b = 0; b < bandCount; ++b) {
    const auto& band = detectionBands()[b];
    // 1e-9: a floor for paths without waves of this length.
    values[static_cast<Eigen::Index>(b)] = std::log10(path.energy(speed, band.low, band.high) / (speed * speed) + 1e-9);
  }
  return values;
}

BandValues pathEnergies(const Example& example) {
  BandValues sum = BandValues::Zero();
  const auto forms = possibleForms(example);
  for (const auto& form : forms) {
    scenario::Defect defect;
    defect.shape = form.shape, defect.length = example.length, defect.depth = example.depth;
    defect.middleHeight = form.middleHeight;
    defect.waveLength = form.waveLength, defect.waveDepth = form.waveDepth, defect.waveCount = form.waveCount;
    sum += pathEnergies(PathSpectrum(defect), example.speed);
  }
  return sum / static_cast<double>(forms.size());
}

BandValues measuredEnergies(const Example& example) {
  BandValues values;
  for (std::size_t b = 0; b < bandCount; ++b)
    values[static_cast<Eigen::Index>(b)] = logEnergy(example.energy[b] / (example.speed * example.speed));
  return values;
}

SizeModel::SizeModel(const std::vector<Example>& examples) {
  const Table table = tableOf(examples);
  const Eigen::Index rows = table.path.rows(), vehicles = table.speed.size();
  if (vehicles < minimumVehicles) return;
  Eigen::MatrixXd offsets(vehicles, eigenBands), left(rows, eigenBands);
  for (Eigen::Index b = 0; b < eigenBands; ++b) {
    const Eigen::Index first = std::max<Eigen::Index>(0, b - 1), inputs = std::min(eigenBands, b + 2) - first;
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(rows, inputs + vehicles);
    x.leftCols(inputs) = table.path.middleCols(first, inputs);
    for (Eigen::Index i = 0; i < rows; ++i) x(i, inputs + table.vehicle[static_cast<std::size_t>(i)]) = 1;
    const Eigen::MatrixXd weighted = table.weight.asDiagonal() * x;
    Eigen::MatrixXd normal = weighted.transpose() * x;
    normal.diagonal().head(inputs).array() += ridge;
    const Eigen::VectorXd fitted =
        algebra::solveSymmetric(normal, Eigen::VectorXd(weighted.transpose() * table.measured.col(b)));
    slopes_.block(b, first, 1, inputs) = fitted.head(inputs).transpose();
    offsets.col(b) = fitted.tail(vehicles);
    left.col(b) = table.measured.col(b) - x * fitted;
  }
  // Three slopes a band and an offset a vehicle are fitted.
  betweenPassages_ = covariance(left, table.weight, vehicles + 3);
  Eigen::MatrixXd line(vehicles, 2);
  line.col(0).setOnes();
  line.col(1) = table.speed;
  const Eigen::MatrixXd weighted = table.counts.asDiagonal() * line;
  const Eigen::MatrixXd fitted =
      algebra::solveSymmetric(weighted.transpose() * line, Eigen::MatrixXd(weighted.transpose() * offsets));
  mean_ = fitted.row(0).transpose(), trend_ = fitted.row(1).transpose();
  const Eigen::MatrixXd apart = offsets - line * fitted;
  betweenVehicles_ = covariance(apart, table.counts, 2);
  betweenVehicles_.diagonal().array() += minimumVariance;
  for (Eigen::Index v = 0; v < vehicles; ++v)
    deviations_[table.vehicles[static_cast<std::size_t>(v)]] = apart.row(v).transpose();
  known_ = true;
}

const BandValues* SizeModel::deviation(const std::string& vehicle) const {
  const auto found = deviations_.find(vehicle);
  return found == deviations_.end() ? nullptr : &found->second;
}

BandValues SizeModel::expected(const BandValues& path, double speed) const {
  return slopes_ * path + mean_ + trend_ * std::log(speed / usualSpeed);
}

}  // namespace squat::detection

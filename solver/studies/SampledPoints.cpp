#include "studies/SampledPoints.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <charconv>
#include <map>
#include <optional>
#include <random>
#include <utility>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "studies/InputRange.h"
#include "text/Cells.h"

namespace squat::studies {
namespace {

constexpr std::size_t kLargestPoints = std::size_t{64} << 20;
constexpr double kTwoTo32 = 4294967296.0;

// From 0 up to, not including, `limit`; the standard library's distributions differ from one to the next.
std::size_t below(std::size_t limit, std::mt19937_64& random) {
  return static_cast<std::size_t>(static_cast<double>(random() >> 11) / 9007199254740992.0 *
                                  static_cast<double>(limit));
}

struct Sample {
  bool isSobol = true;
  std::size_t count = 0;
};

Sample sampleFromText(const std::string& text) {
  const auto colon = text.find(':');
  const auto method = text.substr(0, colon);
  const auto number = colon == std::string::npos ? std::string() : text.substr(colon + 1);
  Sample sample{method == "sobol", 0};
  const auto* last = number.data() + number.size();
  const auto [end, error] = std::from_chars(number.data(), last, sample.count);
  if ((method != "sobol" && method != "latin-hypercube") || error != std::errc() || end != last || sample.count < 2 ||
      sample.count > kMaximumPoints)
    throw CaseError({{"--sample", "'" + text + "'", "sobol:N or latin-hypercube:N, N from 2 to 10000",
                      "Example: --sample sobol:256 --vary defect.length=20:60 --vary pad.stiffness=200:2000"}});
  return sample;
}

void refuseTwins(const std::string& path, const std::vector<std::vector<std::string>>& records,
                 const std::vector<std::size_t>& lines) {
  std::map<std::vector<std::string>, std::size_t> seen;
  for (std::size_t r = 1; r < records.size(); ++r)
    if (const auto [earlier, isNew] = seen.try_emplace(records[r], lines[r]); !isNew)
      throw FileError(path, "line " + std::to_string(lines[r]),
                      "holds the point of line " + std::to_string(earlier->second),
                      "Remove one of them: each point is computed once");
}

}  // namespace

std::vector<std::vector<double>> sobolPoints(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  boost::random::sobol_engine<std::uint32_t, 32> engine(dimensions);
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> shift(dimensions);
  for (auto& digits : shift) digits = static_cast<std::uint32_t>(random() >> 32);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t d = 0; d < dimensions; ++d) {
      // The engine leaves out its first point, the corner at 0, without which the intervals are not filled evenly.
      const std::uint32_t digits = i == 0 ? 0 : engine();
      points[i][d] = ((digits ^ shift[d]) + 0.5) / kTwoTo32;
    }
  return points;
}

std::vector<std::vector<double>> latinHypercubePoints(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  std::vector<std::size_t> interval(count);
  for (std::size_t d = 0; d < dimensions; ++d) {
    for (std::size_t i = 0; i < count; ++i) interval[i] = i;
    for (std::size_t i = count; i > 1; --i) std::swap(interval[i - 1], interval[below(i, random)]);
    for (std::size_t i = 0; i < count; ++i) {
      const double place = static_cast<double>(random() >> 11) / 9007199254740992.0;
      points[i][d] = (static_cast<double>(interval[i]) + place) / static_cast<double>(count);
    }
  }
  return points;
}

std::vector<Variation> sampledVariations(const std::vector<std::string>& ranges, const std::string& sample,
                                         std::uint64_t seed) {
  const auto wanted = sampleFromText(sample);
  const auto inputs = inputRangesFromText(ranges, "--vary");
  const auto points = wanted.isSobol ? sobolPoints(wanted.count, inputs.size(), seed)
                                     : latinHypercubePoints(wanted.count, inputs.size(), seed);
  std::vector<Variation> variations;
  for (std::size_t d = 0; d < inputs.size(); ++d) {
    variations.push_back({inputs[d].key(), {}});
    for (const auto& point : points)
      variations.back().values.push_back(withoutRounding(inputs[d].low + point[d] * (inputs[d].high - inputs[d].low)));
  }
  return variations;
}

std::vector<Variation> variationsFromFile(const std::string& path) {
  const auto [records, lines] = text::readCells(path, kLargestPoints);
  if (records.size() < 2)
    throw FileError(path, "", "holds no points", "Keys in the first line, a point in each other one");
  if (records.size() - 1 > kMaximumPoints) throw FileError(path, "", "holds more than 10000 points", "Divide it");
  std::vector<Variation> variations;
  for (const auto& key : records[0]) variations.push_back({key, {}});
  for (std::size_t r = 1; r < records.size(); ++r) {
    if (records[r].size() != variations.size())
      throw FileError(path, "line " + std::to_string(lines[r]), "has " + std::to_string(records[r].size()) + " values",
                      "One for each of the " + std::to_string(variations.size()) + " keys of the first line");
    for (std::size_t v = 0; v < variations.size(); ++v) variations[v].values.push_back(records[r][v]);
  }
  refuseTwins(path, records, lines);
  return variations;
}

}  // namespace squat::studies

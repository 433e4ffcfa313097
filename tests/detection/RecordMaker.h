// tests/detection/RecordMaker.h - records with impacts of known place.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "detection/Segments.h"
#include "records/RecordStream.h"

namespace squat::detection {

inline std::vector<double> normalNoise(std::size_t count, double sigma, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal(0, sigma);
  std::vector<double> values(count);
  for (auto& value : values) value = normal(engine);
  return values;
}

// Two decaying tones that begin at `time`: what an impact leaves at 300 and 1000 Hz.
inline void addImpact(std::vector<double>& values, double rate, double time, double amplitude) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double t = static_cast<double>(i) / rate - time;
    if (t < 0 || t > 0.1) continue;
    values[i] += amplitude * (std::exp(-t / 8e-3) * std::sin(2 * std::numbers::pi * 300 * t) +
                              std::exp(-t / 4e-3) * std::sin(2 * std::numbers::pi * 1000 * t));
  }
}

// A stream over values in memory, at constant speed, in blocks of any length.
class MemoryStream : public records::RecordStream {
 public:
  MemoryStream(std::vector<double> values, double rate, double speed, std::size_t block)
      : values_(std::move(values)), speed_(speed), block_(block) {
    layout_.path = "memory";
    layout_.rate = rate;
    layout_.channels = {{"aba", "m/s2"}};
  }
  const records::RecordLayout& layout() const override { return layout_; }
  double fraction() const override { return static_cast<double>(at_) / static_cast<double>(values_.size()); }
  const std::vector<records::RecordFault>& faults() const override { return faults_; }
  bool next(records::RecordBlock& block) override {
    if (at_ >= values_.size()) return false;
    const std::size_t end = std::min(values_.size(), at_ + block_);
    block = {};
    block.first = at_, block.time = static_cast<double>(at_) / layout_.rate, block.follows = at_ > 0;
    block.values.emplace_back(values_.begin() + static_cast<std::ptrdiff_t>(at_),
                              values_.begin() + static_cast<std::ptrdiff_t>(end));
    for (; at_ < end; ++at_) {
      block.position.push_back(speed_ * static_cast<double>(at_) / layout_.rate);
      block.speed.push_back(speed_);
    }
    return true;
  }

 private:
  std::vector<double> values_;
  double speed_;
  std::size_t block_, at_ = 0;
  records::RecordLayout layout_;
  std::vector<records::RecordFault> faults_;
};

}  // namespace squat::detection

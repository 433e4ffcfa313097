// solver/roughness/RecordRoughness.h - from records to the gauge: whole signals, and streams as they go by.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "records/RecordStream.h"
#include "roughness/RoughnessGauge.h"
#include "signals/Alignment.h"

namespace squat::roughness {

// Of a signal with its positions (readers::passageWithPositions). Throws CaseError where it is no acceleration.
RecordRoughness roughnessOf(const signals::Passage& passage, const TransferFunction& transfer,
                            const GaugeOptions& options);

// Speed [m/s] at each of equally spaced samples, smoothed over a twentieth of a second each way.
std::vector<double> speedsOf(const std::vector<double>& position, double rate);

// Hands a stream on as it is, and measures each of its channels on the way.
class GaugedStream : public records::RecordStream {
 public:
  // The transfer function must outlive the stream.
  GaugedStream(std::unique_ptr<records::RecordStream> stream, const TransferFunction& transfer,
               const GaugeOptions& options);

  const records::RecordLayout& layout() const override { return stream_->layout(); }
  bool next(records::RecordBlock& block) override;
  double fraction() const override { return stream_->fraction(); }
  const std::vector<records::RecordFault>& faults() const override { return stream_->faults(); }

  // Of the channels in their order, once the stream has ended; each with its name.
  std::vector<std::pair<std::string, RecordRoughness>> finish();

 private:
  std::unique_ptr<records::RecordStream> stream_;
  const TransferFunction& transfer_;
  GaugeOptions options_;
  std::vector<RoughnessGauge> gauges_;
};

}  // namespace squat::roughness

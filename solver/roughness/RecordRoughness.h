// solver/roughness/RecordRoughness.h - from records to the meter: whole signals, and streams as they go by.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "records/RecordStream.h"
#include "roughness/RoughnessMeter.h"
#include "signals/Alignment.h"

namespace squat::roughness {

// Of a signal with its positions (readers::passageWithPositions). Throws CaseError where it is no acceleration.
RecordRoughness roughnessOf(const signals::Passage& passage, const TransferFunction& transfer,
                            const MeterOptions& options);

// Speed [m/s] at each of equally spaced samples, smoothed over a twentieth of a second each way.
std::vector<double> speedsOf(const std::vector<double>& position, double rate);

// Hands a stream on as it is, and measures each of its channels on the way.
class MeteredStream : public records::RecordStream {
 public:
  // The transfer function must outlive the stream.
  MeteredStream(std::unique_ptr<records::RecordStream> stream, const TransferFunction& transfer,
                const MeterOptions& options);

  const records::RecordLayout& layout() const override { return stream_->layout(); }
  bool next(records::RecordBlock& block) override;
  double fraction() const override { return stream_->fraction(); }
  const std::vector<records::RecordFault>& faults() const override { return stream_->faults(); }

  // Of the channels in their order, once the stream has ended; each with its name.
  std::vector<std::pair<std::string, RecordRoughness>> finish();

 private:
  std::unique_ptr<records::RecordStream> stream_;
  const TransferFunction& transfer_;
  MeterOptions options_;
  std::vector<RoughnessMeter> meters_;
};

}  // namespace squat::roughness

// solver/records/Overview.h - the extremes of each short stretch of a long record, for a strip at any zoom.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "records/RecordStream.h"

namespace squat::records {

// Lowest and highest value [unit of the channel] at rising positions [m].
struct Envelope {
  std::vector<double> position, low, high;
};

// Filled by the thread that reads, looked at by another: every call takes the lock. Eight bytes a channel and stretch,
// 8 MB for 100 km of one channel.
class Overview {
 public:
  static constexpr double stretch = 0.1;              // [m]
  static constexpr std::size_t maximum = 20'000'000;  // stretches; what lies beyond is left out

  void add(const RecordLayout& layout, const RecordBlock& block);
  std::vector<RecordChannel> channels() const;
  std::pair<double, double> extent() const;  // [m]; equal: nothing yet
  // At most about `points` positions between `from` and `to`: each the extremes of several stretches where these are
  // more. Stretches without a sample are left out.
  Envelope envelope(std::size_t channel, double from, double to, std::size_t points) const;

 private:
  struct Extreme {
    float low = 1, high = -1;  // low > high: no sample
  };
  // Stretches from `first_` on upwards and downwards, so that chainage may rise or fall.
  struct Side {
    std::vector<Extreme> up, down;
    Extreme* at(long index);
    const Extreme* find(long index) const;
  };

  mutable std::mutex mutex_;
  std::vector<RecordChannel> channels_;
  std::vector<Side> sides_;
  long first_ = 0, lowest_ = 0, highest_ = -1;  // numbers of stretches
  bool begun_ = false;
};

// Hands on what another stream reads, and keeps its extremes.
class OverviewedStream : public RecordStream {
 public:
  OverviewedStream(std::unique_ptr<RecordStream> stream, std::shared_ptr<Overview> overview)
      : stream_(std::move(stream)), overview_(std::move(overview)) {}

  const RecordLayout& layout() const override { return stream_->layout(); }
  bool next(RecordBlock& block) override;
  double fraction() const override { return stream_->fraction(); }
  const std::vector<RecordFault>& faults() const override { return stream_->faults(); }

 private:
  std::unique_ptr<RecordStream> stream_;
  std::shared_ptr<Overview> overview_;
};

}  // namespace squat::records

// solver/records/SignalFaults.h - what is wrong in the signal itself: spikes, saturation, dead channels.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "records/FaultList.h"
#include "records/RecordStream.h"

namespace squat::records {

// A record whose channels are looked through, block by block:
// - Spike: one to three samples that stand out from the eight on each side by a factor of five, and from the block by
//   twenty times its robust deviation. An axle box rings for longer, whatever hits the wheel. A straight line replaces
//   it. A spike of several samples that the end of a block divides is not found.
// - Saturation: eight samples and more of a block at its largest or smallest value, in runs of three and more, at least
//   ten robust deviations from its median. The samples stay.
// - Dead channel: the same value for half a second and more while the train moves. The samples stay.
class CheckedRecord : public RecordStream {
 public:
  explicit CheckedRecord(std::unique_ptr<RecordStream> source);

  const RecordLayout& layout() const override { return source_->layout(); }
  bool next(RecordBlock& block) override;
  double fraction() const override { return source_->fraction(); }
  const std::vector<RecordFault>& faults() const override { return all_; }

 private:
  struct Channel {
    std::vector<double> before;  // the last samples of the block before, as they came
    double last = 0;
    std::size_t same = 0;       // samples in a row that have the value `last`
    std::size_t deadFault = 0;  // index of the fault that continues
    bool isDead = false;
  };

  void mendSpikes(RecordBlock& block, std::size_t channel, double median, double enough);
  void findSaturation(const RecordBlock& block, std::size_t channel, double median, double deviation);
  void findDead(const RecordBlock& block, std::size_t channel);
  RecordFault faultAt(FaultKind kind, const RecordBlock& block, std::size_t from, std::size_t to,
                      std::size_t channel) const;

  std::unique_ptr<RecordStream> source_;
  RecordBlock ahead_;  // read before it is asked for: a spike is known by what follows
  bool hasAhead_ = false;
  std::vector<Channel> channels_;
  FaultList found_;
  std::vector<RecordFault> all_;
};

}  // namespace squat::records

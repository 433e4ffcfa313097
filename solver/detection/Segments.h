// solver/detection/Segments.h - a record of any length as overlapping stretches that fit into memory.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "records/RecordStream.h"
#include "signals/TimeSeries.h"

namespace squat::detection {

// Stretches slower than this are passed over: a wheel that barely moves excites nothing that can be judged.
inline constexpr double minimumSpeed = 3;  // [m/s]

// A stretch of a record at the reduced rate of the detection, with what it shares with its neighbours at both ends.
struct Segment {
  std::vector<signals::TimeSeries> channels;
  std::vector<double> position;             // [m] at each sample, as in the file
  std::vector<double> speed;                // [m/s]
  std::vector<double> latitude, longitude;  // [deg]; empty where there are none
  double coreStart = 0, coreEnd = 0;        // [s] events in [coreStart, coreEnd) belong to this segment
};

// Cuts the blocks of a stream. Channels are low-passed and decimated to the lowest rate that shows 2 kHz.
class SegmentCutter {
 public:
  SegmentCutter(const records::RecordLayout& layout, std::size_t coreSamples = std::size_t{1} << 19,
                double marginMetres = 60);

  // Takes a block; returns the segments that are complete with it.
  std::vector<Segment> push(const records::RecordBlock& block);
  // What is left at the end of the record.
  std::vector<Segment> finish();

  double rate() const;  // [Hz] of the segments

 private:
  std::size_t marginSamples() const;
  void append(const records::RecordBlock& block);
  Segment cut(std::size_t end, bool isLast);
  void drop(std::size_t samples);
  std::vector<Segment> flush();

  double step_;  // [s] of the record
  std::size_t factor_, core_;
  double margin_;
  std::vector<std::string> names_, units_;
  double start_ = 0;      // [s] of the first sample that is kept
  std::size_t kept_ = 0;  // samples ahead of the core that came with the segment before
  std::vector<std::vector<double>> values_;
  std::vector<double> position_, speed_, latitude_, longitude_;
};

}  // namespace squat::detection

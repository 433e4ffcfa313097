// solver/records/RecordStream.h - a long record of axle box acceleration, read block by block: memory does not grow
// with its length.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "readers/SignalFile.h"

namespace squat::records {

struct RecordOptions {
  readers::SignalFileOptions columns;  // as for short signals; `column` may name several channels or "all"
  bool everyAcceleration =
      false;  // where `column` names none: every column that may hold one, not only the one named aba
  std::optional<double> chainage;                  // [m] of the first sample, where the file has no positions
  std::size_t blockLength = std::size_t{1} << 18;  // [samples] at most
};

struct RecordChannel {
  std::string name, unit;  // acceleration in m/s2, whatever the file has
};

struct RecordLayout {
  std::string path;                // the first file of a ride in several
  std::vector<std::string> files;  // that it was read from; known at the end
  std::vector<RecordChannel> channels;
  double rate = 0;              // [Hz]
  std::size_t samples = 0;      // a channel; 0: not known before the end (text)
  bool hasPosition = false;     // from a column of the file; else from the speed
  bool falling = false;         // the chainage falls along the run
  bool hasCoordinates = false;  // latitude and longitude
  std::vector<std::string> notes;
};

// Consecutive samples; every row of `values` is one channel. SI units.
struct RecordBlock {
  std::size_t first = 0;  // index of its first sample in the file
  double time = 0;        // [s] of its first sample
  bool follows = false;   // on the block before without a gap; else a new stretch begins
  std::vector<std::vector<double>> values;
  std::vector<double> position;  // [m] at each sample, the file's chainage (falling where the layout says so)
  std::vector<double> speed;     // [m/s] at each sample
  std::vector<double> latitude, longitude;  // [deg] at each sample; empty where there are none

  std::size_t size() const { return position.size(); }
};

enum class FaultKind { gap, notANumber, spike, saturation, deadChannel, rateChange, positionJump, truncated, unit };

// A stretch of a record that is not analysed, or only with a reservation.
struct RecordFault {
  FaultKind kind = FaultKind::gap;
  std::size_t first = 0, end = 0;  // samples [first, end)
  double time = 0, position = 0;   // [s], [m] where it begins
  int channel = -1;                // -1: all
  std::string text, advice;        // what is wrong; what to do
};

class RecordStream {
 public:
  virtual ~RecordStream() = default;
  virtual const RecordLayout& layout() const = 0;
  virtual bool next(RecordBlock& block) = 0;  // false: the end
  virtual double fraction() const = 0;        // of the file that has been read, 0..1
  // Found so far: of the file (gaps, rows that are no numbers, changes of rate, a truncated end) and of the signal
  // (spikes, saturation, dead channels: records/SignalFaults.h).
  virtual const std::vector<RecordFault>& faults() const = 0;
};

// Whether files named together are parts of one ride, or passes over the same track.
enum class Together {
  asTheyFollow,  // a file belongs to the ride of the one before where its times or positions follow on
  consecutive,
  passes
};

// Text, HDF5 and MATLAB files, by what they hold. Throws FileError for a file that holds no record, CaseError
// for options that do not fit, and where neither speed nor position is known.
std::unique_ptr<RecordStream> openRecord(const std::string& path, const RecordOptions& options = {});

// The ride that begins with the first file, through those behind it that belong to it: layout().files says at the end
// how many did. Throws as above; FileError too for files that are stated, or named, as consecutive but have other
// columns or units, and for consecutive ones that are not in order; CaseError, which asks what they are, where only
// their names are consecutive (part-1, part-2).
std::unique_ptr<RecordStream> openRide(std::vector<std::string> files, const RecordOptions& options, Together together);

// Files whose names differ in one number alone in the order of that number, part-2 before part-10; others as they are.
std::vector<std::string> inNumberOrder(std::vector<std::string> files);

}  // namespace squat::records

// widgets/studio/runs/MeasuredLook.h - a measured file read as it is chosen, before it is taken.
#pragma once

#include <string>
#include <vector>

#include "project/MeasuredRecords.h"
#include "studio/runs/MeasuredHead.h"

namespace squat::studio {

struct MeasuredChoice {
  std::string path;
  project::MeasuredReading reading;
  double speed = 0;                         // [m/s] where neither file nor options give one
  std::string run = {};                     // of the record that is read again, alone; empty: all that are chosen
  project::RecordPointer beside = nullptr;  // the run that they are to match; null: laid as `reading` says
};

// A curve with the extremes of short stretches, no matter how many samples it has.
struct PreviewCurve {
  std::vector<double> position, value;  // [m], [m/s²]
};

struct MeasuredLook {
  std::vector<project::MeasuredRecord> records;  // empty where there is a problem
  std::vector<PreviewCurve> curves;              // of the first few of them
  std::vector<std::vector<std::string>> rows;    // the first ones, where the head has none
  std::string problem;                           // why it cannot be read so
};

// Reads the whole file, which takes as long as it is large; for any thread.
MeasuredLook lookAt(const MeasuredChoice& choice, const MeasuredHead& head);

// At most about twice so many points as `stretches`: the lowest and the highest value of each, in their order.
PreviewCurve thinned(const std::vector<double>& position, const std::vector<double>& value, std::size_t stretches);

}  // namespace squat::studio

// solver/project/MeasuredRecords.h - measured signals, ready to be laid over a run.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "readers/SignalFile.h"

namespace squat::project {

using RecordPointer = std::shared_ptr<const signals::Record>;

inline constexpr double minimumGain = 0.001, maximumGain = 1000;

// How a measured signal is read again, and laid where it was.
struct MeasuredReading {
  readers::SignalFileOptions options;  // with the speed that was used
  double impact = 0;                   // [m] where its largest value is put
  double gain = 1;                     // what the values of the file are multiplied by
  bool isAutomatic = false;            // laid beside the run that is shown, not where the user put it
};

// Its name where it stands beside others: "run 1 × 1.1" with a gain that is not one.
std::string nameWithGain(const std::string& name, const MeasuredReading& reading);

struct MeasuredRecord {
  RecordPointer record;
  MeasuredReading reading;
};

// Position of the largest filtered acceleration of a run; 0 without one: at the defect.
double impactOf(const signals::Record* run);

// Reads measured axle box accelerations, one or more runs, with their filtered partners (2 kHz, SignalCatalogue.h), and
// puts the largest value of each at `reading.impact`. Given a run, `beside`, it puts each where it matches the run
// (matchBeside) and says so in the notes; the largest values of the two may be different peaks of one passage. Only 5 m
// on both sides of the largest value are kept. Where neither file nor options give a speed, `speed` [m/s] links time
// and position. Throws FileError, also for signals that are no accelerations.
std::vector<MeasuredRecord> measuredRecords(const std::string& path, double speed, const MeasuredReading& reading,
                                            const signals::Record* beside = nullptr);

// The same signal, read again and laid otherwise. Throws FileError, CaseError for a speed that it cannot have.
MeasuredRecord realigned(const MeasuredRecord& measured, const MeasuredReading& reading,
                         const signals::Record* beside = nullptr);

// How a measured signal that has positions lies beside a run: by the largest cross-correlation of the filtered
// accelerations over the length of the run, within 15 cm of where their largest values meet.
struct Match {
  double impact = 0;                  // [m] where the largest value of the measured signal comes to lie
  std::optional<double> correlation;  // there; none: the two cannot be compared
  double shift = 0;                   // [m] from where the largest values would meet
  // Else they are no passages of one defect, and the largest values meet.
  bool isAlike() const { return correlation.value_or(0) >= 0.5; }
};
Match matchBeside(const signals::Record& run, const signals::Record& measured);

// A record moved along the track, for as long as a mouse drags it: realigned() follows, to the last digit.
RecordPointer moved(const signals::Record& record, double metres);

// The whole of such a signal, as the file has it, times its gain. Throws FileError, also where it is no longer there.
signals::Record wholeRecord(const MeasuredRecord& measured);

}  // namespace squat::project

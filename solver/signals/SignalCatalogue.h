// solver/signals/SignalCatalogue.h - the signals of a run, one row each: name in files, unit, what it is, and the
// low-passed partner that is stored beside it.
#pragma once

#include <vector>

#include "signals/TimeSeries.h"

namespace squat::signals {

// In results and tables. They stay: files of earlier versions have them.
namespace names {
inline constexpr const char* axleBox = "aba";
inline constexpr const char* axleBoxFiltered = "aba_filtered";
inline constexpr const char* axleBoxLongitudinal = "aba_longitudinal";
inline constexpr const char* wheel = "wheel_acceleration";
inline constexpr const char* wheelFiltered = "wheel_acceleration_filtered";
inline constexpr const char* contactForce = "contact_force";
inline constexpr const char* creepForce = "creep_force";
inline constexpr const char* wheelSpeed = "wheel_speed";
inline constexpr const char* patchLength = "patch_length";
inline constexpr const char* patchWidth = "patch_width";
inline constexpr const char* rail = "rail_acceleration";
inline constexpr const char* sleeper = "sleeper_acceleration";
inline constexpr const char* irregularity = "irregularity";
inline constexpr const char* position = "position";
}  // namespace names

struct CatalogueRow {
  const char* name;
  const char* unit;
  const char* description;
  const char* filteredName = nullptr;  // also stored low-passed at output.filter_cutoff under this name
};

// In the order in which results store them. To add a signal, add its row here and its probe in simulation/Signals.cpp.
const std::vector<CatalogueRow>& signalCatalogue();

// The filtered partner: Butterworth of order 4 forward and back. A series that is too short for it, or sampled too
// slowly for the cut-off [Hz], is its own partner.
TimeSeries filteredPartner(const TimeSeries& series, double cutoff);
// Whether it is filtered.
bool carriesFilter(const TimeSeries& series, double cutoff);

}  // namespace squat::signals

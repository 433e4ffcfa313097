// solver/signals/SignalCatalogue.h - the signals of a run, one row each: name in files, unit, what it is, the
// low-passed partner that is stored beside it, and the figure that it is drawn in.
#pragma once

#include <string_view>
#include <vector>

#include "signals/TimeSeries.h"

namespace squat::signals {

struct Record;

// In results and tables. They stay: files of earlier versions have them.
namespace names {
inline constexpr const char* axleBox = "aba";
inline constexpr const char* axleBoxFiltered = "aba_filtered";
inline constexpr const char* axleBoxRight = "aba_right";  // of a whole model
inline constexpr const char* axleBoxLongitudinal = "aba_longitudinal";
inline constexpr const char* axleBoxLateral = "aba_lateral";
inline constexpr const char* secondAxleBox = "second_aba";
inline constexpr const char* secondAxleBoxFiltered = "second_aba_filtered";
inline constexpr const char* secondContactForce = "second_contact_force";
inline constexpr const char* wheelsetRoll = "wheelset_roll_acceleration";
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

// A signal as a curve against the wheel's position. Rows that name the same figure share it; the first of them says
// what the figure is.
struct SignalCurve {
  const char* figure = nullptr;  // name of the figure and of its file; null: none
  const char* label = "";        // in the legend, where several curves share the figure
  bool front = false;            // drawn thicker, before the others
  const char* tab = "";          // the figure's short heading
  const char* title = "";        // in words
  const char* axis = "";         // "Force on the rail [kN]"
  double factor = 1;             // from SI to the unit of the axis
  bool withZero = false;         // the range of the axis holds zero
};

struct CatalogueRow {
  const char* name;
  const char* unit;
  const char* description;
  const char* filteredName = nullptr;  // also stored low-passed at output.filter_cutoff under this name
  SignalCurve curve = {};
  const char* left = nullptr;  // of a signal of the right side, which only a whole model has: that of the left
};

// In the order in which results store them: the left side or the half model, the right side ("aba_right"), the
// position. To add a signal with its figure, add its row here and its probe in
// simulation/Signals.cpp.
const std::vector<CatalogueRow>& signalCatalogue();
// "aba_right_filtered", or another name of the right side's. Throws std::out_of_range for one that the catalogue lacks.
const char* filteredNameOnRight(std::string_view left);

// Whether a record has signals of the right side: it is that of a whole model.
bool hasRightSide(const Record& record);

// The filtered partner: Butterworth of order 4 forward and back. A series that is too short for it, or sampled too
// slowly for the cut-off [Hz], is its own partner.
TimeSeries filteredPartner(const TimeSeries& series, double cutoff);
// Whether it is filtered.
bool carriesFilter(const TimeSeries& series, double cutoff);

}  // namespace squat::signals

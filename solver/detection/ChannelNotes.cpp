#include "detection/ChannelNotes.h"

#include <algorithm>
#include <cmath>

#include "detection/Stretches.h"
#include "text/Numbers.h"

namespace squat::detection {
namespace {

using text::formatted;

// Of those that were passed at one speed.
std::string resonanceNote(const ChannelDetection& channel) {
  double lowest = 1e9, highest = 0;
  for (const auto& stretch : channel.waves) {
    if (areVaried(stretch.slowest, stretch.fastest)) continue;  // only such a speed shows a wavelength
    const double frequency = 0.5 * (stretch.slowest + stretch.fastest) / stretch.wavelength;
    lowest = std::min(lowest, frequency), highest = std::max(highest, frequency);
  }
  if (!(highest > 0)) return {};
  return channel.name + ": its stretches of corrugation were passed at one speed; " +
         (highest - lowest < 1 ? formatted("a resonance at %.0f Hz", highest)
                               : formatted("a resonance at %.0f", lowest) + formatted(" to %.0f Hz", highest)) +
         " would look the same";
}

}  // namespace

std::vector<std::string> channelNotes(const ChannelDetection& channel, const DetectOptions& options) {
  constexpr double restless = 3, doubtful = 0.5;
  std::vector<std::string> notes;
  const double quiet = std::max(options.threshold, EvidenceTail({}).evidenceOf(options.falseAlarms));
  const auto& sections = channel.background;
  const auto loud = std::max_element(sections.begin(), sections.end(), [&](const auto& a, const auto& b) {
    return a.tail.evidenceOf(options.falseAlarms) < b.tail.evidenceOf(options.falseAlarms);
  });
  if (loud != sections.end())
    if (const double evidence = loud->tail.evidenceOf(options.falseAlarms); evidence > restless * quiet)
      notes.push_back(channel.name + ": the background swells and fades; " + formatted("from %.0f ", loud->from) +
                      formatted("to %.0f m ", loud->to) +
                      formatted("an event needs a score of %.0f to stand out ", evidence) +
                      formatted("(%.0f in quiet noise)", quiet));
  if (auto note = resonanceNote(channel); !note.empty()) notes.push_back(std::move(note));
  if (!channel.events.empty() && channel.events.front().judgement.axleBox < doubtful)
    notes.push_back(
        channel.name + ": its events are much weaker or stronger than at an axle box, or shared otherwise " +
        "among the bands: the sensor may be elsewhere, the unit another, the speed wrong. Kinds are not reported");
  return notes;
}

}  // namespace squat::detection

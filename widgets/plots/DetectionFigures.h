// widgets/plots/DetectionFigures.h - the events of long records: an overview along the track, one figure an event.
#pragma once

#include <memory>
#include <vector>

#include "detection/DetectionFiles.h"
#include "plots/FigureSheet.h"
#include "project/EventList.h"

namespace squat::plots {

// "overview": largest acceleration along the chainage, a panel a channel of the first record, events as marks.
// "event_001", ...: signal and scalogram of each event, squats first, the strongest first, at most `maximum`.
std::vector<FigureSheet> detectionFigures(const detection::DetectionReport& report, const Style& style,
                                          std::size_t maximum = 40);

// Signal and scalogram of one event, as its figure has them; no panels where its signal is not in memory.
FigureSheet eventFigure(const detection::CombinedEvent& event, const Style& style);

// Where the events of a list are and how loud: their largest accelerations along the track, a mark a kind.
std::unique_ptr<Figure> eventMap(const project::EventList& list, const Style& style);

}  // namespace squat::plots

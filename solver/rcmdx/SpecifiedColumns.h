// solver/rcmdx/SpecifiedColumns.h - the parts of a written file that are tables: topology, sections, positions.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "rcmdx/EventsToWrite.h"
#include "rcmdx/TypedFile.h"

namespace squat::rcmdx {

// A dataset under the name of the specification. The files that SBB exchanges, and their published import script
// (OpenRailAssociation/rcm-dx-examples), have a prefix there ("events.timestamp"): the same dataset is linked under
// that name as well.
void writeColumn(TypedFile& file, const std::string& group, const std::string& prefix, const std::string& name,
                 const Cells& values);

// A group with the attribute Element.
void writeElement(TypedFile& file, const std::string& group, const std::string& element);

// All groups of the topology; those of which nothing is known are empty.
void writeTopology(TypedFile& file, const std::string& group, const EventsToWrite& events);

// Places of the session by their times [ns].
using WayOfSession = std::map<std::int64_t, Place>;
void writePositions(TypedFile& file, const std::string& session, const WayOfSession& way);
// Stretches in one direction, and the tracks of each. `start` [ns]: of the session.
void writeSections(TypedFile& file, const std::string& session, const WayOfSession& way, std::int64_t start,
                   const EventsToWrite& events);

}  // namespace squat::rcmdx

// solver/loggers/TdmsObjects.h - what the meta data of a TDMS file says of its groups and channels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "loggers/TdmsValues.h"

namespace squat::loggers {

struct TdmsProperty {
  std::string_view text;         // lies in the bytes of the file
  std::optional<double> number;  // of a number
  std::optional<TdmsMoment> moment;
};

// By name. Only those that say how values are to be read: wf_..., unit_string, NI_...
using TdmsProperties = std::map<std::string_view, TdmsProperty>;

std::optional<double> tdmsNumber(const TdmsProperties& properties, std::string_view name);
std::string_view tdmsText(const TdmsProperties& properties, std::string_view name);

// Where one channel of a data acquisition card (DAQmx) stands in the rows of its card.
struct TdmsScaler {
  const TdmsType* type = nullptr;  // null: a digital line, or a type that is not known
  std::uint32_t buffer = 0;        // which card
  std::uint32_t offset = 0;        // [bytes] in the row
  std::uint32_t id = 0;            // the scale in whose place it stands
};

// How the values of a channel stand in each chunk of a segment, until the file says otherwise.
struct TdmsIndex {
  const TdmsType* type = nullptr;     // null: DAQmx
  std::uint64_t count = 0;            // values
  std::uint64_t bytes = 0;            // 0 for DAQmx
  std::vector<TdmsScaler> scalers;    // of DAQmx
  std::vector<std::uint32_t> widths;  // [bytes] of a row of each card
};

struct TdmsObject {
  enum class Level { file, group, channel } level = Level::file;
  std::string group, channel;
  TdmsProperties properties;
  std::optional<TdmsIndex> index;
  std::string refusal;  // "it ...": why its values are not read; empty: they are
};

// An object without properties from its path, "/'group'/'channel'"; nothing for any other text.
std::optional<TdmsObject> tdmsObjectOf(std::string_view path);

// At the cursor: the index behind its first word, and the properties. FileError where they are damaged.
TdmsIndex readTdmsIndex(TdmsCursor& cursor, std::uint32_t firstWord);
void readTdmsProperties(TdmsCursor& cursor, TdmsProperties& properties);

}  // namespace squat::loggers

// solver/detection/Axles.h - which channels of a record are the two axle boxes of one wheelset.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "detection/AxleNames.h"
#include "records/RecordStream.h"

namespace squat::detection {

// Indices of channels.
struct Axle {
  std::size_t left = 0, right = 0;
};

// The other channel of the axle that a channel belongs to; nothing: of none.
std::optional<std::size_t> otherChannel(const std::vector<Axle>& axles, std::size_t channel);

// Without names, two channels are one axle where their names differ only in the words left (or l) and right (or r), or
// where one has the word right in addition ("aba", "aba_right"); a note says of each axle that its names decided.
// Throws FileError for a name that no channel has, CaseError for a channel of two axles.
std::vector<Axle> axlesOf(const records::RecordLayout& layout, const AxleNames& names, std::vector<std::string>& notes);

}  // namespace squat::detection

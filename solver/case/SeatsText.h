// solver/case/SeatsText.h - rail seats that differ from the others as text, "[{ sleeper = 1, pad_stiffness = 300 }]".
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

struct ParsedSeats {
  std::vector<Seat> seats;
  std::string mistake;  // what to do about it; empty: nothing is wrong
};
ParsedSeats parseSeats(std::string_view text);
std::string formatSeats(const std::vector<Seat>& seats);

// Keys and values of a seat as the text has them, `sleeper` first.
std::vector<std::pair<std::string, std::string>> seatEntries(const Seat& seat);
// "pad_stiffness (1 to 20000 MN/m), ...": what a seat may have besides its sleeper.
std::string seatKeys();

}  // namespace squat::cases

// solver/records/WorkRows.h - the rows of a record between the file and the blocks, in SI units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace squat::records {

enum class Mark : std::uint8_t { follows, starts, bad };  // on the row before; a new stretch; is not delivered

struct WorkRows {
  std::size_t first = 0;                                                // sample of row 0
  std::vector<double> time, position, speed, run, latitude, longitude;  // empty where the file has none
  std::vector<std::vector<double>> channels;
  std::vector<std::uint64_t> lines;  // empty where a row is its sample
  std::vector<Mark> marks;           // of the rows that have been checked

  std::size_t size() const { return channels.front().size(); }
  // The first rows go.
  void drop(std::size_t count) {
    const auto cut = [count](auto& values) {
      if (!values.empty()) values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    };
    for (auto* values : {&time, &position, &speed, &run, &latitude, &longitude}) cut(*values);
    for (auto& channel : channels) cut(channel);
    cut(lines);
    cut(marks);
    first += count;
  }
};

}  // namespace squat::records

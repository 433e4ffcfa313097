// solver/loggers/TdmsValues.h - numbers, moments and names as they stand in a TDMS file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace squat::loggers {

inline constexpr const char* tdmsDamagedAdvice = "Copy the file again from where it was recorded";
inline constexpr const char* tdmsRefusedAdvice = "Export the channels as CSV, or save them as plain numbers";

enum class TdmsKind { number, moment, text, other };  // other: of known size, but nothing that is read

struct TdmsType {
  std::uint32_t code;  // as the file has it
  TdmsKind kind;
  std::size_t size;  // [bytes] of one value; 0: each has its own
};

const TdmsType* findTdmsType(std::uint32_t code);  // null: not known, or of unknown size

// A time stamp: whole seconds since 1904-01-01 00:00 UTC and a fraction in units of 2^-64 s.
struct TdmsMoment {
  std::int64_t seconds = 0;
  std::uint64_t fraction = 0;
};

// [s] Taken apart before it becomes a double, which could hold a date to 0.24 us only.
double tdmsSecondsBetween(const TdmsMoment& from, const TdmsMoment& to);

// "2026-11-27 09:30:00.250000 UTC", to the microsecond below; empty for a year that no clock shows.
std::string tdmsMomentText(const TdmsMoment& moment);

TdmsMoment tdmsMomentAt(const char* bytes, bool bigEndian);
double tdmsNumberAt(const char* bytes, const TdmsType& type, bool bigEndian);

// Values of one channel that stand in the file at equal distances.
struct TdmsRun {
  const char* first = nullptr;
  std::uint64_t count = 0;
  std::size_t stride = 0;  // [bytes] from value to value
  const TdmsType* type = nullptr;
  bool bigEndian = false;
};

void appendTdmsNumbers(const TdmsRun& run, std::vector<double>& values);
// As seconds since `origin`.
void appendTdmsMoments(const TdmsRun& run, const TdmsMoment& origin, std::vector<double>& values);

// Reads from a part of the file. What would reach beyond `end` is a FileError that names the byte.
class TdmsCursor {
 public:
  TdmsCursor(std::string_view bytes, const std::string& path, std::size_t at, std::size_t end);

  void setBigEndian(bool bigEndian) { bigEndian_ = bigEndian; }
  bool bigEndian() const { return bigEndian_; }
  std::size_t at() const { return at_; }
  std::uint8_t byte();
  std::uint32_t word();
  std::uint64_t doubleWord();
  std::string_view text();  // behind its length
  const char* take(std::size_t size);
  [[noreturn]] void fail(const std::string& what) const;    // FileError at this byte: the file is damaged
  [[noreturn]] void refuse(const std::string& what) const;  // the same: nothing is wrong, but it is not read

 private:
  std::string_view bytes_;
  const std::string& path_;
  std::size_t at_, end_;
  bool bigEndian_ = false;
};

}  // namespace squat::loggers

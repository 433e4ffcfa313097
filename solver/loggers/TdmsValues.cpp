#include "loggers/TdmsValues.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/Errors.h"

namespace squat::loggers {
namespace {

// National Instruments, "TDMS File Format Internal Structure", table of data types. Not here: extended floats, whose
// size differs from machine to machine, and fixed-point numbers.
constexpr std::array<TdmsType, 17> tdmsTypes{{{1, TdmsKind::number, 1},
                                              {2, TdmsKind::number, 2},
                                              {3, TdmsKind::number, 4},
                                              {4, TdmsKind::number, 8},
                                              {5, TdmsKind::number, 1},
                                              {6, TdmsKind::number, 2},
                                              {7, TdmsKind::number, 4},
                                              {8, TdmsKind::number, 8},
                                              {9, TdmsKind::number, 4},
                                              {10, TdmsKind::number, 8},
                                              {0x19, TdmsKind::number, 4},  // with a unit, which is a property
                                              {0x1A, TdmsKind::number, 8},
                                              {0x20, TdmsKind::text, 0},
                                              {0x21, TdmsKind::number, 1},  // yes or no
                                              {0x44, TdmsKind::moment, 16},
                                              {0x08000C, TdmsKind::other, 8},  // complex
                                              {0x10000D, TdmsKind::other, 16}}};

constexpr std::int64_t tdmsEpochTo1970 = 2082844800;  // [s] from 1904-01-01 to 1970-01-01

template <typename T>
T tdmsValueAt(const char* bytes, bool bigEndian) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (bigEndian == (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

// Calls `use` with a value of the C++ type that the file's type is.
template <typename Use>
void tdmsWithType(std::uint32_t code, Use&& use) {
  switch (code) {
    case 1:
      return use(std::int8_t{});
    case 2:
      return use(std::int16_t{});
    case 3:
      return use(std::int32_t{});
    case 4:
      return use(std::int64_t{});
    case 5:
    case 0x21:
      return use(std::uint8_t{});
    case 6:
      return use(std::uint16_t{});
    case 7:
      return use(std::uint32_t{});
    case 8:
      return use(std::uint64_t{});
    case 9:
    case 0x19:
      return use(float{});
    default:
      return use(double{});
  }
}

}  // namespace

const TdmsType* findTdmsType(std::uint32_t code) {
  const auto found =
      std::find_if(tdmsTypes.begin(), tdmsTypes.end(), [&](const TdmsType& type) { return type.code == code; });
  return found == tdmsTypes.end() ? nullptr : &*found;
}

double tdmsSecondsBetween(const TdmsMoment& from, const TdmsMoment& to) {
  // Unsigned, since moments of a damaged file may lie further apart than 2^63 s.
  const auto whole =
      static_cast<std::int64_t>(static_cast<std::uint64_t>(to.seconds) - static_cast<std::uint64_t>(from.seconds));
  const bool forward = to.fraction >= from.fraction;
  const double fraction =
      std::ldexp(static_cast<double>(forward ? to.fraction - from.fraction : from.fraction - to.fraction), -64);
  return static_cast<double>(whole) + (forward ? fraction : -fraction);
}

std::string tdmsMomentText(const TdmsMoment& moment) {
  constexpr std::int64_t year9999 = 255485232000;  // [s] since 1904
  if (moment.seconds <= 0 || moment.seconds >= year9999) return {};
  const std::chrono::sys_seconds time{std::chrono::seconds{moment.seconds - tdmsEpochTo1970}};
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss clock{time - day};
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02u %02d:%02d:%02d.%06d UTC", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()), static_cast<int>((moment.fraction >> 32) * 1000000 >> 32));
  return text.data();
}

TdmsMoment tdmsMomentAt(const char* bytes, bool bigEndian) {
  const auto first = tdmsValueAt<std::uint64_t>(bytes, bigEndian),
             second = tdmsValueAt<std::uint64_t>(bytes + 8, bigEndian);
  if (bigEndian) return {static_cast<std::int64_t>(first), second};
  return {static_cast<std::int64_t>(second), first};
}

double tdmsNumberAt(const char* bytes, const TdmsType& type, bool bigEndian) {
  double value = 0;
  tdmsWithType(type.code, [&]<typename T>(T) { value = static_cast<double>(tdmsValueAt<T>(bytes, bigEndian)); });
  return value;
}

void appendTdmsNumbers(const TdmsRun& run, std::vector<double>& values) {
  tdmsWithType(run.type->code, [&]<typename T>(T) {
    for (std::uint64_t i = 0; i < run.count; ++i)
      values.push_back(static_cast<double>(tdmsValueAt<T>(run.first + i * run.stride, run.bigEndian)));
  });
}

void appendTdmsMoments(const TdmsRun& run, const TdmsMoment& origin, std::vector<double>& values) {
  for (std::uint64_t i = 0; i < run.count; ++i)
    values.push_back(tdmsSecondsBetween(origin, tdmsMomentAt(run.first + i * run.stride, run.bigEndian)));
}

TdmsCursor::TdmsCursor(std::string_view bytes, const std::string& path, std::size_t at, std::size_t end)
    : bytes_(bytes), path_(path), at_(at), end_(std::min(end, bytes.size())) {}

void TdmsCursor::fail(const std::string& what) const {
  throw FileError(path_, "byte " + std::to_string(at_), what, tdmsDamagedAdvice);
}

void TdmsCursor::refuse(const std::string& what) const {
  throw FileError(path_, "byte " + std::to_string(at_), what, tdmsRefusedAdvice);
}

const char* TdmsCursor::take(std::size_t size) {
  if (at_ > end_ || size > end_ - at_) fail("the file is damaged here: what follows is longer than its segment");
  const char* taken = bytes_.data() + at_;
  at_ += size;
  return taken;
}

std::uint8_t TdmsCursor::byte() { return static_cast<std::uint8_t>(*take(1)); }
std::uint32_t TdmsCursor::word() { return tdmsValueAt<std::uint32_t>(take(4), bigEndian_); }
std::uint64_t TdmsCursor::doubleWord() { return tdmsValueAt<std::uint64_t>(take(8), bigEndian_); }

std::string_view TdmsCursor::text() {
  const std::size_t size = word();
  return {take(size), size};
}

}  // namespace squat::loggers

// Writes TDMS files for tests, byte by byte from National Instruments' description of the format; knows nothing of the
// reader. Strings stand for bytes.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace squat::tdms {

inline constexpr std::uint32_t metaData = 2, newList = 4, rawData = 8, interleaved = 32, bigEndian = 64, daqmx = 128;
inline constexpr std::uint32_t i8 = 1, i16 = 2, i32 = 3, i64 = 4, u8 = 5, u16 = 6, u32 = 7, u64 = 8, f32 = 9, f64 = 10,
                               f32Unit = 0x19, f64Unit = 0x1A, string = 0x20, boolean = 0x21, stamp = 0x44,
                               complex = 0x10000D;

// A number of any type in either order of bytes.
template <typename T>
std::string bytes(T value, bool big = false) {
  std::string raw(sizeof(T), '\0');
  std::copy_n(reinterpret_cast<const char*>(&value), sizeof(T), raw.begin());
  if (big == (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
  return raw;
}

template <typename T>
std::string values(const std::vector<T>& all, bool big = false) {
  std::string raw;
  for (const T value : all) raw += bytes(value, big);
  return raw;
}

inline std::string text(const std::string& value, bool big = false) {
  return bytes(static_cast<std::uint32_t>(value.size()), big) + value;
}

// Seconds since 1904 and 2^-64 s; in big-endian files the seconds come first.
inline std::string moment(std::int64_t seconds, std::uint64_t fraction, bool big = false) {
  return big ? bytes(seconds, big) + bytes(fraction, big) : bytes(fraction, big) + bytes(seconds, big);
}

// A property: its name, type and value.
inline std::string property(const std::string& name, double value, bool big = false) {
  return text(name, big) + bytes(f64, big) + bytes(value, big);
}
inline std::string property(const std::string& name, std::uint32_t value, bool big = false) {
  return text(name, big) + bytes(u32, big) + bytes(value, big);
}
inline std::string property(const std::string& name, const std::string& value, bool big = false) {
  return text(name, big) + bytes(string, big) + text(value, big);
}
inline std::string momentProperty(const std::string& name, std::int64_t seconds, std::uint64_t fraction) {
  return text(name) + bytes(stamp) + moment(seconds, fraction);
}

// What stands between the path of an object and its properties.
inline std::string noValues(bool big = false) { return bytes(0xFFFFFFFFU, big); }
inline std::string asBefore() { return bytes(0U); }
inline std::string index(std::uint32_t type, std::uint64_t count, bool big = false) {
  return bytes(20U, big) + bytes(type, big) + bytes(1U, big) + bytes(count, big);
}
inline std::string textIndex(std::uint64_t count, std::uint64_t size) {
  return bytes(28U) + bytes(string) + bytes(1U) + bytes(count) + bytes(size);
}
// One scaler: its DAQmx type, card and place in the row.
struct Scaler {
  std::uint32_t type, card, offset, id;
};
inline std::string cardIndex(std::uint64_t count, const std::vector<Scaler>& scalers,
                             const std::vector<std::uint32_t>& widths) {
  std::string raw = bytes(0x1269U) + bytes(0xFFFFFFFFU) + bytes(1U) + bytes(count) +
                    bytes(static_cast<std::uint32_t>(scalers.size()));
  for (const auto& s : scalers) raw += bytes(s.type) + bytes(s.card) + bytes(s.offset) + bytes(0U) + bytes(s.id);
  return raw + bytes(static_cast<std::uint32_t>(widths.size())) + values(widths);
}

inline std::string object(const std::string& path, const std::string& index,
                          const std::vector<std::string>& properties = {}, bool big = false) {
  std::string raw = text(path, big) + index + bytes(static_cast<std::uint32_t>(properties.size()), big);
  for (const auto& property : properties) raw += property;
  return raw;
}

// Flags as given; the rest is counted. `closed`: else the length is that of a segment whose program died.
inline std::string segment(std::uint32_t flags, const std::vector<std::string>& objects, const std::string& raw,
                           bool closed = true, std::uint32_t version = 4713) {
  const bool big = (flags & bigEndian) != 0;
  std::string meta;
  if (flags & metaData) {
    meta = bytes(static_cast<std::uint32_t>(objects.size()), big);
    for (const auto& object : objects) meta += object;
  }
  const std::uint64_t length = closed ? meta.size() + raw.size() : ~std::uint64_t{0};
  return "TDSm" + bytes(flags) + bytes(version, big) + bytes(length, big) + bytes(std::uint64_t{meta.size()}, big) +
         meta + raw;
}

inline constexpr std::uint32_t first = metaData | newList | rawData;  // flags of a segment that needs no other

}  // namespace squat::tdms

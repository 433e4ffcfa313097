// solver/case/ShortHash.h - eight hexadecimal digits of a text: FNV-1a of 64 bits, folded to 32.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace squat::cases {

inline std::string shortHash(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char letter : content) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
  const auto folded = static_cast<std::uint32_t>(hash ^ (hash >> 32));
  constexpr const char* digits = "0123456789abcdef";
  std::string text;
  for (int shift = 28; shift >= 0; shift -= 4) text += digits[(folded >> shift) & 15u];
  return text;
}

}  // namespace squat::cases

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "results/MatlabFile.h"

namespace squat::results {

bool isMatlabFile(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::array<char, 128> head{};
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), head.size());
  if (in.gcount() != static_cast<std::streamsize>(head.size())) return false;
  const std::string_view text(head.data(), head.size());
  // The byte order stands behind the version, 0x0100; 7.3 has 0x0200.
  return text.substr(0, 10) == "MATLAB 5.0" &&
         ((text.substr(126) == "IM" && text[125] == 1) || (text.substr(126) == "MI" && text[124] == 1));
}

}  // namespace squat::results

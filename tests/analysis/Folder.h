// A folder for the files of one test, removed at its end, and runs over a defect to fill it with.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <string>

namespace squat::tests {

class Folder {
 public:
  Folder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("squat-analysis-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name = {}) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path(name);
  }
  std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path_ / name, std::ios::binary).rdbuf();
    return text.str();
  }
  std::size_t files() const {
    std::size_t n = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++n;
    return n;
  }

 private:
  std::filesystem::path path_;
};

// Two damped lines at 300 and 1034 Hz, struck at `impact` [s]; 0.24 s at 25 kHz with position at `speed`.
inline std::string runTable(double impact, double height, double speed, double high = 1034) {
  std::ostringstream text;
  text << std::setprecision(12) << "time [s];position [m];aba [m/s2]\n";
  for (int i = 0; i < 6000; ++i) {
    const double t = i / 25000.0, after = t - impact;
    const double value = after < 0
                             ? 0.01 * std::sin(400.0 * t)
                             : height * (std::exp(-after / 0.012) * std::sin(2 * std::numbers::pi * 300 * after) +
                                         std::exp(-after / 0.008) * std::sin(2 * std::numbers::pi * high * after));
    text << t << ';' << speed * t << ';' << value << '\n';
  }
  return text.str();
}

}  // namespace squat::tests

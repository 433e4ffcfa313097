// A file in the system's folder for temporary files, removed at the end of the scope.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace squat::tests {

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& content, const std::string& ending = ".csv") {
    static int count = 0;
    path_ = (std::filesystem::temp_directory_path() /
             ("squat-measured-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ending))
                .string();
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace squat::tests

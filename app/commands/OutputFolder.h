// app/commands/OutputFolder.h - the folder of a command's files, which is not left behind empty.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace squat::commands {

// Makes the folder and its parents. At the end of its life, those that it made and that are still empty (the command
// was cancelled or failed before it wrote anything) are removed again. FileError where the folder cannot be made.
class OutputFolder {
 public:
  explicit OutputFolder(const std::string& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  // the deepest first
};

}  // namespace squat::commands

// The shortest real run: the shipped light defect on the tiny mesh, a few centimetres of rolling.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace squat::tests {

inline const std::vector<std::pair<std::string, std::string>>& shortSets() {
  static const std::vector<std::pair<std::string, std::string>> sets = {{"motion.run_up", "0.04"},
                                                                        {"motion.beyond", "0.02"}};
  return sets;
}

// "run light-defect --mesh tiny --set ... -o FOLDER --no-figures" and what is given besides. One thread: a busy machine
// makes threads wait for each other.
inline std::vector<std::string> shortRun(const std::string& folder, const std::vector<std::string>& besides = {}) {
  std::vector<std::string> words{"run",  "light-defect", "--mesh",    "tiny", "-o",
                                 folder, "--no-figures", "--threads", "1"};
  for (const auto& [key, value] : shortSets()) words.insert(words.end(), {"--set", key + "=" + value});
  words.insert(words.end(), besides.begin(), besides.end());
  return words;
}

}  // namespace squat::tests

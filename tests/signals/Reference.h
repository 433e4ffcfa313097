// Named arrays from a text file of the folder reference: one line each, name, count, values.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace squat::tests {

class Reference {
 public:
  explicit Reference(const std::string& file) {
    const std::string path = std::string(SQUAT_SOURCE_DIR) + "/tests/signals/reference/" + file;
    std::ifstream in(path);
    std::string line;
    while (std::getline(in, line)) {
      std::istringstream words(line);
      std::string name;
      std::size_t count = 0;
      words >> name >> count;
      std::vector<double> values(count);
      for (double& value : values) words >> value;
      if (!words) throw std::runtime_error("bad line '" + name + "' in " + path);
      arrays_[name] = values;
    }
    if (arrays_.empty()) throw std::runtime_error("cannot read " + path);
  }
  const std::vector<double>& operator[](const std::string& name) const { return arrays_.at(name); }
  double scalar(const std::string& name) const { return arrays_.at(name).at(0); }

 private:
  std::map<std::string, std::vector<double>> arrays_;
};

}  // namespace squat::tests

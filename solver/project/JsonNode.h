// solver/project/JsonNode.h - a value of a JSON file with its location in it: errors name it.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace squat::project {

// The JSON of a text. Throws FileError with line and column where it is none.
nlohmann::ordered_json parsedJson(const std::string& text, const std::string& origin, const std::string& advice);

// Every reader below throws FileError with the location ("/runs/3/path") where the value is missing, of another kind or
// out of range.
class JsonNode {
 public:
  // The whole file. `json`, `origin` and `advice`, what to do with a file that is wrong, outlive the nodes.
  JsonNode(const nlohmann::ordered_json& json, const std::string& origin, const std::string& advice)
      : JsonNode(json, "", origin, advice) {}

  [[noreturn]] void fail(const std::string& what) const;
  JsonNode at(const char* key) const;
  bool has(const char* key) const;
  std::vector<JsonNode> list(std::size_t maximum = 10000) const;
  std::string text() const;
  bool flag() const;
  double number(double lowest, double highest) const;
  int whole(int lowest, int highest) const;
  char letter() const;  // 0: an empty text

 private:
  JsonNode(const nlohmann::ordered_json& json, std::string location, const std::string& origin,
           const std::string& advice)
      : json_(json), location_(std::move(location)), origin_(origin), advice_(advice) {}

  const nlohmann::ordered_json& json_;
  std::string location_;
  const std::string &origin_, &advice_;
};

}  // namespace squat::project

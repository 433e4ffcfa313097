#include "project/JsonNode.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "core/Errors.h"
#include "text/Numbers.h"

namespace squat::project {
namespace {

// Line and column of a byte, counted from 1.
std::string locationOf(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const auto start = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return "line " + std::to_string(line) + ", column " + std::to_string(1 + (end - start));
}

// Byte, counted from 1. The library quotes the number, and does not say where it stands: "... parsing '1e999'".
std::size_t placeOf(const std::string& message, const std::string& text) {
  const auto end = message.rfind('\'');
  if (end == std::string::npos || end == 0) return 0;
  const auto start = message.rfind('\'', end - 1);
  if (start == std::string::npos) return 0;
  const auto found = text.find(std::string_view(message).substr(start + 1, end - start - 1));
  return found == std::string::npos ? 0 : found + 1;
}

}  // namespace

nlohmann::ordered_json parsedJson(const std::string& text, const std::string& origin, const std::string& advice) {
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::ordered_json::parse_error& error) {
    throw FileError(origin, locationOf(text, error.byte), "is not JSON, or was cut off here", advice);
  } catch (const nlohmann::ordered_json::out_of_range& error) {  // 1e999
    throw FileError(origin, locationOf(text, placeOf(error.what(), text)), "is a number beyond 1.8e308", advice);
  }
}

void JsonNode::fail(const std::string& what) const {
  throw FileError(origin_, location_.empty() ? "the whole file" : location_, what, advice_);
}

JsonNode JsonNode::at(const char* key) const {
  if (!json_.is_object()) fail("is not a table of keys and values");
  const auto found = json_.find(key);
  if (found == json_.end()) fail(std::string("lacks the key '") + key + "'");
  return {*found, location_ + "/" + key, origin_, advice_};
}

bool JsonNode::has(const char* key) const { return json_.is_object() && json_.contains(key); }

std::vector<JsonNode> JsonNode::list(std::size_t maximum) const {
  if (!json_.is_array()) fail("is not a list");
  if (json_.size() > maximum) fail("has more than " + std::to_string(maximum) + " entries");
  std::vector<JsonNode> nodes;
  for (std::size_t i = 0; i < json_.size(); ++i)
    nodes.push_back({json_[i], location_ + "/" + std::to_string(i), origin_, advice_});
  return nodes;
}

std::string JsonNode::text() const {
  if (!json_.is_string()) fail("is not a text");
  return json_.get<std::string>();
}

bool JsonNode::flag() const {
  if (!json_.is_boolean()) fail("is neither true nor false");
  return json_.get<bool>();
}

double JsonNode::number(double lowest, double highest) const {
  const double value = json_.is_number() ? json_.get<double>() : NAN;
  if (!(value >= lowest && value <= highest))
    fail("is " + (json_.is_number() ? json_.dump() : std::string(json_.type_name())) + ", not a number from " +
         text::roundedText(lowest) + " to " + text::roundedText(highest));
  return value;
}

int JsonNode::whole(int lowest, int highest) const {
  const double value = number(lowest, highest);
  if (value != std::floor(value)) fail("is not a whole number");
  return static_cast<int>(value);
}

char JsonNode::letter() const {
  const std::string value = text();
  if (value.size() > 1) fail("has more than one letter");
  return value.empty() ? '\0' : value[0];
}

}  // namespace squat::project

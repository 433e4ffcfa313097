#include <cstdio>
#include <string_view>

#include "rcmdx/EventsToWrite.h"
#include "text/Numbers.h"
#include "text/Utf8Text.h"

namespace squat::rcmdx {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text::asUtf8(text)) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
        result += "&#10;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) result += c;  // XML has no other control characters
    }
  return result;
}

std::uint64_t hashOf(std::string_view content, std::uint64_t hash) {
  for (const char letter : content) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
  return hash;
}

// A UUID of the kind that programs make by a rule of their own (RFC 9562, version 8): from what the event is, so that
// the same search gives the same file.
std::string uuidOf(const EventToWrite& event) {
  const std::string content = std::to_string(event.time) + '|' + std::to_string(event.duration) + '|' + event.channel +
                              '|' + event.kind + '|' + text::numberText(event.place.covered);
  const std::uint64_t high = (hashOf(content, 0xcbf29ce484222325u) & ~std::uint64_t{0xF000}) | 0x8000;
  const std::uint64_t low =
      (hashOf(content, 0x9ae16a3b2f90404fu) & ~(std::uint64_t{3} << 62)) | (std::uint64_t{1} << 63);
  char text[40];
  std::snprintf(text, sizeof text, "%08x-%04x-%04x-%04x-%012llx", static_cast<unsigned>(high >> 32),
                static_cast<unsigned>((high >> 16) & 0xFFFF), static_cast<unsigned>(high & 0xFFFF),
                static_cast<unsigned>(low >> 48), static_cast<unsigned long long>(low & 0xFFFFFFFFFFFFu));
  return text;
}

}  // namespace

std::string defectXml(const EventToWrite& event, const EventsToWrite& all) {
  std::string xml = "<Defect xmlns=\"http://www.sbb.ch/RCMDX/Events/Defect\"";
  const auto attribute = [&xml](const std::string& name, const std::string& value) {
    xml += " " + name + "=\"" + escaped(value) + "\"";
  };
  attribute("Classification", event.severity);
  attribute("DefectName", event.kind);
  attribute("Details", event.details);
  for (std::size_t i = 0; i < event.parameters.size() && i < 3; ++i) {
    const std::string name = "Parameter" + std::to_string(i + 1);
    attribute(name + "Name", event.parameters[i].first);
    attribute(name + "Value", event.parameters[i].second);
  }
  attribute("ID", event.id.empty() ? uuidOf(event) : event.id);
  xml += '>';
  const auto list = [&xml](const char* name, const std::vector<std::string>& values) {
    for (const auto& value : values) xml += "<" + std::string(name) + ">" + escaped(value) + "</" + name + ">";
  };
  list("PossibleDefectNames", all.kinds);
  list("PossibleClassifications", all.severities);
  list("PossibleValidationResults", all.verdicts);
  return xml + "</Defect>";
}

}  // namespace squat::rcmdx

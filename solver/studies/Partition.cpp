#include "studies/Partition.h"

#include <charconv>
#include <cstdint>
#include <optional>

#include "case/ShortHash.h"
#include "core/Errors.h"

namespace squat::studies {

namespace {

std::optional<std::size_t> countFrom(const std::string& text) {
  std::size_t count = 0;
  const auto* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, count);
  if (error != std::errc() || end != last || text.empty()) return std::nullopt;
  return count;
}

std::optional<Partition::Kind> kindFrom(const std::string& text) {
  if (text == "slice") return Partition::Kind::slice;
  if (text == "hash") return Partition::Kind::hash;
  return std::nullopt;
}

std::string toText(Partition::Kind kind) { return kind == Partition::Kind::slice ? "slice" : "hash"; }

}  // namespace

Partition partitionFromText(const std::string& text) {
  const auto refuse = [&](const std::string& allowed) {
    return CaseError({{"--partition", text, allowed, "Example: slice:3/16, the third of sixteen parts"}});
  };
  const auto colon = text.find(':'), slash = text.find('/');
  if (colon == std::string::npos || slash == std::string::npos || slash < colon) throw refuse("slice:M/N or hash:M/N");
  const auto kind = kindFrom(text.substr(0, colon));
  const auto part = countFrom(text.substr(colon + 1, slash - colon - 1)), parts = countFrom(text.substr(slash + 1));
  if (!kind || !part || !parts) throw refuse("slice:M/N or hash:M/N");
  if (*parts < 1 || *parts > kMaximumParts) throw refuse("N from 1 to " + std::to_string(kMaximumParts));
  if (*part < 1 || *part > *parts) throw refuse("M from 1 to N");
  return {*kind, *part, *parts};
}

std::string toText(const Partition& partition) {
  return toText(partition.kind) + ":" + std::to_string(partition.part) + "/" + std::to_string(partition.parts);
}

std::string familyOf(const Partition& partition) {
  return toText(partition.kind) + ":" + std::to_string(partition.parts);
}

Partition familyFromText(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) return partitionFromText(text);  // says what is wrong
  return partitionFromText(text.substr(0, colon + 1) + "1/" + text.substr(colon + 1));
}

std::string stemOf(const Partition& partition, const std::string& command) {
  return command + "-" + toText(partition.kind) + "-" + std::to_string(partition.part) + "-of-" +
         std::to_string(partition.parts);
}

std::size_t partOf(const Partition& family, std::size_t index, const std::string& name) {
  if (family.kind == Partition::Kind::slice) return 1 + index % family.parts;
  const auto digits = cases::shortHash(name);
  std::uint32_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  return 1 + number % family.parts;
}

std::size_t partOf(const Partition& family, const StudyDefinition& definition, const StudyPoint& point) {
  return partOf(family, point.index, toText(definition, point));
}

bool isInPart(const Partition& partition, const StudyDefinition& definition, const StudyPoint& point) {
  return partOf(partition, definition, point) == partition.part;
}

}  // namespace squat::studies

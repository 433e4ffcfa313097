#include "detection/Axles.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "core/Errors.h"
#include "text/Text.h"

namespace squat::detection {
namespace {

enum class NamedSide { none, left, right };

struct NameParts {
  std::string rest;  // without the word for the side
  NamedSide side = NamedSide::none;
  bool isAcross = false;  // not the vertical acceleration
};

NameParts partsOf(const std::string& name) {
  NameParts parts;
  // Bytes from 0x80 on are parts of letters.
  const auto isWordEnd = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x80 && !std::isalnum(byte);
  };
  const auto lower = text::lowerCase(name);
  for (auto from = lower.begin(); from != lower.end();) {
    if (isWordEnd(*from)) {
      ++from;
      continue;
    }
    const auto to = std::find_if(from, lower.end(), isWordEnd);
    const std::string word(from, to);
    const bool isLeft = word == "left" || word == "l", isRight = word == "right" || word == "r";
    parts.isAcross = parts.isAcross || word == "lateral" || word == "longitudinal";
    if (isLeft || isRight)
      parts.side = isLeft ? NamedSide::left : NamedSide::right;
    else
      parts.rest += word + ' ';
    from = to;
  }
  return parts;
}

std::vector<Axle> foundByNames(const records::RecordLayout& layout, std::vector<std::string>& notes) {
  std::map<std::string, std::map<NamedSide, std::vector<std::size_t>>> alike;
  for (std::size_t c = 0; c < layout.channels.size(); ++c) {
    const auto parts = partsOf(layout.channels[c].name);
    if (parts.isAcross) continue;
    alike[parts.rest][parts.side].push_back(c);
  }
  std::vector<Axle> axles;
  for (auto& [rest, sides] : alike) {
    auto& left = sides[NamedSide::left].empty() ? sides[NamedSide::none] : sides[NamedSide::left];
    const auto& right = sides[NamedSide::right];
    if (left.size() != 1 || right.size() != 1) continue;
    axles.push_back({left.front(), right.front()});
    notes.push_back("channels '" + layout.channels[left.front()].name + "' and '" +
                    layout.channels[right.front()].name +
                    "' are assumed, from their names, to be the left and the right axle box of one wheelset (--axle "
                    "LEFT,RIGHT names others, --axle none switches this off; in the studio under Axle boxes)");
  }
  return axles;
}

std::size_t channelOf(const records::RecordLayout& layout, const std::string& name) {
  std::string all;
  for (std::size_t c = 0; c < layout.channels.size(); ++c) {
    if (layout.channels[c].name == name) return c;
    all += (all.empty() ? "" : ", ") + quotedAxleName(layout.channels[c].name);
  }
  throw FileError(layout.path, "", "has no channel '" + name + "', which is named as an axle box",
                  "Its channels: " + all);
}

}  // namespace

std::optional<std::size_t> otherChannel(const std::vector<Axle>& axles, std::size_t channel) {
  for (const auto& axle : axles) {
    if (axle.left == channel) return axle.right;
    if (axle.right == channel) return axle.left;
  }
  return std::nullopt;
}

std::vector<Axle> axlesOf(const records::RecordLayout& layout, const AxleNames& names,
                          std::vector<std::string>& notes) {
  if (!names) return foundByNames(layout, notes);
  std::vector<Axle> axles;
  std::vector<bool> isTaken(layout.channels.size(), false);
  const auto take = [&](const std::string& name) {
    const auto channel = channelOf(layout, name);
    if (isTaken[channel]) throw CaseError({{"axle", name, "a channel of one wheelset alone", "It is named twice"}});
    isTaken[channel] = true;
    return channel;
  };
  for (const auto& [left, right] : *names) {
    const auto first = take(left);
    axles.push_back({first, take(right)});
  }
  return axles;
}

}  // namespace squat::detection

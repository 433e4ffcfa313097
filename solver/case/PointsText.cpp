#include "case/PointsText.h"

#include <cmath>

#include "case/DecimalNumber.h"

namespace squat::cases {

namespace {

// Reads "[", numbers, commas and "]" one after the other; blanks and line ends count for nothing.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  bool take(char letter) {
    skipBlanks();
    if (at_ >= text_.size() || text_[at_] != letter) return false;
    ++at_;
    return true;
  }

  std::optional<double> number(int powerOfTen) {
    skipBlanks();
    const std::size_t from = at_;
    while (at_ < text_.size() && std::string_view("+-.0123456789eE").find(text_[at_]) != std::string_view::npos) ++at_;
    return parseDecimal(text_.substr(from, at_ - from), powerOfTen);
  }

  bool atEnd() {
    skipBlanks();
    return at_ == text_.size();
  }

 private:
  void skipBlanks() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::optional<std::vector<ProfilePoint>> readPoints(Cursor& cursor, int powerOfTen, int secondPowerOfTen) {
  std::vector<ProfilePoint> points;
  if (!cursor.take('[')) return std::nullopt;
  while (!cursor.take(']')) {
    if (!cursor.take('[') || points.size() >= maximumPoints) return std::nullopt;
    const auto position = cursor.number(powerOfTen);
    if (!position || !cursor.take(',')) return std::nullopt;
    const auto height = cursor.number(secondPowerOfTen);
    if (!height || !cursor.take(']')) return std::nullopt;
    points.push_back({*position, *height});
    if (cursor.take(',')) continue;
    if (!cursor.take(']')) return std::nullopt;
    break;
  }
  return points;
}

}  // namespace

std::optional<std::vector<ProfilePoint>> parsePoints(std::string_view text, int powerOfTen) {
  return parsePoints(text, powerOfTen, powerOfTen);
}

std::optional<std::vector<ProfilePoint>> parsePoints(std::string_view text, int powerOfTen, int secondPowerOfTen) {
  Cursor cursor(text);
  auto points = readPoints(cursor, powerOfTen, secondPowerOfTen);
  return cursor.atEnd() ? points : std::nullopt;
}

std::optional<std::vector<ProfileLine>> parseLines(std::string_view text, int powerOfTen) {
  Cursor cursor(text);
  std::vector<ProfileLine> lines;
  if (!cursor.take('[')) return std::nullopt;
  while (!cursor.take(']')) {
    if (!cursor.take('[') || lines.size() >= maximumLines) return std::nullopt;
    const auto lateral = cursor.number(powerOfTen);
    if (!lateral || !cursor.take(',')) return std::nullopt;
    auto points = readPoints(cursor, powerOfTen, powerOfTen);
    if (!points || !cursor.take(']')) return std::nullopt;
    lines.push_back({*lateral, std::move(*points)});
    if (cursor.take(',')) continue;
    if (!cursor.take(']')) return std::nullopt;
    break;
  }
  if (!cursor.atEnd()) return std::nullopt;
  return lines;
}

std::string formatLines(const std::vector<ProfileLine>& lines, int powerOfTen) {
  std::string text = "[";
  for (const auto& line : lines) {
    if (text.size() > 1) text += ", ";
    text += "[" + formatDecimal(line.lateral, powerOfTen) + ", " + formatPoints(line.points, powerOfTen) + "]";
  }
  return text + "]";
}

std::string linesMistake(const std::vector<ProfileLine>& lines) {
  constexpr double edge = 0.036;  // [m] half the width of the head
  if (lines.size() == 1) return "Give at least two lines, or use defect.points for a single profile";
  if (lines.size() > maximumLines) return "Give at most " + std::to_string(maximumLines) + " lines";
  std::size_t all = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string which = "Line " + std::to_string(i + 1) + ": ";
    if (!(std::abs(lines[i].lateral) <= edge)) return which + "the lateral position must be -36 to 36 mm";
    if (i > 0 && !(lines[i].lateral > lines[i - 1].lateral)) return which + "lateral positions must ascend";
    if (lines[i].points.empty()) return which + "Give at least two points";
    if (const std::string wrong = pointsMistake(lines[i].points); !wrong.empty()) return which + wrong;
    all += lines[i].points.size();
  }
  return all > maximumPoints ? "Give at most " + std::to_string(maximumPoints) + " points" : std::string();
}

std::string formatPoints(const std::vector<ProfilePoint>& points, int powerOfTen) {
  std::string text = "[";
  for (const auto& point : points) {
    if (text.size() > 1) text += ", ";
    text += "[" + formatDecimal(point.position, powerOfTen) + ", " + formatDecimal(point.height, powerOfTen) + "]";
  }
  return text + "]";
}

std::string pointsMistake(const std::vector<ProfilePoint>& points) {
  constexpr double farthest = 1e6, highest = 0.05;  // [m]
  if (points.size() == 1) return "Give at least two points";
  if (points.size() > maximumPoints) return "Give at most " + std::to_string(maximumPoints) + " points";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string which = "Point " + std::to_string(i + 1) + ": ";
    if (!(std::abs(points[i].position) <= farthest))
      return which + "the position must be -1000 to 1000 km; check the unit";
    if (!(std::abs(points[i].height) <= highest)) return which + "the height must be -50 to 50 mm; check the unit";
    if (i > 0 && points[i].position == points[i - 1].position) return which + "same position as the one before";
    if (i > 0 && points[i].position < points[i - 1].position) return which + "positions must ascend";
  }
  return {};
}

}  // namespace squat::cases

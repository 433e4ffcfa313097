#include "text/TextTable.h"

#include <algorithm>
#include <numeric>

namespace squat::text {

namespace {

constexpr std::size_t kGap = 2;  // between columns

using Row = std::vector<std::string>;

// Signs, not bytes: continuation bytes of UTF-8 take no place.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t from = 0; from < text.size();) {
    const auto to = std::min(text.find(' ', from), text.size());
    if (to > from) words.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return words;
}

// Lines of at most `width` signs; a word that is longer stays whole.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  if (widthOf(text) <= width) return {text};
  std::vector<std::string> lines{""};
  for (const auto& word : wordsOf(text)) {
    if (!lines.back().empty() && widthOf(lines.back()) + 1 + widthOf(word) > width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

std::size_t totalOf(const std::vector<std::size_t>& widths) {
  return std::accumulate(widths.begin(), widths.end(), std::size_t{0}) +
         kGap * (widths.empty() ? 0 : widths.size() - 1);
}

// The columns' widths: those of the widest cells; where that is too much, the widest columns give way, at most down to
// their longest word.
std::vector<std::size_t> columnWidths(const std::vector<Row>& rows, std::size_t maximumWidth) {
  std::vector<std::size_t> widths, words;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    words.resize(widths.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], widthOf(row[i]));
      for (const auto& word : wordsOf(row[i])) words[i] = std::max(words[i], widthOf(word));
    }
  }
  while (maximumWidth > 0 && totalOf(widths) > maximumWidth) {
    std::size_t widest = widths.size();
    for (std::size_t i = 0; i < widths.size(); ++i)
      if (widths[i] > words[i] && (widest == widths.size() || widths[i] > widths[widest])) widest = i;
    if (widest == widths.size()) break;
    --widths[widest];
  }
  return widths;
}

std::string lineOf(const Row& cells, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += cells[i];
    const auto own = widthOf(cells[i]);
    if (i + 1 < cells.size()) line += std::string((own < widths[i] ? widths[i] - own : 0) + kGap, ' ');
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string rowText(const Row& row, const std::vector<std::size_t>& widths) {
  std::vector<std::vector<std::string>> cells;
  std::size_t lines = 1;
  for (std::size_t i = 0; i < row.size(); ++i) {
    cells.push_back(wrapped(row[i], widths[i]));
    lines = std::max(lines, cells.back().size());
  }
  std::string text;
  for (std::size_t l = 0; l < lines; ++l) {
    Row part;
    for (const auto& cell : cells) part.push_back(l < cell.size() ? cell[l] : std::string());
    text += lineOf(part, widths);
  }
  return text;
}

}  // namespace

std::string TextTable::text(std::size_t maximumWidth) const {
  const auto widths = columnWidths(rows_, maximumWidth);
  std::string all;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    all += rowText(rows_[r], widths);
    if (r == 0) all += std::string(totalOf(widths), '-') + "\n";
  }
  return all;
}

}  // namespace squat::text

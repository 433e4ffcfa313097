#include "detection/BackgroundSections.h"

#include <algorithm>
#include <cmath>

namespace squat::detection {

std::vector<BackgroundSection> backgroundSections(const std::vector<Piece>& pieces, std::vector<Way> leftOut) {
  std::sort(leftOut.begin(), leftOut.end(), [](const Way& a, const Way& b) { return a.from < b.from; });
  const auto isLeftOut = [&](double position) {  // ways are of one length: the first that ends behind it decides
    const auto way = std::lower_bound(leftOut.begin(), leftOut.end(), position,
                                      [](const Way& each, double value) { return each.to < value; });
    return way != leftOut.end() && way->from < position + pieceLength;
  };
  constexpr std::size_t usual = 1000;  // pieces
  const std::size_t count = std::max<std::size_t>(1, (pieces.size() + usual / 2) / usual);
  std::vector<BackgroundSection> sections;
  for (std::size_t s = 0; s < count && !pieces.empty(); ++s) {
    std::vector<double> maxima;
    const auto first = pieces.begin() + static_cast<std::ptrdiff_t>(s * pieces.size() / count);
    const auto end = pieces.begin() + static_cast<std::ptrdiff_t>((s + 1) * pieces.size() / count);
    for (auto piece = first; piece != end; ++piece)
      if (piece->evidence > 0 && !isLeftOut(piece->position)) maxima.push_back(piece->evidence);
    const auto [low, high] =
        std::minmax_element(first, end, [](const Piece& a, const Piece& b) { return a.position < b.position; });
    sections.push_back({low->position, high->position + pieceLength, EvidenceTail(maxima)});
  }
  return sections;
}

const BackgroundSection* sectionAt(const std::vector<BackgroundSection>& sections, double position) {
  const auto apart = [position](const BackgroundSection& section) {
    return std::max({0.0, section.from - position, position - section.to});
  };
  const auto nearest = std::min_element(sections.begin(), sections.end(),
                                        [&](const auto& a, const auto& b) { return apart(a) < apart(b); });
  return nearest == sections.end() ? nullptr : &*nearest;
}

}  // namespace squat::detection

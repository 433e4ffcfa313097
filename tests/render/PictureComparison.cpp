#include "render/PictureComparison.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace squat::tests {

double inkShare(const QImage& image) {
  const QImage rgb = image.convertToFormat(QImage::Format_RGB32);
  const QRgb background = rgb.pixel(0, 0);
  long long ink = 0;
  for (int y = 0; y < rgb.height(); ++y)
    for (int x = 0; x < rgb.width(); ++x) ink += rgb.pixel(x, y) != background;
  return static_cast<double>(ink) / (static_cast<double>(rgb.width()) * rgb.height());
}

PixelDifference difference(const QImage& a, const QImage& b) {
  PixelDifference found;
  if (a.size() != b.size() || a.isNull()) {
    found.pixels = std::max(1LL, static_cast<long long>(a.width()) * a.height());
    found.largest = 255, found.where = a.rect();
    return found;
  }
  const QImage first = a.convertToFormat(QImage::Format_RGB32), second = b.convertToFormat(QImage::Format_RGB32);
  for (int y = 0; y < first.height(); ++y)
    for (int x = 0; x < first.width(); ++x) {
      const QRgb p = first.pixel(x, y), q = second.pixel(x, y);
      const int maximum =
          std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
      found.largest = std::max(found.largest, maximum);
      if (maximum <= channelTolerance) continue;
      ++found.pixels;
      found.where |= QRect(x, y, 1, 1);
    }
  return found;
}

std::string lookDifferent(const QImage& now, const QImage& kept) {
  const auto found = difference(now, kept);
  if (found.pixels <= pixelsAllowed) return {};
  const auto& w = found.where;
  return std::to_string(found.pixels) + " pixels differ by up to " + std::to_string(found.largest) +
         " levels, between columns " + std::to_string(w.left()) + " and " + std::to_string(w.right()) + ", lines " +
         std::to_string(w.top()) + " and " + std::to_string(w.bottom());
}

QImage thumbnail(const QImage& image, int width) {
  return image.convertToFormat(QImage::Format_RGB32).scaledToWidth(width, Qt::SmoothTransformation);
}

std::string freshFolder(const std::string& name) {
  const auto folder = std::filesystem::path(SQUAT_BINARY_DIR) / "tests" / "render" / "written" / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

}  // namespace squat::tests

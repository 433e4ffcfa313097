#include "render/PictureComparison.h"

#include <cmath>
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

double difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull()) return 1;
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) sum += std::pow((qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) / 255.0, 2);
  return std::sqrt(sum / (static_cast<double>(a.width()) * a.height()));
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

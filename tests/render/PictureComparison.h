// tests/render/PictureComparison.h - statistics of pixels.
#pragma once

#include <QImage>
#include <string>

namespace squat::tests {

// Share of pixels that differ from the one at the top left corner.
double inkShare(const QImage& image);

// Root of the mean square difference of grey levels, 0..1. 1 where the sizes differ.
double difference(const QImage& a, const QImage& b);

// Scaled down to `width` by averaging: small files, and blind to how a machine smooths letters.
QImage thumbnail(const QImage& image, int width);

// An empty folder for the files of a test.
std::string freshFolder(const std::string& name);

}  // namespace squat::tests

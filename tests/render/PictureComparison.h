// tests/render/PictureComparison.h - statistics of pixels.
#pragma once

#include <QImage>
#include <QRect>
#include <string>

namespace squat::tests {

// Share of pixels that differ from the one at the top left corner.
double inkShare(const QImage& image);

// Where two pictures differ in colour, pixel by pixel.
struct PixelDifference {
  long long pixels = 0;  // in which a channel differs by more than channelTolerance
  int largest = 0;       // of any channel, 0..255
  QRect where;           // around those pixels
};

// Levels of 255 by which a channel may differ. The same packages draw the same bits, run after run and on any number of
// cores; another processor may take other vector instructions, which round colours by a level or two.
constexpr int channelTolerance = 4;

// Pixels of a thumbnail that may differ by more: what the smallest change that a reader can see makes at least is shown
// in PictureComparisonTest.cpp.
constexpr long long pixelsAllowed = 2;

// Pictures of different sizes differ in all pixels.
PixelDifference difference(const QImage& a, const QImage& b);

// Empty where the pictures look alike; else how many pixels differ, by how much and where.
std::string lookDifferent(const QImage& now, const QImage& kept);

// Scaled down to `width` by averaging: small files.
QImage thumbnail(const QImage& image, int width);

// An empty folder for the files of a test.
std::string freshFolder(const std::string& name);

}  // namespace squat::tests

// What the patch passes on, against closed forms.
#include "roughness/ContactFilter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/Errors.h"

namespace squat::roughness {
namespace {

constexpr double halfLength = 0.006;  // [m]

TEST(ContactFilter, LongWavesPass) {
  for (const auto filter : {ContactFilter::none, ContactFilter::uniform, ContactFilter::remington})
    EXPECT_NEAR(contactFilter(filter, 3.0, halfLength), 1, 1e-4);
}

// The mean of cos(k x) over -a to a.
TEST(ContactFilter, UniformIsTheMeanOverThePatch) {
  EXPECT_NEAR(contactFilter(ContactFilter::uniform, 2 * halfLength, halfLength), 0, 1e-12) << "a wave in the patch";
  for (const double wavelength : {0.01, 0.017, 0.04}) {
    double mean = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i)
      mean += std::cos(2 * M_PI / wavelength * halfLength * (2 * (i + 0.5) / count - 1)) / count;
    EXPECT_NEAR(contactFilter(ContactFilter::uniform, wavelength, halfLength), std::abs(mean), 1e-7);
  }
}

// 1 + pi/4 at k a = 1.
TEST(ContactFilter, RemingtonAtAPatchOfOneRadian) {
  const double level = 20 * std::log10(contactFilter(ContactFilter::remington, 2 * M_PI * halfLength, halfLength));
  EXPECT_NEAR(level, -2.51735, 1e-4);
}

TEST(ContactFilter, HasNames) {
  for (const auto filter : {ContactFilter::none, ContactFilter::uniform, ContactFilter::remington})
    EXPECT_EQ(contactFilterFromText(toText(filter), "--contact-filter"), filter);
  EXPECT_THROW(contactFilterFromText("hertz", "--contact-filter"), CaseError);
}

}  // namespace
}  // namespace squat::roughness

#include "analysis/OptionText.h"

#include <gtest/gtest.h>

#include "core/Errors.h"

namespace squat::analysis {
namespace {

TEST(OptionText, bands) {
  const auto band = bandFromText("squat=250-350.5");
  EXPECT_EQ(band.name, "squat");
  EXPECT_EQ(band.low, 250);
  EXPECT_EQ(band.high, 350.5);
  EXPECT_EQ(bandFromText("130:320").name, "130:320 Hz");
  for (const auto* bad : {"", "130", "320-130", "a-b", "-5-10", "0-10", "130-320 Hz"})
    EXPECT_THROW(bandFromText(bad), CaseError) << bad;
}

TEST(OptionText, speedsAndDelimiters) {
  EXPECT_EQ(speedFromText("30"), 30);
  EXPECT_EQ(speedFromText("28.5 m/s"), 28.5);
  EXPECT_NEAR(speedFromText("108 km/h"), 30, 1e-12);
  for (const auto* bad : {"", "fast", "-3", "0", "30 s", "30 parsec"})
    EXPECT_THROW(speedFromText(bad), CaseError) << bad;
  EXPECT_EQ(delimiterFromText("auto"), 0);
  EXPECT_EQ(delimiterFromText("tab"), '\t');
  EXPECT_EQ(delimiterFromText("!"), '!');
  EXPECT_THROW(delimiterFromText("ab"), CaseError);
}

TEST(OptionText, windows) {
  signals::PowerSpectrumOptions options;
  setWindow(options, "blackman");
  setDetrend(options, "linear");
  EXPECT_EQ(options.window, signals::Window::blackman);
  EXPECT_EQ(options.detrend, signals::Detrend::linear);
  EXPECT_THROW(setWindow(options, "flat"), CaseError);
  EXPECT_THROW(setDetrend(options, "flat"), CaseError);
}

}  // namespace
}  // namespace squat::analysis

// One record in every form that loggers, spreadsheets and scripts give it: units, how they are stated, delimiters,
// decimal marks, clocks. Each is the control, sample by sample; none may be read as something else.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "readers/TemporaryFile.h"
#include "records/WholeRecord.h"

namespace squat::records {
namespace {

constexpr int formSamples = 600;
constexpr double formRate = 5000, formSpeed = 30;  // [Hz], [m/s]

struct FormUnits {
  const char *time, *position, *signal;
  double perSecond, perMetre, perAcceleration;
};
constexpr FormUnits formUnits[] = {{"s", "m", "m/s2", 1, 1, 1},
                                   {"ms", "km", "g", 1e3, 1e-3, 1 / 9.80665},
                                   {"us", "mm", "mm/s2", 1e6, 1e3, 1e3},
                                   {"msec", "m", "cm/s^2", 1e3, 1, 100}};

enum class Stated { brackets, parentheses, underscore, blank, row };

std::string heading(Stated stated, const std::string& name, const std::string& unit) {
  switch (stated) {
    case Stated::brackets:
      return name + " [" + unit + "]";
    case Stated::parentheses:
      return name + " (" + unit + ")";
    case Stated::underscore:
      return name + "_" + unit;
    case Stated::blank:
      return name + " " + unit;
    case Stated::row:
      return name;
  }
  return name;
}

std::string field(double value, char decimal, bool quoted) {
  char text[64];
  std::snprintf(text, sizeof text, "%.9f", value);
  std::string result = text;
  for (char& c : result) c = c == '.' ? decimal : c;
  return quoted ? '"' + result + '"' : result;
}

double signalAt(int i) { return 80 * std::sin(0.4 * i); }

std::string formOf(const FormUnits& units, Stated stated, char delimiter, char decimal, double start) {
  const bool quoted = delimiter == decimal;
  const std::string part(1, delimiter);
  std::string text = heading(stated, "time", units.time) + part + heading(stated, "position", units.position) + part +
                     heading(stated, "aba", units.signal) + "\n";
  if (stated == Stated::row) text += std::string(units.time) + part + units.position + part + units.signal + "\n";
  for (int i = 0; i < formSamples; ++i) {
    const double t = i / formRate;
    text += field((start + t) * units.perSecond, decimal, quoted) + part +
            field(formSpeed * t * units.perMetre, decimal, quoted) + part +
            field(signalAt(i) * units.perAcceleration, decimal, quoted) + "\n";
  }
  return text;
}

// Nine decimals are written: 1e-9 of a unit, at most 1e-6 m of a kilometre and 1e-8 m/s2 of g.
TEST(RecordForms, AreOneRecord) {
  int forms = 0;
  for (const auto& units : formUnits)
    for (const Stated stated : {Stated::brackets, Stated::parentheses, Stated::underscore, Stated::blank, Stated::row})
      for (const char delimiter : {',', ';', '\t'})
        for (const char decimal : {'.', ','})
          for (const double start : {0.0, 36000.0}) {
            ++forms;
            const auto text = formOf(units, stated, delimiter, decimal, start);
            SCOPED_TRACE(text.substr(0, 160));
            const tests::TemporaryFile file(text);
            const auto whole = readWhole(file.path());
            ASSERT_EQ(whole.layout.rate, formRate);
            ASSERT_EQ(whole.stretches.size(), 1u);
            const auto& all = whole.stretches[0];
            ASSERT_EQ(all.size(), static_cast<std::size_t>(formSamples));
            for (int i = 0; i < formSamples; ++i) {
              ASSERT_NEAR(all.values[0][static_cast<std::size_t>(i)], signalAt(i), 1e-7) << i;
              ASSERT_NEAR(all.position[static_cast<std::size_t>(i)], formSpeed * i / formRate, 2e-6) << i;
            }
          }
  EXPECT_GE(forms, 60);
}

}  // namespace
}  // namespace squat::records

#include "records/QuickNumber.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "text/Numbers.h"

namespace squat::records {
namespace {

// The careful reader is the reference: bit for bit the same number, or left to it.
void expectAsCareful(const std::string& field, char decimal = '.') {
  const std::string line = field + "\n";
  const char* at = line.data();
  double value = 0;
  if (!quickNumber(at, line.data() + line.size(), decimal, value)) return;
  const auto careful = text::numberIn(field, decimal);
  ASSERT_TRUE(careful) << field;
  EXPECT_EQ(value, *careful) << field;
  EXPECT_EQ(at, line.data() + field.size()) << field;
}

TEST(QuickNumber, readsWhatTheCarefulReaderReads) {
  for (const char* field : {"0",
                            "-0",
                            "1",
                            "+1",
                            "-12.5",
                            "0.1",
                            ".5",
                            "-.5",
                            "5.",
                            "1e3",
                            "1E-3",
                            "1.5e+22",
                            "1e23",
                            "1e-23",
                            "9007199254740991",
                            "9007199254740993",
                            "0.30000000000000004",
                            "1e400",
                            "1e-400",
                            "123456789012345678901234567890",
                            "0.00000000000000000000000000001",
                            "4.9e-324"})
    expectAsCareful(field);
  for (const char* field : {"1,5", "-0,001", ",5", "0,30000000000000004"}) expectAsCareful(field, ',');
}

TEST(QuickNumber, takesThePlainOnesItself) {
  for (const char* field : {"0.00004", "-12.345678", "1234.5", "3e2"}) {
    const std::string line = std::string(field) + ";";
    const char* at = line.data();
    double value = 0;
    EXPECT_TRUE(quickNumber(at, line.data() + line.size(), '.', value)) << field;
  }
}

TEST(QuickNumber, leavesTheRestAlone) {
  for (const char* field : {"", "-", ".", "nan", "-inf", "text", "e5", "1e", "1e+", "\"1\"", "#1"}) {
    const std::string line = std::string(field) + "\n";
    const char* at = line.data();
    double value = 0;
    if (quickNumber(at, line.data() + line.size(), '.', value)) {
      EXPECT_NE(at, line.data() + std::string(field).size()) << field;
    }
  }
}

TEST(QuickNumber, agreesOnRandomNumbers) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  std::uniform_int_distribution<int> power(-30, 30), digits(1, 18);
  for (int i = 0; i < 20000; ++i) {
    char text[64];
    std::snprintf(text, sizeof text, i % 2 ? "%.*e" : "%.*f", digits(random),
                  mantissa(random) * std::pow(10, power(random) / (i % 2 ? 1 : 6)));
    expectAsCareful(text);
  }
}

}  // namespace
}  // namespace squat::records

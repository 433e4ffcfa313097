// Damaged and absurd tables: whatever the bytes, the reader answers with signals or with one error, never a crash.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/Errors.h"
#include "readers/ArraySignals.h"
#include "readers/SignalFile.h"
#include "text/DelimitedTable.h"

namespace squat::readers {
namespace {

std::string randomDamage(std::string text, std::mt19937& random) {
  static const std::string letters = std::string("0123456789.,;\t |\"\r\n#%+-eE[]()nNaA\xFF\xEFxyz") + '\0';
  const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (std::size_t changes = pick(6); changes-- > 0 && !text.empty();) {
    const std::size_t at = pick(text.size());
    switch (pick(4)) {
      case 0:
        text[at] = letters[pick(letters.size())];
        break;
      case 1:
        text.erase(at, pick(8));
        break;
      case 2:
        text.insert(at, 1, letters[pick(letters.size())]);
        break;
      default:
        text.insert(at, text.substr(pick(text.size()), pick(40)));
    }
  }
  return text;
}

TEST(HostileTable, neverCrashes) {
  const std::string train =
      "Train 7\nt,km,\"aba, left\",run\n[s],[km],[g],\n"
      "0,12+000.0,1,1\n1,12+030.0,2,1\n2,12+060.0,4,1\n0,3,4,2\n1,4,5,2\n";
  const std::string seeds[] = {"time [s];aba [m/s2];speed [km/h]\n0,0;1,5;100\n0,1;2,5;101\n0,2;3,5;101\n0,3;3,5;101\n",
                               train, "# c\n0.001 1.5\n0.002 2.5\n0.003 -1e-3\n0.004 nan\n", "1\n2\n3\n4\n",
                               "1|2|\n3|4|\n5|6|\n"};
  std::mt19937 random(2014);
  SignalFileOptions options;
  options.column = "all";
  options.speed = 30;
  int read = 0, refused = 0;
  for (int i = 0; i < 30000; ++i) {
    const std::string text = randomDamage(seeds[i % 5], random);
    options.rate = i % 3 == 0 ? 1000 : 0;
    try {
      for (const auto& signal : signalsOf(text::parseDelimitedTable(text, "hostile"), options)) {
        ASSERT_GE(signal.signals[0].values.size(), 2u);
        ASSERT_TRUE(std::isfinite(signals::seriesOf(signal).step) && signals::seriesOf(signal).step > 0) << text;
        for (const double value : signal.signals[0].values) ASSERT_TRUE(std::isfinite(value)) << text;
        ASSERT_TRUE(signal.position.empty() || signal.position.size() == signal.signals[0].values.size());
        for (std::size_t k = 1; k < signal.position.size(); ++k)
          ASSERT_GT(signal.position[k], signal.position[k - 1]) << text;
        ++read;
      }
    } catch (const FileError& error) {
      ASSERT_NE(std::string(error.what()).find("hostile"), std::string::npos);
      ++refused;
    }
  }
  EXPECT_GT(read, 5000);
  EXPECT_GT(refused, 5000);
}

TEST(HostileTable, absurdShapesAreRefused) {
  EXPECT_THROW(text::parseDelimitedTable(std::string(3 << 20, '1'), "hostile"), FileError);  // a line of 3 MB
  std::string wide = "1";
  for (int i = 0; i < 5000; ++i) wide += ",2";
  EXPECT_THROW(text::parseDelimitedTable(wide + "\n" + wide + "\n", "hostile"), FileError);
  EXPECT_THROW(text::parseDelimitedTable("", "hostile"), FileError);
  EXPECT_THROW(text::parseDelimitedTable("\n\n\n", "hostile"), FileError);
  EXPECT_THROW(text::parseDelimitedTable("\"\"\"\"\"", "hostile"), FileError);
}

}  // namespace
}  // namespace squat::readers

// A German environment (decimal comma) changes no file and no number.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "core/DurableFile.h"
#include "results/ResultFile.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"
#include "trust/Program.h"
#include "trust/ShortCase.h"

namespace squat {
namespace {

using tests::call;
using tests::TemporaryFolder;

// Debian installs no locale by itself: one is made here.
std::vector<std::string> germanEnvironment(const TemporaryFolder& folder) {
  std::filesystem::create_directories(folder / "locales");
  const auto made = folder / "locales/de_DE.UTF-8";
  EXPECT_EQ(std::system(("localedef -i de_DE -f UTF-8 " + made).c_str()), 0) << "Debian package locales is needed";
  return {"LOCPATH=" + (folder / "locales"), "LC_ALL=de_DE.UTF-8", "LANG=de_DE.UTF-8"};
}

TEST(Locale, ADecimalCommaInTheEnvironmentChangesNothing) {
  const TemporaryFolder folder;
  const auto german = germanEnvironment(folder);
  const std::vector<std::string> plain{"LC_ALL=C"};
  std::string first, second;
  ASSERT_EQ(call({"describe", "light-defect", "--json"}, &first, plain), 0);
  ASSERT_EQ(call({"describe", "light-defect", "--json"}, &second, german), 0);
  EXPECT_EQ(first, second);

  ASSERT_EQ(call(tests::shortRun(folder / "plain"), &first, plain), 0) << first;
  ASSERT_EQ(call(tests::shortRun(folder / "german"), &second, german), 0) << second;
  constexpr std::size_t maximum = 100000000;
  EXPECT_EQ(readWholeFile(folder / "plain/light-defect.csv", maximum),
            readWholeFile(folder / "german/light-defect.csv", maximum));
  EXPECT_EQ(results::readResult(folder / "plain/light-defect.h5").caseToml,
            results::readResult(folder / "german/light-defect.h5").caseToml);

  ASSERT_EQ(
      call({"analyse", folder / "plain/light-defect.csv", "--column", "aba", "-o", folder / "plain"}, &first, plain), 0)
      << first;
  ASSERT_EQ(
      call({"analyse", folder / "plain/light-defect.csv", "--column", "aba", "-o", folder / "german"}, &second, german),
      0)
      << second;
  EXPECT_EQ(readWholeFile(folder / "plain/features.csv", maximum),
            readWholeFile(folder / "german/features.csv", maximum));
}

}  // namespace
}  // namespace squat

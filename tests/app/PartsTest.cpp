// squat detect and estimate in parts, as batch systems call them: the program itself, several processes on one folder.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/DurableFile.h"
#include "results/SampleResult.h"

namespace squat {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::HasSubstr;

class PartsTest : public ::testing::Test {
 protected:
  // Exit code of `squat WORDS` in the folder; `printed` gets what it says.
  int call(const std::string& words, std::string& printed) const {
    static std::atomic<int> calls = 0;
    const auto path = folder_ / ("said-" + std::to_string(++calls));
    const int status = std::system(
        ("cd '" + folder_.path() + "' && '" + SQUAT_PROGRAM + "' " + words + " > '" + path + "' 2>&1").c_str());
    printed = readWholeFile(path, 1000000);
    return WEXITSTATUS(status);
  }
  int call(const std::string& words) const {
    std::string printed;
    const int code = call(words, printed);
    EXPECT_EQ(code, 0) << printed;
    return code;
  }
  std::string file(const std::string& name) const { return readWholeFile(folder_ / name, 10000000); }
  // Two passes of the shipped record and a short one.
  void makeRecords() const {
    const auto record = readWholeFile(SQUAT_RECORD, 100000000);
    for (const char* name : {"a.csv", "b.csv"}) std::ofstream(folder_ / name) << record;
    std::ofstream(folder_ / "c.csv") << record.substr(0, record.find('\n', record.size() / 4) + 1);
  }
  const TemporaryFolder folder_;
};

TEST_F(PartsTest, DetectInPartsWritesTheBytesOfOneProcess) {
  makeRecords();
  const std::string records = "detect a.csv b.csv c.csv --speed 30 --no-figures ";
  call(records + "-o one");
  std::string said;
  EXPECT_EQ(call(records + "-o parts --collect", said), 4);
  EXPECT_THAT(said, HasSubstr("no candidates of a.csv, b.csv, c.csv"));
  call(records + "-o parts --partition slice:2/2");
  EXPECT_EQ(call(records + "-o parts --collect", said), 4);
  EXPECT_THAT(said, HasSubstr("no candidates of a.csv, c.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "parts/squats.csv")) << "nothing is written of half a list";
  call(records + "-o parts --partition slice:1/2");
  call(records + "-o parts --collect");
  for (const char* name : {"/squats.csv", "/squats.json", "/passages/squat-0001.csv"})
    EXPECT_EQ(file(std::string("parts") + name), file(std::string("one") + name)) << name;

  EXPECT_EQ(call("detect a.csv b.csv c.csv --speed 29 -o parts --collect", said), 2);
  EXPECT_THAT(said, HasSubstr("speed 30"));
  std::ofstream(folder_ / "b.csv", std::ios::app) << "1,2\n";
  EXPECT_EQ(call(records + "-o parts --collect", said), 4);
  EXPECT_THAT(said, HasSubstr("no candidates of b.csv: never searched, or changed since"));
}

// Eight processes at once, each part twice: whoever comes second is refused or finds the work done.
TEST_F(PartsTest, ManyProcessesLoseNothing) {
  makeRecords();
  const std::string records = "detect a.csv b.csv c.csv --speed 30 --no-figures -o parts ";
  {
    std::vector<std::jthread> processes;
    for (int i = 0; i < 8; ++i)
      processes.emplace_back([&, i] {
        std::string said;
        const int code = call(records + "--threads 1 --partition slice:" + std::to_string(1 + i % 4) + "/4", said);
        if (code != 0) {
          EXPECT_THAT(said, HasSubstr("must be a part that no other process computes"));
        }
      });
  }
  call(records + "--collect");
  call("detect a.csv b.csv c.csv --speed 30 --no-figures -o one");
  EXPECT_EQ(file("parts/squats.csv"), file("one/squats.csv"));
}

TEST_F(PartsTest, ABrokenRecordDoesNotStopTheOthers) {
  makeRecords();
  std::ofstream(folder_ / "b.csv") << "nothing\n";
  std::string said;
  EXPECT_EQ(call("detect a.csv b.csv c.csv --speed 30 -o parts --partition slice:1/1", said), 4);
  EXPECT_THAT(said, HasSubstr("b.csv"));
  EXPECT_THAT(said, HasSubstr("2 of 3 files done"));
  call("detect a.csv c.csv --speed 30 --no-figures -o parts --collect");
}

// Passages without an event fail at once; what they fail of is kept, listed and tried again.
TEST_F(PartsTest, EstimatesInPartsAreListed) {
  std::filesystem::create_directory(folder_ / "in");
  for (const char* name : {"in/a.csv", "in/b.csv"}) {
    std::ofstream signal(folder_ / name);
    signal << "time [s],aba [m/s2]\n";
    for (int i = 0; i < 2000; ++i) signal << i / 25000.0 << "," << (i % 7 - 3) << "\n";
  }
  const std::string passages = "estimate in/a.csv in/b.csv --case light-defect --each -o out ";
  std::string said;
  EXPECT_EQ(call(passages + "--partition slice:1/2", said), 4);
  EXPECT_THAT(said, HasSubstr("0 of 1 files done"));
  EXPECT_EQ(call(passages + "--collect", said), 4);
  EXPECT_THAT(said, HasSubstr("no estimates of in/b.csv"));
  EXPECT_EQ(call(passages + "--partition slice:2/2", said), 4);
  EXPECT_EQ(call(passages + "--collect", said), 4);
  EXPECT_THAT(said, HasSubstr("0 of 2 passages explained"));
  EXPECT_THAT(file("out/estimates.csv"), HasSubstr("in/b.csv,failed,"));

  EXPECT_EQ(call("estimate in/a.csv out/../in/a.csv --case light-defect --each -o out", said), 2);
  EXPECT_THAT(said, HasSubstr("must be files with names of their own"));
  EXPECT_EQ(call("estimate in/a.csv --case light-defect -o out --partition slice:1/2", said), 2);
  EXPECT_THAT(said, HasSubstr("--each"));
}

}  // namespace
}  // namespace squat

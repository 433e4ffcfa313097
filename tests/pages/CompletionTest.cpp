// Completion as bash itself computes it: the written file is read by bash, and its function asked word by word.
#include "pages/Completion.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "core/DurableFile.h"
#include "elasticity/SweptKernel.h"
#include "pages/Program.h"
#include "results/SampleResult.h"

namespace squat::pages {
namespace {

using squat::tests::TemporaryFolder;

class Completion : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { text = completion(callsOf(SQUAT_PROGRAM)); }

  // What bash offers for the last of the words, in a folder that holds oats.csv and the folder out.
  std::string offered(const std::string& words) const {
    std::filesystem::create_directories(folder_ / "place/out");
    writeDurably(folder_ / "place/oats.csv", std::string_view("1\n"));
    writeDurably(folder_ / "squat", std::string_view(text));
    writeDurably(folder_ / "ask",
                 "cd '" + (folder_ / "place") + "' && source ../squat && COMP_WORDS=(squat " + words +
                     ") && COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) && _squat && echo -n \"${COMPREPLY[*]}\"");
    const auto call = "bash '" + (folder_ / "ask") + "' > '" + (folder_ / "said") + "' 2>&1";
    EXPECT_EQ(std::system(call.c_str()), 0) << words;
    return readWholeFile(folder_ / "said", 100000);
  }

 private:
  TemporaryFolder folder_;
  static inline std::string text;
};

TEST_F(Completion, OfCommands) {
  EXPECT_EQ(offered("re"), "render report receptance");
  EXPECT_EQ(offered("figures ''"), "paper");
}

TEST_F(Completion, OfOptionsOfTheCommand) {
  EXPECT_EQ(offered("run --resum"), "--resume");
  EXPECT_EQ(offered("render --resum"), "");
  EXPECT_EQ(offered("figures paper --mes"), "--mesh");
}

TEST_F(Completion, OfValues) {
  EXPECT_EQ(offered("run --mesh ''"), "tiny draft standard paper");
  std::string sets;  // on x86 two
  for (const auto& name : elasticity::knownInstructionSets())
    if (name.starts_with("avx")) sets += (sets.empty() ? "" : " ") + name;
  EXPECT_EQ(offered("run light-defect --isa avx"), sets);
}

TEST_F(Completion, OfTheLastInAList) {
  EXPECT_EQ(offered("run --format p"), "png pdf");
  EXPECT_EQ(offered("run --format svg,p"), "svg,png svg,pdf");
}

TEST_F(Completion, OfCasesAndFiles) {
  EXPECT_EQ(offered("describe smoo"), "smooth-rail");
  EXPECT_EQ(offered("estimate oats.csv --case smoo"), "smooth-rail");
  EXPECT_EQ(offered("run o"), "oats.csv out");
  EXPECT_EQ(offered("run light-defect -o o"), "oats.csv out");
}

}  // namespace
}  // namespace squat::pages

// The page against one typed by hand, after man(7); and that every command of the program has one.
#include "pages/ManualPage.h"

#include <gmock/gmock.h>

#include "pages/Program.h"

namespace squat::pages {
namespace {

using ::testing::HasSubstr;

constexpr const char* kHelp = R"(Boil water
Usage: pot boil [OPTIONS] water

Options:
  -o,--output DIR             Where to\from (default: here)
  --fires N:INT in [1 - 8]    .fires of the house

Exit code 4: no water.
)";

constexpr const char* kPage = R"(.TH "POT-BOIL" 1 "" "Pots 1.0" "User commands"
.nh
.ad l
.SH NAME
pot\-boil \- boil water
.SH SYNOPSIS
\fBpot boil\fR [OPTIONS] water
.SH OPTIONS
.TP
\fB\-o\fR, \fB\-\-output\fR \fIDIR\fR
Where to\efrom (default: here)
.TP
\fB\-\-fires\fR \fIN\fR
\&.fires of the house. Range: 1 to 8
.SH EXIT STATUS
Exit code 4: no water.
.br
.SH SEE ALSO
\fBpot\fR(1)
)";

TEST(ManualPage, IsTheHelpInTheLanguageOfMan) {
  EXPECT_EQ(manualPage({"pot boil", helpFrom(kHelp), {"pot"}}, "Pots 1.0"), kPage);
}

TEST(ManualPage, EveryCommandOfTheProgramHasOne) {
  const auto calls = callsOf(SQUAT_PROGRAM);
  ASSERT_GT(calls.size(), 15U);
  EXPECT_EQ(calls.front().first, "squat");
  bool nested = false;
  for (const auto& [call, help] : calls) {
    nested = nested || call == "squat figures paper";
    EXPECT_NE(help.summary, "") << call;
    const auto page = manualPage({call, help, {}}, "Squat Studio");
    EXPECT_THAT(page, HasSubstr(".SH OPTIONS\n.TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR")) << call;
    for (const auto& section : help.sections)
      for (const auto& entry : section.entries) {
        EXPECT_NE(entry.text, "") << call << " " << entry.names.front();
        // What is left of the help's own marks was not understood.
        EXPECT_EQ(entry.value.find_first_of("{[<"), std::string::npos) << call << " " << entry.value;
        EXPECT_EQ(entry.value.find(":INT"), std::string::npos) << call << " " << entry.value;
      }
  }
  EXPECT_TRUE(nested);
}

TEST(ManualPage, AProgramThatFailsHasNone) { EXPECT_THROW(callsOf("/bin/false"), std::runtime_error); }

}  // namespace
}  // namespace squat::pages

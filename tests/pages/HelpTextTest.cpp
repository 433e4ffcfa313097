// Helps typed by hand after what CLI11 and Qt print, with every form of an entry that the programs use.
#include "pages/HelpText.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace squat::pages {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kCommand = R"(Boil water
Usage: pot boil [OPTIONS] water

Positionals:
  water WATER REQUIRED        A file (TOML), or of the house: tap, well

Options:
  -h,--help                   Print this help message and exit
  -o,--output DIR             Where to (default: here)
  --fires N:INT in [1 - 8]    Fires
  --degree C:20 to 1073741824 How hot (default: 100)
  --lid NAME:{glass,steel} Excludes: --open --wide
                              Lid: glass or steel (default: the nearest)
  --spices NAME,... ...       salt, pepper (default: all)
  --salt FILE Needs: --spices
                              For a cook's loop; grams
                              and no more
  --open                      No lid

Spices:
  salt      White
  pepper    Black or white

Exit code 4: no water.
)";

constexpr const char* kWindow = R"(Usage: /a/b/pot-window [options] [POT]
See it boil.

Options:
  -v, --version           Displays version information.
  --tab <NAME>            Tab to show: steam, water,
                          bubbles.

Arguments:
  pot                     Pot to open.
)";

const HelpEntry& named(const HelpText& help, const std::string& name) {
  for (const auto& section : help.sections)
    for (const auto& entry : section.entries)
      for (const auto& own : entry.names)
        if (own == name) return entry;
  throw std::runtime_error("no entry " + name);
}

TEST(HelpText, OfACommand) {
  const auto help = helpFrom(kCommand);
  EXPECT_EQ(help.summary, "Boil water");
  EXPECT_EQ(help.usage, "pot boil [OPTIONS] water");
  EXPECT_EQ(help.of("Options").size(), 8U);
  EXPECT_THAT(help.of("Subcommands"), IsEmpty());
  EXPECT_THAT(help.footer, ElementsAre("Exit code 4: no water."));
}

TEST(HelpText, NamesValuesAndRanges) {
  const auto help = helpFrom(kCommand);
  EXPECT_THAT(named(help, "-o").names, ElementsAre("-o", "--output"));
  EXPECT_EQ(named(help, "-o").value, "DIR");
  EXPECT_EQ(named(help, "-h").value, "");
  EXPECT_EQ(named(help, "--fires").value, "N");
  EXPECT_EQ(named(help, "--fires").range, "1 to 8");
  EXPECT_EQ(named(help, "--degree").range, "20 to 1073741824");  // so long that one blank is left
  EXPECT_EQ(named(help, "--degree").text, "How hot (default: 100)");
  EXPECT_EQ(named(help, "--lid").excludes, "--open --wide");
  EXPECT_EQ(named(help, "--salt").needs, "--spices");
  EXPECT_EQ(named(help, "--salt").text, "For a cook's loop; grams and no more");
  EXPECT_EQ(named(help, "water").value, "WATER");
}

TEST(HelpText, ChoicesFromBracesOrFromTheSentence) {
  const auto help = helpFrom(kCommand);
  EXPECT_THAT(named(help, "--lid").choices, ElementsAre("glass", "steel"));
  EXPECT_THAT(named(help, "--spices").choices, ElementsAre("salt", "pepper"));
  EXPECT_TRUE(named(help, "--spices").isList);
  EXPECT_THAT(named(help, "water").choices, ElementsAre("tap", "well"));
  EXPECT_THAT(named(help, "-o").choices, IsEmpty());
  EXPECT_THAT(named(help, "--salt").choices, IsEmpty());
}

TEST(HelpText, OfTheStudio) {
  const auto help = helpFrom(kWindow);
  EXPECT_EQ(help.summary, "See it boil.");
  EXPECT_THAT(named(help, "-v").names, ElementsAre("-v", "--version"));
  EXPECT_EQ(named(help, "--tab").value, "NAME");
  EXPECT_THAT(named(help, "--tab").choices, ElementsAre("steam", "water", "bubbles"));
  EXPECT_EQ(named(help, "pot").text, "Pot to open.");
}

TEST(HelpText, AnErrorIsNoHelp) { EXPECT_THROW(helpFrom("cannot open display\n"), std::runtime_error); }

}  // namespace
}  // namespace squat::pages

// Which channels of a record are the two axle boxes of one wheelset.
#include "detection/Axles.h"

#include <gmock/gmock.h>

#include "core/Errors.h"
#include "core/Monitor.h"
#include "detection/Detect.h"
#include "readers/TemporaryFile.h"
#include "text/Csv.h"

namespace squat::detection {
namespace {

records::RecordLayout recordOf(const std::vector<std::string>& names) {
  records::RecordLayout layout;
  layout.path = "ride.csv";
  for (const auto& name : names) layout.channels.push_back({name, "m/s2"});
  return layout;
}

std::vector<std::pair<std::string, std::string>> found(const std::vector<std::string>& names,
                                                       const AxleNames& axles = {}) {
  const auto layout = recordOf(names);
  std::vector<std::string> notes;
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const auto& axle : axlesOf(layout, axles, notes))
    pairs.emplace_back(layout.channels[axle.left].name, layout.channels[axle.right].name);
  return pairs;
}

using Pairs = std::vector<std::pair<std::string, std::string>>;

TEST(Axles, AreFoundWhereNamesDifferInTheWordForTheSide) {
  EXPECT_EQ(found({"axle 1 right", "axle 1 left"}), (Pairs{{"axle 1 left", "axle 1 right"}}));
  EXPECT_EQ(found({"ABA_L", "ABA_R"}), (Pairs{{"ABA_L", "ABA_R"}}));
  EXPECT_EQ(found({"aba", "aba_right"}), (Pairs{{"aba", "aba_right"}}));
  EXPECT_EQ(found({"L accélération", "R accélération"}), (Pairs{{"L accélération", "R accélération"}}));
  EXPECT_EQ(found({"left front", "right front", "left rear", "right rear"}),
            (Pairs{{"left front", "right front"}, {"left rear", "right rear"}}));
}

// "l" inside a word is no side, one wheelset has no three boxes, and a left one alone has no partner.
TEST(Axles, AreNotFoundWhereNamesLeaveDoubt) {
  EXPECT_EQ(found({"lateral", "rateral"}), Pairs{});
  EXPECT_EQ(found({"box left", "front left"}), Pairs{});
  EXPECT_EQ(found({"left", "right", "Right"}), Pairs{});
  EXPECT_EQ(found({"axle 1 left", "axle 2 right"}), Pairs{});
  EXPECT_EQ(found({"aba_lateral", "aba_lateral_right"}), Pairs{});
}

// What was guessed is said; what was stated needs no word.
TEST(Axles, ThatWereFoundByNamesAreReported) {
  std::vector<std::string> notes;
  const auto layout = recordOf({"left", "right"});
  axlesOf(layout, {}, notes);
  EXPECT_THAT(notes, ::testing::ElementsAre(::testing::HasSubstr("'left' and 'right' are assumed, from their names")));
  notes.clear();
  axlesOf(layout, axleNamesFromText({"left,right"}), notes);
  EXPECT_TRUE(notes.empty());
}

TEST(Axles, ThatAreNamedCountAloneAndNoneMeansNone) {
  EXPECT_EQ(found({"a", "b", "left", "right"}, axleNamesFromText({"b, a"})), (Pairs{{"b", "a"}}));
  EXPECT_EQ(found({"left", "right"}, axleNamesFromText({"none"})), Pairs{});
}

// As in a CSV file: what stands in quotes is one name, two quotes are one of it. A quote within a name is no such
// quote.
TEST(Axles, NamesInQuotesMayHoldACommaAndQuotes) {
  const auto named = [](const std::string& text) { return axleNamesFromText({text}).value(); };
  EXPECT_EQ(named(R"("a,b",c)"), (Pairs{{"a,b", "c"}}));
  EXPECT_EQ(named(R"( c , "a, b" )"), (Pairs{{"c", "a, b"}}));
  EXPECT_EQ(named(R"("box ""1"", left","""right""")"), (Pairs{{R"(box "1", left)", R"("right")"}}));
  EXPECT_EQ(named(R"(5" left,5" right)"), (Pairs{{R"(5" left)", R"(5" right)"}}));
  EXPECT_EQ(named("a;b,c;d"), (Pairs{{"a;b", "c;d"}}));
  for (const auto& name : {"a,b", "\"", "\",\"", "a \"b\"", "\"a", "a;b", " a", "a ", "none", "plain name"}) {
    const auto written = quotedAxleName(name);
    EXPECT_EQ(named(written + ",other"), (Pairs{{name, "other"}})) << written;
    EXPECT_EQ(named("other," + written), (Pairs{{"other", name}})) << written;
    EXPECT_EQ(axleNamesFromLine("c,d;other," + written).value(), (Pairs{{"c", "d"}, {"other", name}})) << written;
  }
  EXPECT_EQ(quotedAxleName("plain name"), "plain name");
  EXPECT_EQ(found({"box, left", "box, right"}, axleNamesFromText({R"("box, left","box, right")"})),
            (Pairs{{"box, left", "box, right"}}));
}

TEST(Axles, OfOneLineStandBetweenSemicolons) {
  EXPECT_FALSE(axleNamesFromLine(" "));
  EXPECT_EQ(axleNamesFromLine(" none ").value(), Pairs{});
  EXPECT_EQ(axleNamesFromLine("a, b").value(), (Pairs{{"a", "b"}}));
  EXPECT_EQ(axleNamesFromLine(R"(a,b; "c;1","d,2")").value(), (Pairs{{"a", "b"}, {"c;1", "d,2"}}));
  for (const char* line : {"a", "a;b", "a,b;", "a,b,c", "a,b;c", ";", "a,b;none"})
    EXPECT_THROW(axleNamesFromLine(line), CaseError) << line;
}

// A millisecond, which separates what the other box feels from the impact itself, has two samples at 2 kHz.
TEST(Axles, OfSlowlySampledRecordsTellNoSides) {
  std::string text = "time [s],left [m/s2],right [m/s2]\n";
  for (int i = 0; i < 4000; ++i) text += std::to_string(i / 2000.0) + "," + std::to_string(i % 7) + ",1\n";
  const tests::TemporaryFile file(text);
  records::RecordOptions read;
  read.columns.speed = 30, read.everyAcceleration = true;
  Monitor monitor;
  const auto found = findCandidates(*records::openRecord(file.path(), read), {}, monitor);
  EXPECT_TRUE(found.axles.empty());
  EXPECT_THAT(found.notes, ::testing::Contains(::testing::HasSubstr("too slow to tell which axle box moves first")));
}

TEST(Axles, ThatCannotBeAreRefused) {
  for (const char* text : {"left", "left,", ",right", "left,left", "a,b,c", R"("a,b)", R"("a"b,c)", R"(a,"b" c)",
                           R"("a,b")", R"("","b")", R"("a",a)"})
    EXPECT_THROW(axleNamesFromText({text}), CaseError) << text;
  EXPECT_THROW(found({"a", "b"}, axleNamesFromText({"a,c"})), FileError);
  EXPECT_THROW(found({"a", "b", "c"}, axleNamesFromText({"a,b", "c,a"})), CaseError);
}

// Names with commas and one too many outside quotes: the error says how they are written.
TEST(Axles, AMessageSaysHowNamesWithCommasAreWritten) {
  const auto message = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(message([] { axleNamesFromText({"box, left,box, right"}); }),
              ::testing::AllOf(::testing::HasSubstr("axle is box, left,box, right"),
                               ::testing::HasSubstr(R"(in double quotes: "box, left","box, right")")));
  EXPECT_THAT(message([] { axleNamesFromText({R"("box, left,right)"}); }), ::testing::HasSubstr("ends with a quote"));
  EXPECT_THAT(message([] {
                found({"box, left", "other"}, axleNamesFromText({"box,other"}));
              }),
              ::testing::HasSubstr(R"(Its channels: "box, left", other)"));
}

}  // namespace
}  // namespace squat::detection

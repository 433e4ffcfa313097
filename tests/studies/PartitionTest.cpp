#include "studies/Partition.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "core/Errors.h"
#include "studies/StubStudy.h"

namespace squat::studies {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    partitionFromText(text);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Partition, isReadAndWritten) {
  for (const auto* text : {"slice:1/1", "slice:3/16", "hash:16/16", "hash:10000/10000"})
    EXPECT_EQ(toText(partitionFromText(text)), text);
  EXPECT_EQ(stemOf(partitionFromText("slice:3/16")), "study-slice-3-of-16");
  EXPECT_EQ(stemOf(partitionFromText("hash:3/16"), "detect"), "detect-hash-3-of-16");
  EXPECT_EQ(familyOf(partitionFromText("hash:3/16")), "hash:16");
  EXPECT_EQ(familyFromText("hash:16"), partitionFromText("hash:1/16"));
}

TEST(Partition, wrongOnesAreNamed) {
  EXPECT_THAT(refusal("slice:5/4"), HasSubstr("--partition is slice:5/4, must be M from 1 to N"));
  EXPECT_THAT(refusal("slice:0/4"), HasSubstr("M from 1 to N"));
  EXPECT_THAT(refusal("slice:1/0"), HasSubstr("N from 1 to 10000"));
  EXPECT_THAT(refusal("slice:1/10001"), HasSubstr("N from 1 to 10000"));
  for (const auto* text : {"", "slice", "slice:", "slice:1", "1/4", "count:1/4", "slice:a/4", "slice:1/4x",
                           "slice:-1/4", "slice: 1/4", "slice:1/", "slice:1.5/4"})
    EXPECT_THAT(refusal(text), HasSubstr("slice:M/N or hash:M/N")) << text;
}

// Every point belongs to one part; slices differ by one point at most.
TEST(Partition, partsShareAllPoints) {
  const auto study = stubStudy(25, 9);
  for (const auto* kind : {"slice:", "hash:"}) {
    std::size_t smallest = 1000, largest = 0, all = 0;
    for (int part = 1; part <= 16; ++part) {
      const auto partition = partitionFromText(kind + std::to_string(part) + "/16");
      std::size_t points = 0;
      for (const auto& point : gridOf(study)) points += isInPart(partition, study, point);
      smallest = std::min(smallest, points), largest = std::max(largest, points), all += points;
    }
    EXPECT_EQ(all, 225U) << kind;
    if (std::string(kind) == "slice:") {
      EXPECT_EQ(largest - smallest, 1U);
    }
    EXPECT_GT(smallest, 0U) << kind;
  }
}

// Files go round robin by slice, and by their names alone by hash.
TEST(Partition, filesHaveTheirParts) {
  const auto slice = partitionFromText("slice:1/3"), hash = partitionFromText("hash:1/3");
  EXPECT_EQ(partOf(slice, 0, "a.csv"), 1U);
  EXPECT_EQ(partOf(slice, 5, "a.csv"), 3U);
  EXPECT_EQ(partOf(hash, 0, "a.csv"), partOf(hash, 5, "a.csv"));
  std::set<std::size_t> parts;
  for (int i = 0; i < 30; ++i) parts.insert(partOf(hash, 0, std::to_string(i) + ".csv"));
  EXPECT_EQ(parts, (std::set<std::size_t>{1, 2, 3}));
}

// 25 lengths hold the 13 lengths of before: each of those keeps its part by hash, though not its place in the grid.
TEST(Partition, aPointKeepsItsPartByHash) {
  std::map<std::string, std::size_t> before;
  const auto family = familyFromText("hash:7");
  for (const auto& point : gridOf(stubStudy(13, 3)))
    before[toText(stubStudy(13, 3), point)] = partOf(family, stubStudy(13, 3), point);
  std::size_t seen = 0;
  for (const auto& point : gridOf(stubStudy(25, 3)))
    if (const auto found = before.find(toText(stubStudy(25, 3), point)); found != before.end()) {
      EXPECT_EQ(found->second, partOf(family, stubStudy(25, 3), point)) << found->first;
      ++seen;
    }
  EXPECT_EQ(seen, before.size());
}

}  // namespace
}  // namespace squat::studies

#include "results/Checkpoint.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"
#include "results/TreeStream.h"

namespace squat::results {
namespace {

using ::testing::HasSubstr;
using tests::TemporaryFolder;

ArrayTree sampleState(double first = 0.5) {
  ArrayTree state;
  setAttribute(state.attributes, "isa", std::string("avx2"));
  setAttribute(state.attributes, "step", std::int64_t{1} << 40);
  state.add("/state/displacement", std::vector<double>{first, -0.0, 1e-300, 5e-324}, "m", {2, 2});
  state.add("/state/slip", std::vector<std::uint8_t>{0, 1, 1}, "1");
  state.add("/names", std::vector<std::string>{"", "two"}, "1");
  state.add("/empty", std::vector<float>{}, "1");
  state.addScalar("/time", 0.125, "s");
  return state;
}

TEST(Checkpoint, GivesBackEveryBit) {
  const TemporaryFolder folder;
  writeCheckpoint(folder / "c", sampleState());
  bool usedPrevious = true;
  const auto back = readCheckpoint(folder / "c", &usedPrevious);
  ASSERT_TRUE(back.has_value());
  auto expected = sampleState();
  setAttribute(expected.attributes, "schema", std::string("squat-checkpoint"));
  setAttribute(expected.attributes, "schema_version", std::int64_t{kCheckpointVersion});
  EXPECT_EQ(firstDifference(*back, expected), "");
  EXPECT_FALSE(usedPrevious);
}

TEST(Checkpoint, NoneIsNoError) {
  const TemporaryFolder folder;
  EXPECT_FALSE(readCheckpoint(folder / "c").has_value());
}

TEST(Checkpoint, KeepsThePreviousOneAndFallsBackToIt) {
  const TemporaryFolder folder;
  writeCheckpoint(folder / "c", sampleState(1));
  writeCheckpoint(folder / "c", sampleState(2));
  std::ofstream(folder / "c", std::ios::binary | std::ios::trunc) << "half writ";
  bool usedPrevious = false;
  const auto back = readCheckpoint(folder / "c", &usedPrevious);
  ASSERT_TRUE(back.has_value());
  EXPECT_TRUE(usedPrevious);
  EXPECT_EQ(std::get<std::vector<double>>(back->find("/state/displacement")->values)[0], 1);
  removeCheckpoint(folder / "c");
  EXPECT_FALSE(readCheckpoint(folder / "c").has_value());
}

TEST(Checkpoint, ANotANumberNeverReplacesAGoodOne) {
  const TemporaryFolder folder;
  writeCheckpoint(folder / "c", sampleState(1));
  try {
    writeCheckpoint(folder / "c", sampleState(std::nan("")));
    FAIL() << "written";
  } catch (const FileError& error) {
    EXPECT_EQ(error.location(), "/state/displacement");
  }
  EXPECT_EQ(std::get<std::vector<double>>(readCheckpoint(folder / "c")->find("/state/displacement")->values)[0], 1);
}

TEST(Checkpoint, EveryFlippedBitAndEveryTruncationIsFound) {
  const TemporaryFolder folder;
  writeCheckpoint(folder / "good", sampleState());
  const auto good = readWholeFile(folder / "good", 100000);
  for (std::size_t i = 0; i < good.size(); ++i) {
    auto bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
    EXPECT_THROW(decodeTree(sourceOf(std::as_bytes(std::span(bad))), "bad", 100000), FileError) << "byte " << i;
    const auto cut = good.substr(0, i);
    EXPECT_THROW(decodeTree(sourceOf(std::as_bytes(std::span(cut))), "cut", 100000), FileError) << "length " << i;
  }
  const auto longer = good + "x";
  EXPECT_THROW(decodeTree(sourceOf(std::as_bytes(std::span(longer))), "longer", 100000), FileError);
}

TEST(Checkpoint, ANewerVersionIsRefusedWithAdvice) {
  const TemporaryFolder folder;
  auto state = sampleState();
  setAttribute(state.attributes, "schema", std::string("squat-checkpoint"));
  setAttribute(state.attributes, "schema_version", std::int64_t{kCheckpointVersion + 1});
  writeDurably(folder / "c", encodeTree(state));
  try {
    readCheckpoint(folder / "c");
    FAIL() << "read";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("newer version"));
  }
}

TEST(Checkpoint, AClaimedLengthTakesNoMemory) {
  std::string bytes = "SQTREE01";
  bytes += '\3';
  const std::uint64_t length = std::uint64_t{1} << 40;
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  EXPECT_THROW(decodeTree(sourceOf(std::as_bytes(std::span(bytes))), "claim", std::size_t{1} << 41), FileError);
}

TEST(TreeStream, ChecksumIsTheStandardOne) {
  const std::string check = "123456789";  // check value of CRC-32/ISO-HDLC: 0xCBF43926
  EXPECT_EQ(crc32(std::as_bytes(std::span(check))), 0xCBF43926U);
}

}  // namespace
}  // namespace squat::results

// Wave files, made byte by byte after the RIFF and the EBU's RF64 documents; full scale of n bits is 2^(n-1).
#include "loggers/WavFile.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/Errors.h"

namespace squat::loggers {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string wavLittle(std::uint64_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
  return bytes;
}

std::string wavPiece(const std::string& name, const std::string& body) {
  return name + wavLittle(body.size(), 4) + body + (body.size() % 2 ? std::string(1, '\0') : "");
}

std::string wavFmt(int code, int channels, int rate, int bits) {
  const int frame = channels * bits / 8;
  return wavPiece("fmt ",
                  wavLittle(static_cast<std::uint64_t>(code), 2) + wavLittle(static_cast<std::uint64_t>(channels), 2) +
                      wavLittle(static_cast<std::uint64_t>(rate), 4) +
                      wavLittle(static_cast<std::uint64_t>(rate) * static_cast<std::uint64_t>(frame), 4) +
                      wavLittle(static_cast<std::uint64_t>(frame), 2) + wavLittle(static_cast<std::uint64_t>(bits), 2));
}

std::string wavRiff(const std::string& chunks) { return "RIFF" + wavLittle(chunks.size() + 4, 4) + "WAVE" + chunks; }

std::string wavInfo(const std::string& comment) {
  return wavPiece("LIST", "INFO" + wavPiece("INAM", "a") + wavPiece("ICMT", comment + std::string(1, '\0')));
}

std::string wavError(const std::string& bytes) {
  try {
    parseWavFile(bytes, "test.wav");
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

const char* const wavUncalibrated = "full scale is 1: give the calibration, which the file does not name";

TEST(WavFile, IsKnownByItsForm) {
  EXPECT_TRUE(isWavFile("RIFF....WAVEfmt "));
  EXPECT_TRUE(isWavFile("RF64....WAVE"));
  EXPECT_FALSE(isWavFile("RIFF....AVI "));
  EXPECT_FALSE(isWavFile("RIFF"));
  EXPECT_THAT(wavError("t,a\n0,1\n"), HasSubstr("is not a wave file"));
}

TEST(WavFile, SixteenBitsInTwoChannels) {
  const std::string samples = wavLittle(0x4000, 2) + wavLittle(0x8000, 2) + wavLittle(0xFFFF, 2) + wavLittle(0, 2);
  const auto read = parseWavFile(wavRiff(wavFmt(1, 2, 51200, 16) + wavPiece("data", samples)), "test.wav");
  EXPECT_EQ(read.rate, 51200);
  ASSERT_THAT(read.table.columns, SizeIs(2));
  EXPECT_EQ(read.table.columns[0].name, "channel 1");
  EXPECT_EQ(read.table.columns[1].name, "channel 2");
  EXPECT_EQ(read.table.columns[0].unit, "");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(0.5, -1.0 / 32768));
  EXPECT_THAT(read.table.columns[1].values, ElementsAre(-1, 0));
  EXPECT_THAT(read.table.lines, ElementsAre(1, 2));
  EXPECT_EQ(read.table.rowWord, "sample");
  EXPECT_THAT(read.notes, ElementsAre(wavUncalibrated));
}

TEST(WavFile, OtherSizesOfWholeNumbers) {
  const auto values = [](int bits, const std::string& samples) {
    return parseWavFile(wavRiff(wavFmt(1, 1, 1000, bits) + wavPiece("data", samples)), "test.wav")
        .table.columns[0]
        .values;
  };
  EXPECT_THAT(values(8, std::string("\x00\x80\xC0", 3)), ElementsAre(-1, 0, 0.5));
  EXPECT_THAT(values(24, wavLittle(0x200000, 3) + wavLittle(0xC00000, 3)), ElementsAre(0.25, -0.5));
  EXPECT_THAT(values(32, wavLittle(0x10000000, 4) + wavLittle(0x80000000, 4)), ElementsAre(0.125, -1));
}

TEST(WavFile, FloatingPointStaysAsItIs) {
  const auto single = parseWavFile(
      wavRiff(wavFmt(3, 1, 1000, 32) + wavPiece("data", wavLittle(std::bit_cast<std::uint32_t>(-37.5F), 4))),
      "test.wav");
  EXPECT_THAT(single.table.columns[0].values, ElementsAre(-37.5));
  const auto twice =
      parseWavFile(wavRiff(wavFmt(3, 1, 1000, 64) +
                           wavPiece("data", wavLittle(std::bit_cast<std::uint64_t>(0.1), 8) +
                                                wavLittle(std::bit_cast<std::uint64_t>(INFINITY + 0.0), 8))),
                   "test.wav");
  EXPECT_EQ(twice.table.columns[0].values[0], 0.1);
  EXPECT_TRUE(std::isnan(twice.table.columns[0].values[1]));
  EXPECT_EQ(twice.table.columns[0].badRow, 1);
  EXPECT_EQ(twice.table.columns[0].badText, "infinity");
}

TEST(WavFile, ExtensibleFormatsNameTheirCodeFurtherOn) {
  // 20 valid bits in the upper part of 24.
  std::string format = wavFmt(0xFFFE, 1, 1000, 24).substr(8);
  format += wavLittle(22, 2) + wavLittle(20, 2) + wavLittle(0, 4) + wavLittle(1, 2) +
            std::string("\x00\x00\x00\x00\x10\x00\x80\x00\x00\xAA\x00\x38\x9B\x71", 14);
  const auto read =
      parseWavFile(wavRiff(wavPiece("fmt ", format) + wavPiece("data", wavLittle(0x400000, 3))), "test.wav");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(0.5));
}

TEST(WavFile, LongFilesStateTheirSizeInDs64) {
  const std::string sizes = wavPiece("ds64", wavLittle(100, 8) + wavLittle(4, 8) + wavLittle(2, 8) + wavLittle(0, 4));
  const std::string file = "RF64" + wavLittle(0xFFFFFFFF, 4) + "WAVE" + sizes + wavFmt(1, 1, 1000, 16) + "data" +
                           wavLittle(0xFFFFFFFF, 4) + wavLittle(0x4000, 2) + wavLittle(0x2000, 2) + wavInfo("FS=50 g");
  const auto read = parseWavFile(file, "test.wav");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(25, 12.5));
  EXPECT_EQ(read.table.columns[0].unit, "g");
}

TEST(WavFile, CalibrationStandsInTheComment) {
  struct Written {
    const char *comment, *unit;
    double half;  // the value of half of full scale
  };
  const std::string format = wavFmt(1, 1, 1000, 16), data = wavPiece("data", wavLittle(0x4000, 2));
  for (const auto& one : {Written{"1.0 = 500 m/s2", "m/s2", 250},
                          {"full scale 500 m/s2", "m/s2", 250},
                          {"FS=50 g", "g", 25},
                          {"Left box. Full Scale: 1e3 m/s^2.", "m/s^2", 500},
                          {"IEPE, 1 = 80.5 m/s", "m/s", 40.25},
                          {"FS=50g", "g", 25},
                          {"full scale 50 g, 1.0 = 50 g", "g", 25},
                          {"FS = 48000 Hz", "", 0.5},
                          {"full scale 50 foo", "", 0.5},
                          {"offs=50 g", "", 0.5},
                          {"channel 1 = 50 g", "", 0.5},
                          {"full scale 50 g; full scale 20 g", "", 0.5},
                          {"full scale -5 g", "", 0.5},
                          {"full scale", "", 0.5}}) {
    const auto read = parseWavFile(wavRiff(format + wavInfo(one.comment) + data), "test.wav");
    EXPECT_EQ(read.table.columns[0].values[0], one.half) << one.comment;
    EXPECT_EQ(read.table.columns[0].unit, one.unit) << one.comment;
    ASSERT_THAT(read.notes, SizeIs(1));
    EXPECT_EQ(read.notes[0].starts_with("full scale is 1:"), *one.unit == '\0') << one.comment;
  }
  std::string description = "axle box, full scale 200 m/s2";
  description.resize(602);
  const auto read = parseWavFile(wavRiff(wavPiece("bext", description) + format + data), "test.wav");
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(100));
  EXPECT_THAT(read.notes, ElementsAre("full scale is 200 m/s2, as the comment says"));
}

TEST(WavFile, FilesThatEndEarlyAreReadToTheirEnd) {
  const std::string head = wavFmt(1, 2, 1000, 16), frame = wavLittle(0x4000, 2) + wavLittle(0x2000, 2);
  const auto cut = parseWavFile(wavRiff(head + "data" + wavLittle(4000, 4) + frame + frame + "x"), "test.wav");
  EXPECT_THAT(cut.table.columns[1].values, ElementsAre(0.25, 0.25));
  EXPECT_THAT(cut.notes, ElementsAre("the file ends before its samples do: read to its end",
                                     "the last frame is not whole: left out", wavUncalibrated));
  // A recorder without power has not come back to write the sizes.
  for (const std::uint64_t size : {std::uint64_t{0}, std::uint64_t{0xFFFFFFFF}}) {
    const auto open =
        parseWavFile("RIFF" + wavLittle(0, 4) + "WAVE" + head + "data" + wavLittle(size, 4) + frame, "test.wav");
    EXPECT_THAT(open.table.columns[0].values, ElementsAre(0.5));
    EXPECT_THAT(open.notes, Contains("the length of the samples was not written: read to the end of the file"));
  }
}

TEST(WavFile, IsReadFromItsPath) {
  const std::string path = testing::TempDir() + "squat-loggers-" + std::to_string(::getpid()) + ".wav";
  std::ofstream(path, std::ios::binary) << wavRiff(wavFmt(1, 1, 1000, 16) + wavPiece("data", wavLittle(0x4000, 2)));
  const auto read = readWavFile(path);
  std::filesystem::remove(path);
  EXPECT_THAT(read.table.columns[0].values, ElementsAre(0.5));
  EXPECT_EQ(read.table.path, path);
  EXPECT_THROW(readWavFile(path), FileError);
}

TEST(WavFile, DamageIsNamed) {
  const std::string data = wavPiece("data", "abcd");
  EXPECT_THAT(wavError(wavRiff(data)), HasSubstr("chunk fmt: is missing"));
  EXPECT_THAT(wavError(wavRiff(wavPiece("fmt ", "ab") + data)), HasSubstr("shorter than 16 bytes"));
  EXPECT_THAT(wavError(wavRiff(wavFmt(0x55, 1, 1000, 16) + data)), HasSubstr("names MP3, which is not read"));
  EXPECT_THAT(wavError(wavRiff(wavFmt(0xFFFE, 1, 1000, 16) + data)), HasSubstr("shorter than the 40 bytes"));
  EXPECT_THAT(wavError(wavRiff(wavFmt(1, 0, 1000, 16) + data)), HasSubstr("states no channels"));
  EXPECT_THAT(wavError(wavRiff(wavFmt(1, 1, 0, 16) + data)), HasSubstr("sampling rate of 0 Hz"));
  EXPECT_THAT(wavError(wavRiff(wavFmt(1, 1, 1000, 64) + data)), HasSubstr("states 64 bits a sample"));
  EXPECT_THAT(wavError(wavRiff(wavFmt(3, 1, 1000, 16) + data)), HasSubstr("must be 32 or 64"));
  EXPECT_THAT(wavError(wavRiff(wavFmt(1, 1, 1000, 16))), HasSubstr("chunk data: is missing"));
  EXPECT_THAT(wavError(wavRiff(wavFmt(1, 4, 1000, 16) + data)), HasSubstr("holds no sample of every channel"));
  std::string frames = wavFmt(1, 1, 1000, 16);
  frames[8 + 12] = 7;
  EXPECT_THAT(wavError(wavRiff(frames + data)), HasSubstr("states frames of 7 bytes, must be 2"));
}

}  // namespace
}  // namespace squat::loggers

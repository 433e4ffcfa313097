// The same record in the files of several measuring programs, written by hand here, goes through the readers of
// records and of short signals alike: rate and unit come from the file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "readers/SignalFile.h"
#include "readers/TemporaryFile.h"
#include "records/WholeRecord.h"

namespace squat::records {
namespace {

constexpr int loggerSamples = 800;
constexpr double loggerRate = 5000;  // [Hz]

double inG(int i) { return 3 * std::sin(0.4 * i); }

std::string labviewText() {
  std::string text =
      "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t.\n"
      "Multi_Headings\tNo\nX_Columns\tOne\nTime_Pref\tRelative\n***End_of_Header***\t\n\t\nChannels\t1\t\n"
      "Samples\t800\t\nDate\t2026/11/27\t\nTime\t09:30:00\t\nY_Unit_Label\tg\t\nX_Dimension\tTime\t\nX0\t0.0\t\n"
      "Delta_X\t0.000200\t\n***End_of_Header***\t\t\nX_Value\taxle box\tComment\n";
  char row[80];
  for (int i = 0; i < loggerSamples; ++i) {
    std::snprintf(row, sizeof row, "%.6f\t%.9f\t\n", i / loggerRate, inG(i));
    text += row;
  }
  return text;
}

template <class Number>
void put(std::string& bytes, Number value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);  // this machine is little-endian, as WAV is
  bytes.append(raw, sizeof value);
}

std::string wavBytes() {
  std::string data, format;
  for (int i = 0; i < loggerSamples; ++i) put(data, static_cast<float>(inG(i) / 50));
  put<std::uint16_t>(format, 3), put<std::uint16_t>(format, 1);  // floating point, one channel
  put<std::uint32_t>(format, 5000), put<std::uint32_t>(format, 20000);
  put<std::uint16_t>(format, 4), put<std::uint16_t>(format, 32);
  const std::string comment("full scale 50 g\0", 16);
  std::string body = "WAVE";
  const auto chunk = [&](const char* name, const std::string& content) {
    body += name;
    put(body, static_cast<std::uint32_t>(content.size()));
    body += content;
  };
  chunk("fmt ", format);
  std::string list = "INFOICMT";
  put(list, static_cast<std::uint32_t>(comment.size()));
  chunk("LIST", list + comment);
  chunk("data", data);
  std::string bytes = "RIFF";
  put(bytes, static_cast<std::uint32_t>(body.size()));
  return bytes + body;
}

std::string csvText() {
  std::string text = "time [ms];aba [g]\n";
  char row[80];
  for (int i = 0; i < loggerSamples; ++i) {
    std::snprintf(row, sizeof row, "%.4f;%.9f\n", 1e3 * i / loggerRate, inG(i));
    text += row;
  }
  return text;
}

std::string packed(const std::string& text) {
  std::string bytes(text.size() + 1000, '\0');
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

struct LoggerForm {
  const char* name;
  std::string (*bytes)();
  double tolerance;  // [m/s2] of what the form can hold: nine decimals of g, or a float's 24 bits of 30 m/s2
};

class LoggerForms : public testing::TestWithParam<LoggerForm> {};

TEST_P(LoggerForms, AreOneRecord) {
  const tests::TemporaryFile file(GetParam().bytes(), ".data");
  RecordOptions options;
  options.columns.speed = 30;
  const auto whole = readWhole(file.path(), options);
  EXPECT_NEAR(whole.layout.rate, loggerRate, 1e-6);
  ASSERT_EQ(whole.stretches.size(), 1u);
  ASSERT_EQ(whole.stretches[0].size(), static_cast<std::size_t>(loggerSamples));
  const auto signals = readers::readSignals(file.path(), options.columns);
  ASSERT_EQ(signals.size(), 1u);
  ASSERT_EQ(signals[0].signals[0].unit, "m/s2");
  for (int i = 0; i < loggerSamples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    ASSERT_NEAR(whole.stretches[0].values[0][at], 9.80665 * inG(i), GetParam().tolerance) << i;
    ASSERT_NEAR(signals[0].signals[0].values[at], 9.80665 * inG(i), GetParam().tolerance) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(OfPrograms, LoggerForms,
                         testing::Values(LoggerForm{"labview", labviewText, 1e-8}, LoggerForm{"wav", wavBytes, 4e-6},
                                         LoggerForm{"gzip", [] { return packed(csvText()); }, 1e-8}),
                         [](const auto& form) { return form.param.name; });

}  // namespace
}  // namespace squat::records

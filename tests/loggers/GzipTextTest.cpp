// The packed bytes: `printf 'hello\n' | gzip -n`, and what zlib makes of longer texts.
#include "loggers/GzipText.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include "core/Errors.h"

namespace squat::loggers {
namespace {

using ::testing::HasSubstr;

const std::string gzipHello(
    "\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03\xcb\x48\xcd\xc9\xc9\xe7\x02\x00\x20\x30\x3a\x36\x06\x00\x00\x00", 26);
constexpr std::size_t gzipPlenty = std::size_t{1} << 30;

std::string gzipPacked(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string gzipErrorOf(const std::string& bytes, std::size_t maximum = gzipPlenty) {
  try {
    unpacked(bytes, "a.csv.gz", maximum);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(GzipText, isKnownByItsHead) {
  EXPECT_TRUE(isGzip(gzipHello));
  EXPECT_FALSE(isGzip("\x1f"));
  EXPECT_FALSE(isGzip("PK"));
}

TEST(GzipText, oneMember) { EXPECT_EQ(unpacked(gzipHello, "a.csv.gz", 6), "hello\n"); }

TEST(GzipText, severalMembersAndPadding) {
  EXPECT_EQ(unpacked(gzipHello + gzipHello + gzipPacked("") + gzipHello, "a.csv.gz", gzipPlenty),
            "hello\nhello\nhello\n");
  EXPECT_EQ(unpacked(gzipHello + std::string(512, '\0'), "a.csv.gz", gzipPlenty), "hello\n");
}

TEST(GzipText, longerThanABlock) {
  std::string text;
  for (int i = 0; text.size() < 3000000; ++i) text += std::to_string(i * 7919) + ";";
  EXPECT_EQ(unpacked(gzipPacked(text), "a.csv.gz", text.size()), text);
}

TEST(GzipText, tooMuch) {
  EXPECT_THAT(gzipErrorOf(gzipHello, 5), HasSubstr("more than the 5 bytes"));
  EXPECT_THAT(gzipErrorOf(gzipHello + gzipHello, 11), HasSubstr("more than the 11 bytes"));
  EXPECT_THAT(gzipErrorOf(gzipPacked(std::string(5000000, 'x')), 1000), HasSubstr("more than the 1000 bytes"));
}

TEST(GzipText, cutAnywhere) {
  for (std::size_t size = 2; size < gzipHello.size(); ++size)
    EXPECT_THAT(gzipErrorOf(gzipHello.substr(0, size)), HasSubstr("cut off")) << size;
  EXPECT_THAT(gzipErrorOf(""), HasSubstr("is not packed"));
}

TEST(GzipText, damageIsNamed) {
  std::string wrongSum = gzipHello;
  wrongSum[19] = 'x';
  EXPECT_THAT(gzipErrorOf(wrongSum), HasSubstr("damaged: incorrect data check"));
  std::string wrongMethod = gzipHello;
  wrongMethod[2] = 9;
  EXPECT_THAT(gzipErrorOf(wrongMethod), HasSubstr("damaged: unknown compression method"));
  EXPECT_THAT(gzipErrorOf(gzipHello + "more"), HasSubstr("followed by something else"));
  EXPECT_THAT(gzipErrorOf(gzipHello + gzipHello.substr(0, 10)), HasSubstr("cut off"));
}

}  // namespace
}  // namespace squat::loggers

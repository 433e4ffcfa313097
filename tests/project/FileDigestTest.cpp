// Whether a long record is the one that it was: what is noticed without reading all of it, and what is not.
#include "project/FileDigest.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>

#include "analysis/Folder.h"

namespace squat::project {
namespace {

using ::testing::HasSubstr;
using tests::Folder;

constexpr std::size_t size = 3U << 20U;

std::string record() {
  std::string text(size, '\0');
  for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i * 7919 >> 3U);
  return text;
}

TEST(FileDigest, isThatOfACopy) {
  const Folder folder;
  const std::string digest = fileDigest(folder.write("day.csv", record()));
  EXPECT_EQ(digest.size(), 8U);
  EXPECT_EQ(digest.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(fileDigest(folder.write("copy.csv", record())), digest);
}

TEST(FileDigest, noticesWhatChangesAtTheEndsAndAnotherSize) {
  const Folder folder;
  const std::string before = record(), digest = fileDigest(folder.write("day.csv", before));
  constexpr std::size_t edge = 1U << 20U;
  for (const std::size_t place : {std::size_t{0}, edge - 1, size - edge, size - 1}) {
    std::string text = before;
    ++text[place];
    EXPECT_NE(fileDigest(folder.write("day.csv", text)), digest) << place;
  }
  EXPECT_NE(fileDigest(folder.write("day.csv", before + '\n')), digest);
  EXPECT_NE(fileDigest(folder.write("day.csv", before.substr(0, size - 1))), digest);
  std::string middle = before;
  ++middle[size / 2];  // what the header says is not noticed
  EXPECT_EQ(fileDigest(folder.write("day.csv", middle)), digest);
}

TEST(FileDigest, ofASmallFileIsThatOfAllOfIt) {
  const Folder folder;
  const std::string text = "time [s],left [m/s2]\n0,1\n0.001,2\n", digest = fileDigest(folder.write("day.csv", text));
  for (std::size_t place = 0; place < text.size(); ++place) {
    std::string changed = text;
    ++changed[place];
    EXPECT_NE(fileDigest(folder.write("day.csv", changed)), digest) << place;
  }
  EXPECT_EQ(fileDigest(folder.write("empty.csv", "")).size(), 8U);
}

// Reading all of it would take a minute: the test has a limit of time.
TEST(FileDigest, ofTensOfGigabytesTakesNoTime) {
  const Folder folder;
  const std::string path = folder.write("day.h5", "head");
  std::filesystem::resize_file(path, std::uintmax_t{20} << 30U);  // a hole
  EXPECT_EQ(fileDigest(path).size(), 8U);
}

TEST(FileDigest, ofWhatCannotBeReadIsNotKnown) {
  const Folder folder;
  EXPECT_EQ(fileDigest(folder.path("none.csv")), "");
  EXPECT_EQ(fileDigest(folder.path()), "");
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(fileDigest(pipe), "");  // and nobody waits for it
}

TEST(FileDigest, aChangeIsSaidWhereBothAreKnown) {
  EXPECT_THAT(changeOf("day.csv", "01234567", "89abcdef"),
              HasSubstr("day.csv holds other values than when the project was saved"));
  EXPECT_EQ(changeOf("day.csv", "01234567", "01234567"), "");
  EXPECT_EQ(changeOf("day.csv", "", "89abcdef"), "");
  EXPECT_EQ(changeOf("day.csv", "01234567", ""), "");
}

}  // namespace
}  // namespace squat::project

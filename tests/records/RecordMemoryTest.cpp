// Memory does not grow with the length of a record.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "readers/TemporaryFile.h"
#include "records/RecordStream.h"

namespace squat::records {
namespace {

// [kB] most memory that this process has had.
long peakMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return std::stol(line.substr(6));
  return 0;
}

void writeRows(const std::string& path, int rows) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  std::fputs("time [s],aba [m/s2]\n", file);
  for (int i = 0; i < rows; ++i) std::fprintf(file, "%.5f,%.3f\n", i * 4e-5, 0.1 * (i % 1999));
  std::fclose(file);
}

std::size_t samplesIn(const std::string& path) {
  RecordOptions options;
  options.columns.signalUnit = "m/s2";
  options.columns.speed = 30;
  options.blockLength = 1 << 14;
  const auto stream = openRecord(path, options);
  std::size_t count = 0;
  for (RecordBlock block; stream->next(block);) count += block.size();
  return count;
}

TEST(RecordMemory, twentyMegabytesTakeNoMoreThanTwo) {
  const tests::TemporaryFile small(""), large("");
  writeRows(small.path(), 120000);   // 2 MB
  writeRows(large.path(), 1200000);  // 20 MB; as numbers 19 MB
  EXPECT_EQ(samplesIn(small.path()), 120000u);
  const long before = peakMemory();
  EXPECT_EQ(samplesIn(large.path()), 1200000u);
  // Blocks and buffers are the same; 4 MB are left to the memory allocator.
  EXPECT_LT(peakMemory() - before, 4096);
}

}  // namespace
}  // namespace squat::records

// Malicious files, built with the HDF5 library itself. Each must be refused with the path of the object.
#include <gmock/gmock.h>
#include <hdf5.h>
#include <sys/resource.h>

#include <chrono>
#include <cstring>
#include <fstream>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/Hdf5.h"
#include "results/ResultFile.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"

namespace squat::results {
namespace {

using ::testing::HasSubstr;
using tests::refusal;
using tests::sampleResult;
using tests::TemporaryFolder;

// A good result in which `change` may do what it likes with the C API.
template <typename Change>
std::string spoilt(const TemporaryFolder& folder, const Change& change) {
  auto path = folder / "spoilt.h5";
  writeResult(path, sampleResult());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  EXPECT_GE(file, 0);
  change(file);
  EXPECT_GE(H5Fclose(file), 0);
  return path;
}

hid_t makeDataset(hid_t file, const char* name, hid_t type, std::vector<hsize_t> extents, hid_t creation) {
  const hid_t space = H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
  const hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  EXPECT_GE(set, 0);
  H5Sclose(space);
  H5Dclose(set);
  return set;
}

TEST(HostileHdf5, ExternalStorageIsNotRead) {
  const TemporaryFolder folder;
  const auto path = spoilt(folder, [](hid_t file) {
    H5Ldelete(file, "/signals/aba", H5P_DEFAULT);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(creation, "/etc/passwd", 0, 300 * sizeof(double));
    makeDataset(file, "/signals/aba", H5T_NATIVE_DOUBLE, {300}, creation);
    H5Pclose(creation);
  });
  EXPECT_THAT(refusal(path), HasSubstr("/signals/aba: keeps its values in another file"));
}

TEST(HostileHdf5, ExternalLinkIsNotFollowed) {
  const TemporaryFolder folder;
  writeResult(folder / "other.h5", sampleResult());
  const auto path = spoilt(folder, [&](hid_t file) {
    H5Ldelete(file, "/signals/aba", H5P_DEFAULT);
    H5Lcreate_external((folder / "other.h5").c_str(), "/signals/aba", file, "/signals/aba", H5P_DEFAULT, H5P_DEFAULT);
  });
  EXPECT_THAT(refusal(path), HasSubstr("/signals/aba: is a link into another file"));
}

TEST(HostileHdf5, ExternalLinkInTheMiddleOfAPathIsNotFollowed) {
  const TemporaryFolder folder;
  writeResult(folder / "other.h5", sampleResult());
  const auto path = spoilt(folder, [&](hid_t file) {
    H5Ldelete(file, "/signals", H5P_DEFAULT);
    H5Lcreate_external((folder / "other.h5").c_str(), "/signals", file, "/signals", H5P_DEFAULT, H5P_DEFAULT);
  });
  EXPECT_THAT(refusal(path), HasSubstr("/signals: is a link into another file"));
}

TEST(HostileHdf5, SoftLinkIsNotFollowed) {
  const TemporaryFolder folder;
  const auto path = spoilt(
      folder, [](hid_t file) { H5Lcreate_soft("/signals/aba", file, "/signals/alias", H5P_DEFAULT, H5P_DEFAULT); });
  EXPECT_THAT(refusal(path), HasSubstr("/signals/alias: is a soft link"));
}

TEST(HostileHdf5, GroupThatHoldsItselfEnds) {
  const TemporaryFolder folder;
  const auto path = spoilt(
      folder, [](hid_t file) { H5Lcreate_hard(file, "/signals", file, "/signals/again", H5P_DEFAULT, H5P_DEFAULT); });
  EXPECT_THAT(refusal(path), HasSubstr("nested too deeply"));
}

TEST(HostileHdf5, VirtualLayoutIsRefused) {
  const TemporaryFolder folder;
  const auto path = spoilt(folder, [](hid_t file) {
    const hsize_t extent = 300;
    const hid_t space = H5Screate_simple(1, &extent, nullptr);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_layout(creation, H5D_VIRTUAL);
    H5Pset_virtual(creation, space, "/etc/passwd", "/x", space);
    makeDataset(file, "/signals/other", H5T_NATIVE_DOUBLE, {extent}, creation);
    H5Pclose(creation);
    H5Sclose(space);
  });
  EXPECT_THAT(refusal(path), HasSubstr("/signals/other: keeps its values in other files (virtual layout)"));
}

TEST(HostileHdf5, UnknownFilterIsRefused) {
  const TemporaryFolder folder;
  const auto path = spoilt(folder, [](hid_t file) {
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk = 100;
    H5Pset_chunk(creation, 1, &chunk);
    H5Pset_filter(creation, 32000, H5Z_FLAG_OPTIONAL, 0, nullptr);
    makeDataset(file, "/signals/other", H5T_NATIVE_DOUBLE, {300}, creation);
    H5Pclose(creation);
  });
  EXPECT_THAT(refusal(path), HasSubstr("/signals/other: is packed with an unknown filter (32000)"));
}

TEST(HostileHdf5, AbsurdExtentsAreRefusedAtOnce) {
  const TemporaryFolder folder;
  const auto path = spoilt(folder, [](hid_t file) {
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk = 1000;
    H5Pset_chunk(creation, 1, &chunk);
    makeDataset(file, "/signals/other", H5T_NATIVE_DOUBLE, {hsize_t{1} << 40}, creation);
    H5Pclose(creation);
  });
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(refusal(path), HasSubstr("/signals/other: has absurd extents"));
  // A second is promised; the child has a limit of one second of processor time, the rest is a busy machine's.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

// Extents below every absolute limit, but never written: the library would fill hundreds of megabytes for a small file.
TEST(HostileHdf5, ManyValuesInASmallFileAreRefused) {
  const TemporaryFolder folder;
  const auto path = spoilt(folder, [](hid_t file) {
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk = 1000;
    H5Pset_chunk(creation, 1, &chunk);
    makeDataset(file, "/signals/other", H5T_NATIVE_DOUBLE, {hsize_t{40} << 20}, creation);
    H5Pclose(creation);
  });
  EXPECT_THAT(refusal(path), HasSubstr("/signals/other: claims more values than the file can hold"));
}

TEST(HostileHdf5, AbsurdChunksAreRefused) {
  const TemporaryFolder folder;
  const auto path = spoilt(folder, [](hid_t file) {
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk = hsize_t{1} << 28;
    H5Pset_chunk(creation, 1, &chunk);
    H5Pset_deflate(creation, 1);
    const hsize_t extent = 300, maximum = H5S_UNLIMITED;
    const hid_t space = H5Screate_simple(1, &extent, &maximum);
    H5Dclose(H5Dcreate2(file, "/signals/other", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
    H5Sclose(space);
    H5Pclose(creation);
  });
  EXPECT_THAT(refusal(path), HasSubstr("/signals/other: has absurd chunks"));
}

TEST(HostileHdf5, CompoundTypeIsRefused) {
  const TemporaryFolder folder;
  const auto path = spoilt(folder, [](hid_t file) {
    const hid_t type = H5Tcreate(H5T_COMPOUND, 16);
    H5Tinsert(type, "a", 0, H5T_NATIVE_DOUBLE);
    makeDataset(file, "/signals/other", type, {300}, H5P_DEFAULT);
    H5Tclose(type);
  });
  EXPECT_THAT(refusal(path), HasSubstr("/signals/other: has a type that is neither a number nor text"));
}

TEST(HostileHdf5, NamedTypeIsRefused) {
  const TemporaryFolder folder;
  const auto path = spoilt(folder, [](hid_t file) {
    const hid_t type = H5Tcopy(H5T_NATIVE_DOUBLE);
    H5Tcommit2(file, "/signals/type", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Tclose(type);
  });
  EXPECT_THAT(refusal(path), HasSubstr("/signals/type: is neither a group nor a dataset"));
}

// Damage in every region of a file: whatever the library does with it, this process lives and answers.
TEST(HostileHdf5, DamagedBytesNeverBringTheReaderDown) {
  const TemporaryFolder folder;
  auto result = sampleResult(50);
  result.caseToml.clear();
  const auto good = encodeHdf5(toTree(result), "a.h5");
  std::uint32_t random = 12345;
  const auto next = [&random] { return random = random * 1664525U + 1013904223U; };
  int refused = 0;
  for (int trial = 0; trial < 60; ++trial) {
    auto image = good;
    for (int change = 0; change < 20; ++change)
      image[(next() >> 8) % image.size()] = static_cast<std::byte>(next() >> 24);
    writeDurably(folder / "damaged.h5", image);
    if (refusal(folder / "damaged.h5") != "accepted") ++refused;
  }
  EXPECT_GT(refused, 20);  // twenty changed bytes often hit only slack or values
}

// What a picture or a measure would index or divide by: a map without rows, times that stand or rise by less than any
// sampling of this program.
TEST(HostileHdf5, SpectraAndTimesThatDoNotFitAreRefused) {
  const TemporaryFolder folder;
  auto withoutRows = sampleResult();
  auto tree = toTree(withoutRows);
  const auto drop = [&](const char* path) {
    tree.arrays.erase(
        std::remove_if(tree.arrays.begin(), tree.arrays.end(), [&](const Array& a) { return a.path == path; }),
        tree.arrays.end());
  };
  drop("/scalogram/frequency"), drop("/scalogram/power");
  EXPECT_THROW(fromTree(tree, "x.h5"), FileError);
  for (const double step : {0.0, 1e-9, -1e-3, std::nan("")}) {
    auto result = sampleResult();
    for (std::size_t i = 1; i < result.time.size(); ++i) result.time[i] = result.time[i - 1] + step;
    EXPECT_THROW(fromTree(toTree(result), "x.h5"), FileError) << step;
  }
}

}  // namespace
}  // namespace squat::results

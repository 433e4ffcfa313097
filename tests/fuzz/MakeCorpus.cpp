// Makes the binary part of the corpus: make_corpus FOLDER writes FOLDER/stream/*, FOLDER/result/* and FOLDER/project/*.
// Run by hand when the schema changes; what it makes is kept in the tree.
#include <hdf5.h>

#include <string>

#include "core/DurableFile.h"
#include "project/ProjectFile.h"
#include "results/Checkpoint.h"
#include "results/Hdf5.h"
#include "results/ResultTree.h"
#include "results/SampleResult.h"
#include "results/TreeStream.h"

int main(int argc, char** argv) {
  using namespace squat;
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  auto result = tests::sampleResult(5);
  result.caseToml = "schema = 1\n";
  const auto full = results::toTree(result);
  const auto empty = results::toTree(results::RunResult{});
  writeDurably(folder + "/stream/full", results::encodeTree(full));
  writeDurably(folder + "/stream/empty", results::encodeTree(empty));
  writeDurably(folder + "/result/full.h5", results::encodeHdf5(full, "full.h5"));
  writeDurably(folder + "/result/empty.h5", results::encodeHdf5(empty, "empty.h5"));

  results::ArrayTree state;
  setAttribute(state.attributes, "isa", std::string("avx2"));
  state.add("/displacement", std::vector<double>{0.5, 0.25}, "m");
  results::writeCheckpoint(folder + "/stream/checkpoint", state);

  project::Project work;
  work.open = {"dip", "/projects/dip.toml", true, "schema = 1\n"};
  project::Entry measured;
  measured.kind = project::Kind::measured;
  measured.path = "/projects/measured.csv", measured.digest = "0123abcd", measured.gain = 1.25;
  work.entries = {{}, measured};
  work.entries[0].path = "/elsewhere/dip.h5";
  work.current = 0, work.reference = 1, work.notes = "a note\n", work.views = {"psd"};
  const auto whole = project::projectText(work, "/projects");
  writeDurably(folder + "/project/whole.squat-project", std::string_view(whole));
  writeDurably(folder + "/project/cut.squat-project", std::string_view(whole).substr(0, whole.size() / 2));
  writeDurably(folder + "/project/deep.squat-project", std::string_view(std::string(5000, '[')));

  const auto hostile = folder + "/result/external.h5";
  writeDurably(hostile, results::encodeHdf5(empty, hostile));
  const hid_t file = H5Fopen(hostile.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t extent = 8;
  const hid_t space = H5Screate_simple(1, &extent, nullptr);
  H5Pset_external(creation, "/etc/hostname", 0, 64);
  H5Dclose(H5Dcreate2(file, "/signals/other", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  H5Lcreate_soft("/signals/time", file, "/signals/alias", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_external("/etc/hostname", "/", file, "/signals/far", H5P_DEFAULT, H5P_DEFAULT);
  H5Sclose(space);
  H5Pclose(creation);
  return H5Fclose(file) < 0;
}

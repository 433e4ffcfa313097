// squat-reader - reads files of HDF5 and MATLAB for the other programs, which start it: a file that makes a library
// crash, or compute for ever, ends this program alone.
#include "rcmdx/ExactColumns.h"
#include "results/ReaderProgram.h"

int main() {
  using namespace squat;
  return results::answerCaller({{"HDF5 columns", results::sendHdf5Columns},
                                {"HDF5 tree", results::sendHdf5Tree},
                                {"MATLAB columns", results::sendMatlabColumns},
                                {"MATLAB tree", results::sendMatlabTree},
                                {"RCM-DX columns", rcmdx::sendExactly}});
}

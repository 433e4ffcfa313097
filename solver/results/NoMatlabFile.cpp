// Where there is no library for them: files of MATLAB before version 7.3 are known, and refused.
#include "core/Errors.h"
#include "results/MatlabFile.h"
#include "results/ReaderCall.h"

namespace squat::results {
namespace {

[[noreturn]] void refuseMatlab(const std::string& path) {
  throw FileError(path, "", "is a MATLAB file of version 7.2 or older, which this program reads on Linux only",
                  "Save it again with the option -v7.3");
}

}  // namespace

ArrayTree readMatlabFile(const std::string& path) { refuseMatlab(path); }
ArrayTree listMatlabFile(const std::string& path) { refuseMatlab(path); }
std::unique_ptr<ArrayStream> streamMatlabFile(const std::string& path, const std::vector<ArrayColumn>&, std::size_t) {
  refuseMatlab(path);
}
void sendMatlabTree(ReaderArguments& arguments, const ByteSink&) { refuseMatlab(arguments.text()); }
void sendMatlabColumns(ReaderArguments& arguments, const ByteSink&) { refuseMatlab(arguments.text()); }

}  // namespace squat::results

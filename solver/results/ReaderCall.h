// solver/results/ReaderCall.h - what a reading program is asked to do, and what it can do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/TreeStream.h"

namespace squat::results {

struct ArrayColumn;

struct ReaderCall {
  std::string work;  // its name among the works of the program
  std::vector<std::byte> arguments = {};

  // Behind those that are there; read in the same order.
  ReaderCall& text(std::string_view value);
  ReaderCall& number(std::uint64_t value);
};

// What a ReaderCall has put there. Throws std::out_of_range where there is less.
class ReaderArguments {
 public:
  explicit ReaderArguments(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::string text();
  std::size_t number();
  std::vector<std::byte> rest() const { return {bytes_.begin(), bytes_.end()}; }

 private:
  std::span<const std::byte> take(std::size_t count);
  std::span<const std::byte> bytes_;
};

// Columns with their number before them; packing is left out, which belongs to who receives the values.
void putColumns(ReaderCall& call, const std::vector<ArrayColumn>& columns);
std::vector<ArrayColumn> takeColumns(ReaderArguments& arguments);

// In the reading program: sends bytes, or throws.
using ReaderWork = void (*)(ReaderArguments& arguments, const ByteSink& send);
using ReaderWorks = std::map<std::string, ReaderWork>;

// Those of this folder, by the sources that call them.
void sendHdf5Tree(ReaderArguments& arguments, const ByteSink& send);       // "HDF5 tree"
void sendHdf5Columns(ReaderArguments& arguments, const ByteSink& send);    // "HDF5 columns"
void sendMatlabTree(ReaderArguments& arguments, const ByteSink& send);     // "MATLAB tree"
void sendMatlabColumns(ReaderArguments& arguments, const ByteSink& send);  // "MATLAB columns"

}  // namespace squat::results

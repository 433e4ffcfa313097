// solver/records/Hdf5Rows.h - datasets of an HDF5 file (MATLAB 7.3 and pandas included) as rows.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "records/RowSource.h"
#include "results/Hdf5Stream.h"

namespace squat::records {

// The dataset or group that `options.object` names, else the group of the dataset aba, else the one with the most
// samples. A data frame that pandas has written (format fixed) is a group with its column names; its index is the time
// where it rises as numbers or dates. Throws FileError as readers::readSignals does.
class Hdf5Rows : public RowSource {
 public:
  Hdf5Rows(std::string path, const readers::SignalFileOptions& options);

  const text::DelimitedTable& head() const override { return head_; }
  void choose(std::vector<std::size_t> columns) override;
  bool next(std::size_t most, Rows& rows) override;
  double fraction() const override;
  std::size_t rows() const override { return samples_; }
  const std::string& column() const { return column_; }  // what the object named chooses; empty: nothing

 private:
  void readHead();

  std::string path_, column_;
  text::DelimitedTable head_;
  std::vector<results::Hdf5Column> places_;
  std::size_t samples_ = 0, read_ = 0;
  std::unique_ptr<results::Hdf5Stream> stream_;
};

}  // namespace squat::records

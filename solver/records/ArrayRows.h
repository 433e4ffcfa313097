// solver/records/ArrayRows.h - arrays of an HDF5 or MATLAB file as rows; data frames of pandas as well.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "records/RowSource.h"
#include "results/ArrayStream.h"
#include "results/ArrayTree.h"

namespace squat::rcmdx {
class RecordColumns;
}

namespace squat::records {

// The dataset or group that `options.object` names, else the group of the dataset aba, else the one with the most
// samples. A data frame that pandas has written (format fixed) is a group with its column names; its index is the time
// where it rises as numbers or dates. Of a recording of RCM-DX, what rcmdx/RecordColumns.h says. Throws FileError as
// readers::readSignals does.
class ArrayRows : public RowSource {
 public:
  ArrayRows(std::string path, const readers::SignalFileOptions& options);
  ~ArrayRows() override;

  const text::DelimitedTable& head() const override { return head_; }
  std::string structure() const override;
  void choose(std::vector<std::size_t> columns) override;
  bool next(std::size_t maximum, Rows& rows) override;
  double fraction() const override;
  std::size_t rows() const override { return samples_; }
  std::string truncation() const override { return truncation_; }
  std::vector<std::string> files() const override { return {path_}; }

 private:
  void takeSession(const results::ArrayTree& tree, const readers::SignalFileOptions& options);
  std::unique_ptr<results::ArrayStream> open(const std::vector<std::size_t>& columns) const;
  void readHead();

  std::string path_, object_, truncation_;
  text::DelimitedTable head_;
  std::vector<results::ArrayColumn> places_;
  std::unique_ptr<rcmdx::RecordColumns> session_;  // where it is one
  std::size_t samples_ = 0, read_ = 0;
  std::unique_ptr<results::ArrayStream> stream_;
};

}  // namespace squat::records

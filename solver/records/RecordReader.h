// solver/records/RecordReader.h - from the rows of a file to the blocks of a record.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "records/ChosenColumns.h"
#include "records/FaultList.h"
#include "records/RecordStream.h"
#include "records/RowChecks.h"
#include "records/RowSource.h"
#include "records/WorkRows.h"

namespace squat::records {

class RecordReader : public RecordStream {
 public:
  RecordReader(std::string path, std::unique_ptr<RowSource> source, const RecordOptions& options);

  const RecordLayout& layout() const override { return layout_; }
  bool next(RecordBlock& block) override;
  double fraction() const override { return source_->fraction(); }
  const std::vector<RecordFault>& faults() const override { return faults_.list(); }

 private:
  void fetch();
  void take(Rows& rows);
  void check(std::size_t from);
  void reportTruncation();
  void fillChannel(std::size_t channel, std::size_t from);
  void reportChannel(std::size_t channel, std::size_t row, std::size_t end);
  RowRules findRules();
  void findAbsent(const Rows& rows);
  void judgeSpeed();
  void judgeValues();
  void judgeCoordinates();
  std::size_t blockEnd() const;
  void emit(std::size_t end, RecordBlock& block);
  void speedsFromPositions(std::size_t end, RecordBlock& block) const;

  RecordOptions options_;
  std::unique_ptr<RowSource> source_;
  ChosenColumns chosen_;
  RecordLayout layout_;
  FaultList faults_;
  WorkRows work_;
  Rows rows_;
  std::unique_ptr<RowChecks> checks_;
  std::vector<double> lastGood_;
  std::vector<double> absent_;  // of each channel, the number that stands for none; infinite: there is none
  double direction_ = 1;
  bool ended_ = false, emitted_ = false, timesUsed_ = true;
  std::size_t bridged_ = 0;       // rows put in for lost samples
  double lostStep_ = 0;           // [s] of a clock that loses samples
  std::size_t at_ = 0;            // row of the next block
  std::size_t stretchStart_ = 0;  // sample
};

}  // namespace squat::records

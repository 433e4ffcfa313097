// solver/rcmdx/RecordColumns.h - the accelerations of a session as columns of a table, with times and positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rcmdx/Recording.h"
#include "rcmdx/TrackPositions.h"
#include "results/ArrayStream.h"
#include "text/DelimitedTable.h"

namespace squat::rcmdx {

struct RecordChoice {
  // A session, a data source or a channel, by its path or name. Empty: the only session; its accelerations in the data
  // source with the highest rate.
  std::string object;
  // What the column of positions counts: "covered distance", "line offset" or "track offset". Empty: the offset on the
  // line where the session is on one line and runs along it in one direction, else the distance covered.
  std::string position;
};

// Columns, in this order: time [s] from the first sample on, exact to the nanosecond; a position [m] and latitude and
// longitude [deg] where the session has them, on straight lines between its own; the channels, and a speed among them.
class RecordColumns {
 public:
  const text::DelimitedTable& table() const { return table_; }  // names and units, no values
  std::size_t samples() const { return source_.samples; }
  std::int64_t start() const { return start_; }  // [ns] since 1970-01-01 UTC of the first sample
  const Session& session() const { return session_; }
  const DataSource& source() const { return source_; }
  const PositionTrack& positions() const { return *positions_; }
  const std::vector<std::string>& notes() const { return notes_; }

  // The columns by their index in the table, in pieces. Throws FileError.
  std::unique_ptr<results::ArrayStream> open(const std::vector<std::size_t>& columns) const;
  // All of them with their values, for records that fit in memory. FileError beyond `most` samples.
  text::DelimitedTable read(std::size_t most = std::size_t{1} << 24) const;

 private:
  friend class ColumnsBuilder;
  struct Coordinates {
    std::vector<std::int64_t> time;
    std::vector<double> latitude, longitude;
  };
  enum class Kind { time, covered, line, track, latitude, longitude, channel };
  struct Column {
    Kind kind = Kind::time;
    std::string data;  // of a channel
  };
  friend class RecordPieces;

  std::string path_;
  text::DelimitedTable table_;
  std::vector<Column> columns_;
  Session session_;
  DataSource source_;
  std::int64_t start_ = 0;
  std::shared_ptr<const PositionTrack> positions_ = std::make_shared<PositionTrack>();
  std::shared_ptr<const Coordinates> coordinates_ = std::make_shared<Coordinates>();
  std::vector<std::string> notes_;
};

// Throws FileError: no such object; several sessions and none chosen (it lists them); no acceleration over time, where
// it lists the channels; channels that are not as long as their times; times that fall.
RecordColumns recordColumns(const std::string& path, const results::ArrayTree& tree, const RecordChoice& choice = {});

}  // namespace squat::rcmdx

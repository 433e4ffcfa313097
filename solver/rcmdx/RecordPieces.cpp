#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "rcmdx/ExactColumns.h"
#include "rcmdx/RecordColumns.h"

namespace squat::rcmdx {

// Pieces of the channels, with what is computed from their times.
class RecordPieces : public results::ArrayStream {
 public:
  RecordPieces(const RecordColumns& record, const std::vector<std::size_t>& columns)
      : positions_(record.positions_),
        coordinates_(record.coordinates_),
        start_(record.start_),
        places_(*positions_),
        fixes_(coordinates_->time) {
    std::vector<ExactColumn> wanted{{record.source_.timestamps, Take::wholeSeconds},
                                    {record.source_.timestamps, Take::nanoseconds}};
    for (const std::size_t c : columns) {
      columns_.push_back(record.columns_.at(c));
      if (columns_.back().kind == RecordColumns::Kind::channel) wanted.push_back({columns_.back().data, Take::number});
    }
    stream_ = streamExactly(record.path_, wanted, record.source_.samples);
  }

  bool next(std::vector<std::vector<double>>& columns) override {
    std::vector<std::vector<double>> piece;
    if (!stream_->next(piece)) return false;
    columns.resize(columns_.size());
    std::size_t channel = 2;  // behind both parts of the time
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns_[c].kind == Kind::channel)
        columns[c].insert(columns[c].end(), piece[channel].begin(), piece[channel].end()), ++channel;
    const bool places = has({Kind::covered, Kind::line, Kind::track}), fixes = has({Kind::latitude, Kind::longitude});
    for (std::size_t i = 0; i < piece[0].size(); ++i) {
      const bool known = std::isfinite(piece[0][i]);  // not where the file is cut off
      const std::int64_t time = known ? joinedTime(piece[0][i], piece[1][i]) : 0;
      const Place place = known && places ? places_.at(time) : Place();
      const auto fix = known && fixes ? fixAt(time) : std::pair(unknown, unknown);
      for (std::size_t c = 0; c < columns.size(); ++c) switch (columns_[c].kind) {
          case Kind::time:
            columns[c].push_back(known ? secondsBehindStart(time) : unknown);
            break;
          case Kind::covered:
            columns[c].push_back(place.covered);
            break;
          case Kind::line:
            columns[c].push_back(place.lineOffset);
            break;
          case Kind::track:
            columns[c].push_back(place.trackOffset);
            break;
          case Kind::latitude:
            columns[c].push_back(fix.first);
            break;
          case Kind::longitude:
            columns[c].push_back(fix.second);
            break;
          case Kind::channel:
            break;
        }
    }
    return true;
  }

 private:
  using Kind = RecordColumns::Kind;
  static constexpr std::int64_t oneSecond = 1000000000;  // [ns]
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  bool has(std::initializer_list<Kind> kinds) const {
    return std::any_of(columns_.begin(), columns_.end(), [&](const auto& column) {
      return std::find(kinds.begin(), kinds.end(), column.kind) != kinds.end();
    });
  }

  // A difference of whole nanoseconds is exact in a double for a hundred days.
  double secondsBehindStart(std::int64_t time) const { return static_cast<double>(time - start_) / 1e9; }

  // Between fixes that are at most ten seconds apart, and a second beyond the ends.
  std::pair<double, double> fixAt(std::int64_t time) {
    const auto& times = coordinates_->time;
    if (times.empty() || time < times.front() - oneSecond || time > times.back() + oneSecond) return {unknown, unknown};
    const auto between = fixes_.at(time);
    if (times[between.after] - times[between.before] > 10 * oneSecond) return {unknown, unknown};
    const auto value = [&](const std::vector<double>& values) {
      return values[between.before] + between.weight * (values[between.after] - values[between.before]);
    };
    return {value(coordinates_->latitude), value(coordinates_->longitude)};
  }

  std::shared_ptr<const PositionTrack> positions_;
  std::shared_ptr<const RecordColumns::Coordinates> coordinates_;
  std::int64_t start_;
  PlaceFinder places_;
  BracketFinder fixes_;
  std::vector<RecordColumns::Column> columns_;
  std::unique_ptr<results::ArrayStream> stream_;
};

std::unique_ptr<results::ArrayStream> RecordColumns::open(const std::vector<std::size_t>& columns) const {
  return std::make_unique<RecordPieces>(*this, columns);
}

}  // namespace squat::rcmdx

#include "rcmdx/RecordColumns.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "core/Errors.h"
#include "rcmdx/ChosenSource.h"
#include "rcmdx/ExactColumns.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::rcmdx {
namespace {

// Within a line the chainage rises all the time, or falls all the time; a metre is the accuracy of positions.
bool runsAlongOneLine(const PositionTrack& track) {
  constexpr double slack = 1;  // [m]
  if (track.size() < 2 || track.line.front() < 0) return false;
  double high = track.lineOffset.front(), low = high;
  bool rises = true, falls = true;
  for (std::size_t i = 0; i < track.size(); ++i) {
    const double x = track.lineOffset[i];
    if (track.line[i] != track.line.front() || !std::isfinite(x)) return false;
    rises = rises && x >= high - slack;
    falls = falls && x <= low + slack;
    high = std::max(high, x), low = std::min(low, x);
  }
  return rises || falls;
}

bool anyFinite(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

const Channel* channelOfWord(const DataSource& source, const char* word) {
  for (const auto& channel : source.channels) {
    const auto* unit = text::findUnit(text::bareUnit(channel.unit));
    const bool degrees = channel.unit.empty() || channel.unit == "-" || (unit && unit->si == "deg");
    if (degrees && channel.samples == source.samples && text::lowerCase(channel.name).find(word) != std::string::npos)
      return &channel;
  }
  return nullptr;
}

}  // namespace

class ColumnsBuilder {
 public:
  ColumnsBuilder(const std::string& path, const results::ArrayTree& tree, const RecordChoice& choice)
      : path_(path), tree_(tree), choice_(choice) {}

  RecordColumns build() {
    auto chosen = chooseSource(recordingOf(path_, tree_), choice_.object);
    built_.path_ = path_;
    built_.notes_ = std::move(chosen.notes);
    built_.session_ = std::move(chosen.session);
    built_.source_ = std::move(chosen.source);
    built_.table_.path = path_;
    built_.table_.rowWord = "sample";
    add(RecordColumns::Kind::time, "time", "s");
    built_.start_ = firstTime();
    addPosition();
    addCoordinates();
    for (const auto& channel : built_.source_.channels) {
      add(RecordColumns::Kind::channel, channel.name, channel.unit, channel.data);
      if (channel.positionOffset != 0)
        built_.notes_.push_back("'" + channel.name + "' stands " + text::roundedText(channel.positionOffset) +
                                " m from the vehicle's zero point (PositionOffset): positions are those of the zero "
                                "point");
    }
    return std::move(built_);
  }

 private:
  using Kind = RecordColumns::Kind;

  void add(Kind kind, const std::string& name, const std::string& unit, const std::string& data = {}) {
    text::TableColumn column;
    column.name = name, column.unit = unit;
    built_.table_.columns.push_back(std::move(column));
    built_.columns_.push_back({kind, data});
  }

  std::int64_t firstTime() const {
    const auto& source = built_.source_;
    std::vector<std::vector<double>> piece;
    const auto stream = streamExactly(
        path_, {{source.timestamps, Take::wholeSeconds}, {source.timestamps, Take::nanoseconds}}, source.samples);
    if (!stream->next(piece) || piece[0].empty() || !std::isfinite(piece[0][0]))
      throw FileError(path_, source.timestamps, "has no time", "Name a data source that has samples");
    return joinedTime(piece[0][0], piece[1][0]);
  }

  // The notes name the line or the track where there is one, and why distances are used where there are several.
  void addPosition() {
    if (!built_.session_.position) {
      if (!choice_.position.empty()) refusePosition();
      return;
    }
    auto track = std::make_shared<PositionTrack>(readPositions(path_, *built_.session_.position));
    built_.positions_ = track;
    const auto wanted = text::lowerCase(text::trimmed(choice_.position));
    if (wanted == "line offset") {
      requirePosition(track->lineOffset);
      add(Kind::line, wanted, "m");
    } else if (wanted == "track offset") {
      requirePosition(track->trackOffset);
      add(Kind::track, wanted, "m");
    } else if (wanted == "covered distance") {
      requirePosition(track->covered);
      add(Kind::covered, wanted, "m");
    } else if (runsAlongOneLine(*track)) {
      add(Kind::line, "position", "m");
      built_.notes_.push_back("positions are those of line " + lineName(track->line.front()));
    } else if (anyFinite(track->covered)) {
      add(Kind::covered, "position", "m");
      built_.notes_.push_back("positions are the distance covered in the session; it runs on " + lineList(*track));
    } else if (anyFinite(track->lineOffset)) {
      add(Kind::line, "position", "m");
      built_.notes_.push_back("positions are offsets on " + lineList(*track));
    }
  }

  [[noreturn]] void refusePosition() const {
    throw FileError(path_, built_.session_.path, "has no positions of the kind '" + choice_.position + "'",
                    "There are covered distance, line offset and track offset, where the session has them");
  }
  void requirePosition(const std::vector<double>& values) const {
    if (!anyFinite(values)) refusePosition();
  }

  std::string lineName(std::int32_t id) {
    if (!names_) names_ = std::make_unique<NetworkNames>(readNames(path_, tree_, built_.session_));
    const auto found = names_->lines.find(id);
    return std::to_string(id) + (found == names_->lines.end() ? "" : " (" + found->second + ")");
  }

  std::string lineList(const PositionTrack& track) {
    std::set<std::int32_t> ids(track.line.begin(), track.line.end());
    ids.erase(-1);
    if (ids.empty()) return "no line that is known";
    std::string list;
    for (const auto id : ids) {
      if (list.size() > 200) return list + ", ...";
      list += (list.empty() ? "" : ", ") + lineName(id);
    }
    return (ids.size() > 1 ? "lines " : "line ") + list;
  }

  // The format has no place of its own for them: two channels of one source whose names say what they are.
  void addCoordinates() {
    for (const auto& source : built_.session_.sources) {
      const auto *north = channelOfWord(source, "latitude"), *east = channelOfWord(source, "longitude");
      if (!north || !east || source.samples == 0) continue;
      auto found = std::make_shared<RecordColumns::Coordinates>();
      constexpr std::size_t kept = 5000000;
      const std::size_t stride = 1 + (source.samples - 1) / kept;
      const auto stream = streamExactly(path_,
                                        {{source.timestamps, Take::wholeSeconds},
                                         {source.timestamps, Take::nanoseconds},
                                         {north->data},
                                         {east->data}},
                                        source.samples);
      std::vector<std::vector<double>> piece;
      for (std::size_t first = 0; stream->next(piece); first += piece[0].size(), piece.clear())
        for (std::size_t i = 0; i < piece[0].size(); ++i) {
          if ((first + i) % stride != 0 || !std::isfinite(piece[0][i] + piece[2][i] + piece[3][i])) continue;
          const auto time = joinedTime(piece[0][i], piece[1][i]);
          if (!found->time.empty() && time <= found->time.back()) continue;
          found->time.push_back(time);
          found->latitude.push_back(piece[2][i]);
          found->longitude.push_back(piece[3][i]);
        }
      if (found->time.empty()) continue;
      built_.coordinates_ = std::move(found);
      add(Kind::latitude, "latitude", "deg");
      add(Kind::longitude, "longitude", "deg");
      return;
    }
  }

  const std::string& path_;
  const results::ArrayTree& tree_;
  const RecordChoice& choice_;
  RecordColumns built_;
  std::unique_ptr<NetworkNames> names_;
};

text::DelimitedTable RecordColumns::read(std::size_t most) const {
  if (samples() > most)
    throw FileError(path_, source_.path, "has " + std::to_string(samples()) + " samples, too many for one signal",
                    "Read it as a long record");
  std::vector<std::size_t> all(columns_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::vector<double>> values;
  const auto stream = open(all);
  while (stream->next(values)) continue;
  values.resize(all.size());
  auto table = table_;
  for (std::size_t c = 0; c < all.size(); ++c) table.columns[c].values = std::move(values[c]);
  table.lines.resize(samples());
  std::iota(table.lines.begin(), table.lines.end(), 1u);
  return table;
}

RecordColumns recordColumns(const std::string& path, const results::ArrayTree& tree, const RecordChoice& choice) {
  return ColumnsBuilder(path, tree, choice).build();
}

}  // namespace squat::rcmdx

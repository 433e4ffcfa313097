#include "rcmdx/TrackPositions.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/Errors.h"
#include "rcmdx/ExactColumns.h"
#include "results/Hdf5.h"

namespace squat::rcmdx {
namespace {

constexpr std::size_t positionsKept = 5000000;
constexpr double beyondEnds = 1;    // [s]
constexpr double largestGap = 100;  // [m] over which a straight line stands for lost positions
constexpr double nearEnough = 2;    // [m]
constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();

std::int32_t idOf(double value) {
  return value >= 0 && value <= std::numeric_limits<std::int32_t>::max() ? static_cast<std::int32_t>(value) : -1;
}

// Takes pieces in, every `stride`th row of them.
class PositionCollector {
 public:
  PositionCollector(const std::string& path, const PositionSource& source)
      : path_(path), source_(source), stride_(1 + (source.samples - 1) / positionsKept) {
    add(source.timestamps, Take::wholeSeconds);
    add(source.timestamps, Take::nanoseconds);
    for (const auto* one : {&source.coveredDistance, &source.trackOffset, &source.lineOffset, &source.trackId,
                            &source.lineId, &source.accuracy, &source.quality})
      add(*one, Take::number);
    add(source.direction, Take::direction);
    add(source.kilometrage, Take::direction);
  }

  PositionTrack collect() {
    const auto stream = streamExactly(path_, columns_, source_.samples);
    std::vector<std::vector<double>> piece;
    for (std::size_t first = 0; stream->next(piece); first += piece.front().size(), clear(piece))
      for (std::size_t i = 0; i < piece.front().size(); ++i)
        if ((first + i) % stride_ == 0) take(piece, i, first + i);
    return std::move(track_);
  }

 private:
  void add(const std::string& dataset, Take take) {
    places_.push_back(dataset.empty() ? none : columns_.size());
    if (!dataset.empty()) columns_.push_back({dataset, take});
  }

  static void clear(std::vector<std::vector<double>>& piece) {
    for (auto& column : piece) column.clear();
  }

  void take(const std::vector<std::vector<double>>& piece, std::size_t row, std::size_t number) {
    const auto value = [&](std::size_t which) {
      return places_[which] == none ? notKnown : piece[places_[which]][row];
    };
    if (!std::isfinite(value(0))) return;  // the file is cut off here
    const auto time = joinedTime(value(0), value(1));
    if (!track_.time.empty() && time < track_.time.back())
      throw FileError(path_, source_.timestamps, "falls at value " + std::to_string(number + 1),
                      "Timestamps rise along a session; export it again");
    if (!track_.time.empty() && time == track_.time.back()) return;
    track_.time.push_back(time);
    track_.covered.push_back(value(2));
    track_.track.push_back(idOf(value(5)));
    track_.line.push_back(idOf(value(6)));
    // An id of -1 says that no position could be determined.
    track_.trackOffset.push_back(value(5) < 0 ? notKnown : value(3));
    track_.lineOffset.push_back(value(6) < 0 ? notKnown : 1e3 * value(4));
    track_.accuracy.push_back(static_cast<float>(value(7)));
    track_.quality.push_back(value(8) >= 0 && value(8) <= 15 ? static_cast<signed char>(value(8)) : -1);
    const auto sign = [](double x) { return static_cast<signed char>(x > 0 ? 1 : x < 0 ? -1 : 0); };
    track_.direction.push_back(sign(value(9)));
    track_.kilometrage.push_back(sign(value(10)));
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  const std::string& path_;
  const PositionSource& source_;
  std::size_t stride_;
  std::vector<ExactColumn> columns_;
  std::vector<std::size_t> places_;  // of each value among the columns
  PositionTrack track_;
};

// Of an offset that counts from the start of what `id` names.
double offsetBetween(const std::vector<double>& offsets, const std::vector<std::int32_t>& ids, const Bracket& between,
                     double apart) {
  const double from = offsets[between.before], to = offsets[between.after];
  if (ids[between.before] == ids[between.after]) return from + between.weight * (to - from);
  return apart <= nearEnough ? offsets[between.nearer()] : notKnown;
}

const std::vector<std::string>* textsIn(const results::ArrayTree& tree, const std::string& path) {
  const auto* array = tree.find(path);
  return array ? std::get_if<std::vector<std::string>>(&array->values) : nullptr;
}

// Of the group TRACK or LINE; SBB's files have "data." in front of the names of datasets.
std::map<std::int32_t, std::string> namesIn(const results::ArrayTree& tree, const std::string& group) {
  std::map<std::int32_t, std::string> names;
  for (const std::string front : {"/", "/data."}) {
    const auto* array = tree.find(group + front + "id");
    const auto* ids = array ? std::get_if<std::vector<std::int32_t>>(&array->values) : nullptr;
    const auto* texts = textsIn(tree, group + front + "name");
    if (ids && texts)
      for (std::size_t i = 0; i < std::min(ids->size(), texts->size()); ++i) names[(*ids)[i]] = (*texts)[i];
  }
  return names;
}

}  // namespace

Place PositionTrack::place(std::size_t index) const {
  return {covered[index], trackOffset[index], lineOffset[index],  track[index],
          line[index],    direction[index],   kilometrage[index], static_cast<double>(accuracy[index]),
          quality[index]};
}

PositionTrack readPositions(const std::string& path, const PositionSource& source) {
  return PositionCollector(path, source).collect();
}

Place PlaceFinder::at(std::int64_t time) {
  const auto& track = *track_;
  if (track.time.empty()) return {};
  const auto between = bracket_.at(time);
  const std::int64_t beyond = std::max(track.time.front() - time, time - track.time.back());
  if (static_cast<double>(beyond) > 1e9 * beyondEnds) return {};
  if (between.before == between.after || between.weight == 0 || between.weight == 1)
    return track.place(between.nearer());
  double apart = std::abs(track.covered[between.after] - track.covered[between.before]);
  // Without the distance covered, offsets on one line tell.
  if (!std::isfinite(apart)) apart = std::abs(track.lineOffset[between.after] - track.lineOffset[between.before]);
  Place place = track.place(between.nearer());
  const auto& covered = track.covered;
  place.covered = covered[between.before] + between.weight * (covered[between.after] - covered[between.before]);
  place.trackOffset = offsetBetween(track.trackOffset, track.track, between, apart);
  place.lineOffset = offsetBetween(track.lineOffset, track.line, between, apart);
  if (apart > largestGap) place = {};
  return place;
}

std::vector<Place> placesAt(const PositionTrack& track, const std::vector<std::int64_t>& times) {
  PlaceFinder finder(track);
  std::vector<Place> places;
  places.reserve(times.size());
  for (const auto time : times) places.push_back(finder.at(time));
  return places;
}

NetworkNames readNames(const std::string& path, const results::ArrayTree& tree, const Session& session) {
  if (session.topology.empty()) return {};
  const std::string track = session.topology + "/TRACK", line = session.topology + "/LINE";
  NetworkNames names{namesIn(tree, track), namesIn(tree, line)};
  if (!names.tracks.empty() && !names.lines.empty()) return names;
  // Long lists come without their values: only the datasets that are wanted are read once more.
  std::set<std::string> without;
  for (const auto& array : tree.arrays) {
    const auto group = groupOf(array.path), name = nameIn(array.path);
    const bool wanted = (group == track || group == line) &&
                        (name == "id" || name == "name" || name == "data.id" || name == "data.name");
    // Systems as a whole, so that the list stays short; in the topology group by group.
    if (!wanted && group.rfind(session.topology, 0) == 0)
      without.insert(group == track || group == line || group == session.topology ? array.path : group);
    else if (!wanted)
      without.insert(array.path.substr(0, array.path.find('/', session.path.size() + 1)));
  }
  without.erase(session.path + "/CONFIGURATION");
  results::Hdf5Limits limits;
  limits.skipForeign = true;
  limits.objects = 200000;
  limits.without.assign(without.begin(), without.end());
  try {
    const auto again = results::readHdf5(path, limits);
    return {namesIn(again, track), namesIn(again, line)};
  } catch (const FileError&) {
    return names;  // names are a comfort: a list that is too long is no reason not to read
  }
}

}  // namespace squat::rcmdx

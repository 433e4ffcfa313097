#include <string_view>
#include <vector>

#include "rcmdx/SpecifiedColumns.h"
#include "text/Numbers.h"

namespace squat::rcmdx {
namespace {

enum class ColumnType { text, whole32, float32 };

struct TopologyColumn {
  std::string_view name;
  ColumnType type;
};

struct TopologyTable {
  std::string_view group, element;
  std::vector<TopologyColumn> columns;
};

// Of tables that this program has nothing to say about.
const std::vector<TopologyTable>& unknownTables() {
  constexpr auto text = ColumnType::text, whole = ColumnType::whole32, real = ColumnType::float32;
  static const std::vector<TopologyTable> tables{
      {"SWITCHTRACK",
       "TopologySwitchTrack",
       {{"gleisstrangId", whole},
        {"gleisstrangBez", text},
        {"weicheId", whole},
        {"ablenkRichtung", text},
        {"ablenkung", text},
        {"betriebspunkt", text},
        {"herzStueck", text},
        {"minRadius", whole},
        {"nr", whole},
        {"zusNr", text},
        {"schienenProfil", text},
        {"status", text},
        {"schwellenArt", text},
        {"typenPlanNr", whole},
        {"typNrZusatz", text},
        {"weichenArt", text},
        {"weichenTyp", text},
        {"weichenForm", text},
        {"weichenZunge", text}}},
      {"TRACKOBJECT",
       "TopologyTrackObject",
       {{"trackid", whole}, {"type", whole}, {"positionstart", whole}, {"positionend", whole}, {"extrainfo", text}}},
      {"TRACKPOINT",
       "TopologyTrackPoint",
       {{"trackid", whole},
        {"lineid", whole},
        {"x", real},
        {"y", real},
        {"z", real},
        {"radius", real},
        {"kilometer", real},
        {"position", real},
        {"cant", real},
        {"steigung", real}}},
      {"PROPERTY",
       "TopologyProperty",
       {{"id", whole},
        {"name", text},
        {"description.ge", text},
        {"description.fr", text},
        {"description.it", text},
        {"description.en", text}}}};
  return tables;
}

Cells noCells(ColumnType type) {
  switch (type) {
    case ColumnType::text:
      return std::vector<std::string>{};
    case ColumnType::whole32:
      return std::vector<std::int32_t>{};
    case ColumnType::float32:
      return std::vector<float>{};
  }
  return std::vector<std::string>{};
}

void writeTracks(TypedFile& file, const std::string& group, const std::vector<TrackToWrite>& tracks) {
  const std::size_t n = tracks.size();
  std::vector<std::int32_t> ids;
  std::vector<std::string> lengths, names, lines;
  for (const auto& track : tracks) {
    ids.push_back(track.id);
    lengths.push_back(track.length > 0 ? text::numberText(track.length) : std::string());
    names.push_back(track.name);
    lines.push_back(track.line);
  }
  writeElement(file, group, "TopologyTrack");
  const auto column = [&](const char* name, const Cells& cells) { writeColumn(file, group, "data", name, cells); };
  column("direction", std::vector<std::string>(n, "-"));  // no switch
  column("id", ids);
  column("gtgid", std::vector<std::string>(n));
  column("length", lengths);
  column("name", names);
  column("nrline", lines);
  column("pointfrom", std::vector<std::int32_t>(n, -1));
  column("pointto", std::vector<std::int32_t>(n, -1));
  column("switchtype", std::vector<std::int8_t>(n, 0));  // anything but a turnout
  column("tracktype", std::vector<std::int8_t>(n, 1));   // track
}

void writeLines(TypedFile& file, const std::string& group, const std::vector<LineToWrite>& lines) {
  std::vector<std::int32_t> ids;
  std::vector<std::string> names;
  for (const auto& line : lines) {
    ids.push_back(line.id);
    names.push_back(line.name);
  }
  writeElement(file, group, "TopologyLine");
  const auto column = [&](const char* name, const Cells& cells) { writeColumn(file, group, "data", name, cells); };
  column("id", ids);
  column("name", names);
  for (const char* name : {"firststation", "laststation", "fromkilometer", "tokilometer"})
    column(name, std::vector<std::string>(lines.size()));
}

}  // namespace

void writeTopology(TypedFile& file, const std::string& group, const EventsToWrite& events) {
  writeElement(file, group, "Topology");
  file.attribute(group, "DfAVersion", std::string());
  // The specification asks for attributes of SBB's Diamond without naming one.
  file.attribute(group, "diamond-Source", std::string("none"));
  writeTracks(file, group + "/TRACK", events.tracks);
  writeLines(file, group + "/LINE", events.lines);
  for (const auto& table : unknownTables()) {
    const auto path = group + "/" + std::string(table.group);
    writeElement(file, path, std::string(table.element));
    for (const auto& column : table.columns)
      writeColumn(file, path, "data", std::string(column.name), noCells(column.type));
  }
}

}  // namespace squat::rcmdx

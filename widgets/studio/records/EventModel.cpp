#include "studio/records/EventModel.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/Errors.h"
#include "studio/common/RowTable.h"
#include "studio/records/LabelCommand.h"
#include "text/Numbers.h"

namespace squat::studio {
namespace {

using detection::Kind;
using detection::Severity;

struct SeenAs {
  Kind kind;
  Severity severity;
};

// In the order of labels(), which begins with nothing.
constexpr SeenAs choices[] = {{Kind::squat, Severity::light},  {Kind::squat, Severity::moderate},
                              {Kind::squat, Severity::severe}, {Kind::joint, Severity::light},
                              {Kind::weld, Severity::light},   {Kind::corrugation, Severity::light},
                              {Kind::flat, Severity::light},   {Kind::other, Severity::light}};

QString words(const SeenAs& choice) {
  const QString kind = QString::fromStdString(detection::toText(choice.kind));
  return choice.kind == Kind::squat ? QString::fromStdString(detection::toText(choice.severity)) + " " + kind : kind;
}

bool sharesARecord(const detection::DetectionReport& one, const detection::DetectionReport& other) {
  for (const auto& a : one.records)
    for (const auto& b : other.records)
      if (a.layout.path == b.layout.path) return true;
  return false;
}

Severity severityFromText(const std::string& text) {
  for (const auto severity : {Severity::light, Severity::moderate, Severity::severe})
    if (text == detection::toText(severity)) return severity;
  throw CaseError({{"severity", text, "light, moderate or severe", ""}});
}

// The list has the probability of this side alone; the others share what is left.
detection::SideJudgement sideFromText(const std::string& text, double sureness) {
  using enum detection::RailSide;
  detection::SideJudgement judged;
  for (const auto side : {left, right, both}) {
    judged.probability.fill(std::min(0.5 * (1 - sureness), 0.99 * sureness));  // rounded, it may be below a third
    judged.probability[static_cast<std::size_t>(side)] = sureness;
    if (text == detection::toText(side)) return judged;
  }
  throw CaseError({{"side", text, "left, right or both", ""}});
}

detection::CombinedEvent eventOf(const project::ListedEvent& listed, std::size_t record) {
  detection::CombinedEvent combined{{}, {record}, 0};
  auto& event = combined.event;
  event.channel = listed.channel, event.unit = "m/s2";
  event.position = listed.position, event.time = listed.time;
  event.kind = detection::kindFromText(listed.kind);
  event.sureness = listed.sureness;
  event.peak = listed.peak;
  event.features.speed = listed.speed;
  event.reason = listed.reason;
  event.passes = static_cast<std::size_t>(listed.passes);
  event.passesThere = static_cast<std::size_t>(listed.passesThere);
  event.extent = listed.extent;
  if (!listed.side.empty()) event.side = sideFromText(listed.side, listed.sideSureness);
  if (event.kind != Kind::squat) return combined;
  event.judgement.severity = severityFromText(listed.severity);
  auto& judged = event.judgement;
  judged.length = listed.length, judged.lengthLow = listed.lengthLow, judged.lengthHigh = listed.lengthHigh;
  judged.depth = listed.depth, judged.depthLow = listed.depthLow, judged.depthHigh = listed.depthHigh;
  judged.severities = listed.severities;
  judged.offset = listed.impact;
  return combined;
}

QString rounded(double value) { return QString::fromStdString(text::roundedText(value)); }

}  // namespace

ReportPointer reportOf(const project::EventList& list, const std::vector<std::string>& files) {
  const auto nameOf = [](const std::string& path) { return std::filesystem::path(path).filename(); };
  auto report = std::make_shared<detection::DetectionReport>();
  for (const auto& path : list.records) {
    const auto now =
        std::find_if(files.begin(), files.end(), [&](const auto& file) { return nameOf(file) == nameOf(path); });
    report->records.emplace_back();
    report->records.back().layout.path = now == files.end() ? path : *now;
  }
  for (const auto& event : list.events) {
    const auto record = std::find(list.records.begin(), list.records.end(), event.record) - list.records.begin();
    report->events.push_back(eventOf(event, static_cast<std::size_t>(record)));
  }
  return report;
}

QStringList EventModel::labels() {
  QStringList all{QString()};
  for (const auto& choice : choices) all << words(choice);
  return all;
}

// The undo stack tells that it is empty when it goes: the view that listens may be gone in part.
EventModel::~EventModel() { undo_.disconnect(); }

void EventModel::setReport(const ReportPointer& report) {
  beginResetModel();
  const bool isSameTrack = report_ && report && sharesARecord(*report_, *report);
  const auto seenBefore = isSameTrack ? seenEvents() : std::vector<detection::SeenEvent>();
  const auto placesBefore = seen_;
  report_ = report;
  seen_.clear();
  auto place = placesBefore.begin();
  for (const auto& before : seenBefore) {
    const int row = nearest(before.channel, before.position);
    if (row >= 0) seen_[row] = place->second;
    ++place;
  }
  endResetModel();
  undo_.clear();
}

int EventModel::nearest(const std::string& onChannel, double metres) const {
  int found = -1;
  double distance = 0.5;  // [m], that of labels
  for (int row = 0; row < rowCount(); ++row) {
    const auto& event = at(row).event;
    const double away = std::abs(event.position - metres);
    if (event.extent > 0) continue;  // a stretch of corrugation is no event
    // What two boxes of a wheelset show is one row, on either channel.
    const bool isHere = event.channel == onChannel || (event.side && found < 0);
    if (isHere && away < distance) found = row, distance = away;
  }
  return found;
}

int EventModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !report_ ? 0 : static_cast<int>(report_->events.size());
}

int EventModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : columns; }

double EventModel::number(int row, int column) const {
  const auto& event = at(row).event;
  const bool isSquat = event.kind == Kind::squat;
  switch (column) {
    case position:
      return event.position;
    case severity:
      return isSquat ? static_cast<double>(event.judgement.severity) : -1;
    case length:
      return isSquat ? 1e3 * event.judgement.length : NAN;
    case depth:
      return isSquat ? 1e3 * event.judgement.depth : NAN;
    case peak:
      return event.peak;
    case speed:
      return event.features.speed;
    case passes:
      return static_cast<double>(event.passes);
    case sureness:
      return event.sureness;
    default:
      return NAN;
  }
}

QString EventModel::text(int row, int column) const {
  const auto& event = at(row).event;
  switch (column) {
    case position:
      return QString::number(event.position, 'f', 2);
    case kind:
      return QString::fromStdString(detection::toText(event.kind));
    case severity:
      return event.kind == Kind::squat ? QString::fromStdString(detection::toText(event.judgement.severity))
                                       : QString::fromStdString(event.reason);
    case channel:
      return QString::fromStdString(event.channel);
    case side:
      return event.side ? tr("%1 %2 %")
                              .arg(QString::fromStdString(detection::toText(event.side->side())))
                              .arg(100 * event.side->sureness(), 0, 'f', 0)
                        : QString();
    case passes:
      return tr("%1 of %2").arg(event.passes).arg(event.passesThere);
    case sureness:
      return tr("%1 %").arg(100 * event.sureness, 0, 'f', 0);
    case seen: {
      const int label = labelOf(row);
      return label == 0 ? QString() : labels().at(label);
    }
    default: {
      const double value = number(row, column);
      return std::isnan(value) ? QString() : rounded(value);
    }
  }
}

QVariant EventModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const bool isText =
      index.column() == kind || index.column() == channel || index.column() == side || index.column() == seen;
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return text(index.row(), index.column());
    case sortRole: {
      if (isText) return text(index.row(), index.column());
      const double value = number(index.row(), index.column());
      return std::isnan(value) ? QVariant() : QVariant(value);  // what has none comes last
    }
    case Qt::TextAlignmentRole:
      return isText || index.column() == severity ? int(Qt::AlignLeft | Qt::AlignVCenter)
                                                  : int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ToolTipRole:
      return index.column() == seen ? tr("What you have seen there; “Save labels…” keeps it") : QString();
    default:
      return {};
  }
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const {
  static const QStringList names{"position", "kind",    "severity", "length", "depth",    "peak",
                                 "speed",    "channel", "side",     "passes", "sureness", "seen_as"};
  if (orientation == Qt::Horizontal && role == columnNameRole) return names.value(section);
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  static const QStringList heads{tr("Position\n[m]"), tr("Kind"),         tr("Severity"),     tr("Length\n[mm]"),
                                 tr("Depth\n[mm]"),   tr("Peak\n[m/s²]"), tr("Speed\n[m/s]"), tr("Channel"),
                                 tr("Side"),          tr("Passes"),       tr("Sure"),         tr("Label")};
  return heads.value(section);
}

bool EventModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || index.column() != seen) return false;
  const auto label = static_cast<int>(labels().indexOf(value.toString()));
  if (label < 0) return false;
  const int before = labelOf(index.row());
  if (label != before) undo_.push(new LabelCommand(*this, EventPointer(report_, &at(index.row())), before, label));
  return true;
}

int EventModel::labelOf(int row) const {
  const auto found = seen_.find(row);
  return found == seen_.end() ? 0 : found->second;
}

void EventModel::setLabel(int row, int label) {
  if (label == 0)
    seen_.erase(row);
  else
    seen_[row] = label;
  Q_EMIT dataChanged(index(row, seen), index(row, seen));
}

void EventModel::become(const EventPointer& event, int label) {
  for (int row = 0; row < rowCount(); ++row) {
    if (&at(row) != event.get()) continue;
    setLabel(row, label);
    Q_EMIT labelStepped(row);
  }
}

Qt::ItemFlags EventModel::flags(const QModelIndex& index) const {
  const auto usual = QAbstractTableModel::flags(index);
  return index.column() == seen ? usual | Qt::ItemIsEditable : usual;
}

std::vector<detection::SeenEvent> EventModel::seenEvents() const {
  std::vector<detection::SeenEvent> all;
  for (const auto& [row, place] : seen_) {
    const auto& choice = choices[place - 1];
    const auto& event = at(row).event;
    all.push_back({event.position, event.channel, choice.kind, choice.severity});
  }
  return all;
}

std::vector<project::SeenEvent> EventModel::seenForProject() const {
  constexpr double unit = 1e-3;  // [m]
  std::vector<project::SeenEvent> all;
  for (const auto& [row, label] : seen_) {
    const auto& event = at(row).event;
    all.push_back({std::round(event.position / unit) * unit, event.channel, labels().at(label).toStdString()});
  }
  return all;
}

bool EventModel::see(const project::SeenEvent& noted) {
  const int row = nearest(noted.channel, noted.position);
  const auto label = static_cast<int>(labels().indexOf(QString::fromStdString(noted.seenAs)));
  if (row < 0 || label < 0) return false;
  setLabel(row, label);
  return true;
}

}  // namespace squat::studio

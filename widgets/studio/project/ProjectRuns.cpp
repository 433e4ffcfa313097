#include "studio/project/ProjectRuns.h"

#include <QFileInfo>

#include "project/LinkedRun.h"

namespace squat::studio {

project::Entry entryOf(const StoredRun& run) {
  project::Entry entry;
  if (run.isMissing()) {
    entry = *run.link;
  } else {
    entry.kind = run.isMeasured() ? project::Kind::measured : project::Kind::run;
    entry.path = run.file().toStdString();
    entry.digest = project::recordDigest(*run.record);
    entry.overlaid = run.overlaid;
    entry.signal = run.record->run;
    entry.reading = run.reading.options;
    entry.impact = run.reading.impact, entry.gain = run.reading.gain, entry.isAutomatic = run.reading.isAutomatic;
  }
  entry.name = run.label.toStdString();
  entry.named = run.named;
  entry.colour = run.colour.isValid() ? run.colour.name().toStdString() : std::string();
  return entry;
}

StoredRun listedRun(const project::Entry& entry) {
  StoredRun run;
  run.missing = QObject::tr("%1 is being read").arg(QString::fromStdString(entry.path));
  run.opening = true;
  run.link = std::make_shared<project::Entry>(entry);
  run.record = std::make_shared<signals::Record>();
  run.label = QString::fromStdString(entry.name);
  run.named = entry.named;
  run.path = QString::fromStdString(entry.path);
  run.overlaid = entry.overlaid;
  run.colour = QColor(QString::fromStdString(entry.colour));
  return run;
}

StoredRun openEntry(const project::Entry& entry, results::ResultContent content, QString& problem) {
  StoredRun run;
  if (entry.kind == project::Kind::measured) {
    const auto linked = project::openSignal(entry);
    problem = QString::fromStdString(linked.problem);
    run.record = linked.measured.record;
    run.reading = linked.measured.reading;
  } else {
    auto linked = project::openRun(entry, content);
    problem = QString::fromStdString(linked.problem);
    run.result = linked.result;
    run.record = linked.result;
    run.fields = content == results::ResultContent::withoutFields ? Fields::inFile : Fields::both;
  }
  if (run.record) describe(run);
  return run;
}

void listRuns(const RunStore& store, project::Project& project) {
  const int current = store.current() >= 0 ? store.current() : store.waitingCurrent();
  for (int row = 0; row < store.rowCount(); ++row) {
    const StoredRun& run = store.at(row);
    if (run.path.isEmpty() && !(run.kept && QFileInfo::exists(run.kept->path()))) continue;
    const int place = static_cast<int>(project.entries.size());
    if (row == current) project.current = place;
    if (row == store.chosenReference()) project.reference = place;
    project.entries.push_back(entryOf(run));
  }
}

}  // namespace squat::studio

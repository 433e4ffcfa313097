#include "studio/project/ProjectRuns.h"

#include <algorithm>

#include "project/LinkedRun.h"

namespace squat::studio {
namespace {

project::Entry entryOf(const StoredRun& run) {
  project::Entry entry;
  if (run.isMissing()) {
    entry = *run.link;
  } else {
    entry.kind = run.isMeasured() ? project::Kind::measured : project::Kind::run;
    entry.path = run.path.toStdString();
    entry.digest = project::recordDigest(*run.record);
    entry.overlaid = run.overlaid;
    entry.signal = run.record->run;
    entry.reading = run.reading.options;
    entry.impact = run.reading.impact;
  }
  entry.name = run.label.toStdString();
  entry.named = run.named;
  entry.colour = run.colour.isValid() ? run.colour.name().toStdString() : std::string();
  return entry;
}

// The signal of the file that the entry means.
StoredRun openSignal(const project::Entry& entry, QString& problem) {
  StoredRun run;
  run.reading = {entry.reading, entry.impact};
  try {
    const auto records = measuredRecords(QString::fromStdString(entry.path), entry.reading.speed, run.reading);
    const auto found = std::find_if(records.begin(), records.end(),
                                    [&](const auto& each) { return each.record->run == entry.signal; });
    if (found == records.end()) {
      problem = QObject::tr("%1 has no signal “%2” any more")
                    .arg(QString::fromStdString(entry.path), QString::fromStdString(entry.signal));
    } else {
      run.record = found->record;
      problem = QString::fromStdString(project::changeOf(entry, *run.record));
    }
  } catch (const std::exception& error) {
    problem = QString::fromStdString(error.what());
  }
  return run;
}

StoredRun openEntry(const project::Entry& entry, QString& problem) {
  if (entry.kind == project::Kind::measured) return openSignal(entry, problem);
  StoredRun run;
  auto linked = project::openRun(entry);
  problem = QString::fromStdString(linked.problem);
  run.result = linked.result;
  run.record = linked.result;
  return run;
}

}  // namespace

void listRuns(const RunStore& store, project::Project& project) {
  for (int row = 0; row < store.rowCount(); ++row) {
    const StoredRun& run = store.at(row);
    if (run.path.isEmpty()) continue;
    const int place = static_cast<int>(project.entries.size());
    if (row == store.current()) project.current = place;
    if (row == store.chosenReference()) project.reference = place;
    project.entries.push_back(entryOf(run));
  }
}

std::vector<StoredRun> openRuns(const project::Project& project, QStringList& problems) {
  std::vector<StoredRun> runs;
  for (const auto& entry : project.entries) {
    QString problem;
    StoredRun run = openEntry(entry, problem);
    if (!problem.isEmpty()) problems << problem;
    if (!run.record) {
      run.missing = problem;
      run.link = std::make_shared<project::Entry>(entry);
      run.record = std::make_shared<signals::Record>();
    }
    run.label = QString::fromStdString(entry.name);
    run.named = entry.named;
    run.path = QString::fromStdString(entry.path);
    run.overlaid = entry.overlaid;
    run.colour = QColor(QString::fromStdString(entry.colour));
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace squat::studio

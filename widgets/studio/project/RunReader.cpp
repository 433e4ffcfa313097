#include "studio/project/RunReader.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "core/Errors.h"
#include "project/LinkedRun.h"
#include "studio/common/WaitForSignal.h"
#include "studio/project/ProjectRuns.h"

namespace squat::studio {
namespace {

// What the eye is on comes first.
std::vector<std::size_t> readingOrder(const project::Project& project) {
  std::vector<std::size_t> order(project.entries.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto rank = [&](std::size_t i) {
    if (static_cast<int>(i) == project.current) return 0;
    return project.entries[i].overlaid || static_cast<int>(i) == project.reference ? 1 : 2;
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return rank(a) < rank(b); });
  return order;
}

ResultPointer withoutFields(const results::RunResult& result) {
  auto light = std::make_shared<results::RunResult>(result);
  light->surface = {}, light->snapshots.clear(), light->patches.clear();
  return light;
}

}  // namespace

RunReader::RunReader(RunStore& store, QObject* parent) : QObject(parent), store_(store) {
  thread_.setMaxThreadCount(1);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &RunReader::list);
  connect(&store_, &RunStore::currentChanged, this, &RunReader::readFields);
}

RunReader::~RunReader() {
  ++generation_;
  thread_.clear();
  thread_.waitForDone();
}

void RunReader::open(const project::Project& project, const QString& unsaved) {
  const int generation = ++generation_;
  thread_.clear();
  timer_.stop();
  arrived_.clear(), problems_.clear(), whole_.clear(), asked_.reset(), wanted_.clear();
  std::vector<StoredRun> runs;
  for (const auto& entry : project.entries) {
    StoredRun run = listedRun(entry);
    if (!unsaved.isEmpty() && QFileInfo(run.path).path() == unsaved)
      run.kept = std::make_shared<KeptFile>(std::exchange(run.path, QString()));
    runs.push_back(std::move(run));
  }
  std::vector<RunLink> links;
  for (const std::size_t place : readingOrder(project)) links.push_back(runs[place].link);
  const RecordPointer reference =
      project.reference < 0 ? nullptr : runs.at(static_cast<std::size_t>(project.reference)).record;
  ahead_ = all_ = static_cast<int>(runs.size());
  store_.replaceAll(std::move(runs), project.current);
  if (reference) store_.setReference(store_.rowOfRecord(reference));
  for (const RunLink& link : links) ask(link, generation);
  Q_EMIT progressed(0, all_);
}

void RunReader::add(const std::vector<std::pair<std::string, std::string>>& namedFiles) {
  std::vector<StoredRun> runs;
  std::vector<RunLink> links;
  for (const auto& [path, name] : namedFiles) {
    bool isListed = false;
    for (int row = 0; row < store_.rowCount(); ++row) isListed = isListed || store_.at(row).path.toStdString() == path;
    if (isListed) continue;
    project::Entry entry;
    entry.path = path;
    entry.name = name;
    runs.push_back(listedRun(entry));
    links.push_back(runs.back().link);
  }
  if (links.empty()) return;
  if (ahead_ == 0) all_ = 0;
  ahead_ += static_cast<int>(links.size()), all_ += static_cast<int>(links.size());
  store_.list(std::move(runs));
  for (const RunLink& link : links) ask(link, generation_);
  Q_EMIT progressed(all_ - ahead_, all_);
}

void RunReader::show(const std::string& file, const std::string& name) {
  wanted_ = file;
  add({{file, name}});
  showWanted();
}

void RunReader::showWanted() {
  for (int row = 0; !wanted_.empty() && row < store_.rowCount(); ++row) {
    const StoredRun& run = store_.at(row);
    if (run.path.toStdString() != wanted_) continue;
    if (run.opening) return;
    wanted_.clear();
    if (run.result) store_.setCurrent(row);
  }
}

void RunReader::ask(const RunLink& link, int generation) {
  thread_.start([this, link, generation] {
    if (generation != generation_) return;
    QString problem;
    StoredRun run = openEntry(*link, results::ResultContent::withoutFields, problem);
    QMetaObject::invokeMethod(
        this,
        [this, link, generation, run = std::move(run), problem] {
          if (generation == generation_) take(link, run, problem);
        },
        Qt::QueuedConnection);
  });
}

// A table of hundreds of runs is laid out anew with every change: what arrives is shown a few times a second, the first
// one at once.
void RunReader::take(const RunLink& link, StoredRun run, const QString& problem) {
  if (!problem.isEmpty()) problems_ << problem;
  if (!run.record) run.missing = problem;
  const bool first = ahead_ == all_;
  --ahead_;
  arrived_.emplace_back(link, std::move(run));
  if (first || ahead_ == 0)
    list();
  else if (!timer_.isActive())
    timer_.start(300);
}

void RunReader::list() {
  timer_.stop();
  std::vector<std::pair<int, StoredRun>> read;
  for (auto& [link, run] : std::exchange(arrived_, {}))
    if (const int row = store_.rowOfLink(link); row >= 0) read.emplace_back(row, std::move(run));
  store_.fill(read);
  showWanted();
  Q_EMIT progressed(all_ - ahead_, all_);
  if (ahead_ == 0) Q_EMIT finished(std::exchange(problems_, {}));
}

bool RunReader::waitFor(int milliseconds) {
  if (isBusy()) waitForSignal(this, &RunReader::finished, milliseconds);
  return !isBusy();
}

void RunReader::readFields() {
  const int row = store_.current();
  if (row < 0) return;
  const StoredRun& run = store_.at(row);
  const auto used = std::find(whole_.begin(), whole_.end(), run.record);
  if (used != whole_.end()) std::rotate(whole_.begin(), used, used + 1);
  if (run.fields != Fields::inFile || asked_ == run.record) return;
  asked_ = run.record;
  // Before the files that nobody looks at yet.
  thread_.start(
      [this, light = run.record, entry = entryOf(run), generation = generation_.load()] {
        if (generation != generation_) return;
        QString problem;
        const ResultPointer whole = openEntry(entry, results::ResultContent::everything, problem).result;
        QMetaObject::invokeMethod(
            this, [this, light, whole, problem] { takeFields(light, whole, problem); }, Qt::QueuedConnection);
      },
      1);
}

void RunReader::takeFields(const RecordPointer& light, const ResultPointer& whole, const QString& problem) {
  const int row = store_.rowOfRecord(light);
  if (row < 0) return;
  if (!problem.isEmpty()) {  // not asked for again until another run was the current one
    Q_EMIT failed(problem);
    return;
  }
  setWhole(row, whole);
}

void RunReader::setWhole(int row, const ResultPointer& whole) {
  whole_.push_front(whole);
  store_.setResult(row, whole, Fields::both);
  std::erase_if(whole_, [this](const auto& each) { return store_.rowOfRecord(each) < 0; });
  while (whole_.size() > keptFields) {
    const int last = store_.rowOfRecord(whole_.back());
    whole_.pop_back();
    if (last != store_.current()) store_.setResult(last, withoutFields(*store_.at(last).result), Fields::inFile);
  }
}

ResultPointer RunReader::wholeResult(int row) {
  const StoredRun& run = store_.at(row);
  if (run.fields != Fields::inFile) return run.result;
  const auto whole = std::make_shared<results::RunResult>(results::readResult(run.file().toStdString()));
  if (whole->stem.empty()) whole->stem = run.result->stem;
  if (const std::string change = project::changeOf(entryOf(run), *whole); !change.empty())
    throw FileError(run.file().toStdString(), "", "holds other values than when the project was opened",
                    "Open the project again");
  setWhole(row, whole);
  return whole;
}

}  // namespace squat::studio

// widgets/studio/runs/RunStore.h - the runs of this session, side by side.
#pragma once

#include <QAbstractListModel>
#include <QColor>
#include <QString>
#include <vector>

#include "analysis/RunFeatures.h"
#include "case/CaseNames.h"
#include "project/MeasuredRecords.h"
#include "project/Project.h"
#include "studio/runs/KeptFile.h"
#include "studio/runs/RunController.h"

namespace squat::studio {

using project::MeasuredReading;
using project::RecordPointer;
using RunLink = std::shared_ptr<const project::Entry>;

// Where surface, snapshots and contact patches of a run are: of a project's runs the file's, read when they are shown.
enum class Fields { inMemory, inFile, both };

// A run of this program, or a measured record, which is laid over runs and is never the current one.
struct StoredRun {
  ResultPointer result;                      // null: measured
  QString label;                             // its name; made by the store where `named` is false
  QString path;                              // empty: not in a file yet
  bool overlaid = false;                     // drawn with the current one
  RecordPointer record = result;             // what is drawn; that of the result where there is one
  std::shared_ptr<KeptFile> kept = nullptr;  // for a crash, until the run has a path
  bool named = true;                         // the user, or a file, gave it its name
  std::size_t colourIndex = 0;               // which of the colours for overlays, kept while it is overlaid
  QColor colour = {};                        // chosen by the user; not valid: the automatic one
  std::shared_ptr<const cases::ComparedCase> values = nullptr;  // of its case; null: none is known
  analysis::RunDigest digest = {};
  MeasuredReading reading = {};  // of a measured one
  // Why a file that a project links to is not shown, and the link; its record is empty then. Empty: nothing is missing.
  QString missing = {};
  RunLink link = nullptr;
  bool opening = false;  // it is missing because it is still being read
  Fields fields = Fields::inMemory;
  bool dragged = false;  // a measured signal that moves under the mouse: its numbers are not worth computing
  // Of a measured signal, the same however it is laid and wherever it stands; 0: nobody has asked for it.
  std::size_t signal = 0;

  bool isMeasured() const { return !result; }
  bool isMissing() const { return !missing.isEmpty(); }
  QString file() const { return kept ? kept->path() : path; }  // where it can be read from; empty: in no file
};

// Fills in what the table and the names need of a run: its compared case and its digest.
void describe(StoredRun& run);

// A list with check boxes: checked runs are overlaid on the current one. Runs without a name of their own are called by
// what differs between them (case/CaseNames.h), anew with every run that joins or leaves.
class RunStore : public QAbstractListModel {
  Q_OBJECT
 public:
  explicit RunStore(QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  // Makes it the current one, unless it is measured, which is overlaid instead. Returns its row.
  int add(StoredRun run);
  // In place of all there are, overlaid or not as each says; `current` is the row that becomes the current one,
  // once it is read.
  void replaceAll(std::vector<StoredRun> runs, int current);
  // Runs whose files are still to be read, after all there are. The first of them becomes the current one where there
  // is none.
  void list(std::vector<StoredRun> runs);
  // What was read of the files of rows that were opening: name, colour and overlay stay as they are listed.
  void fill(const std::vector<std::pair<int, StoredRun>>& read);
  // The same run with or without fields.
  void setResult(int row, const ResultPointer& result, Fields fields);
  // A measured signal that is laid otherwise; `dragged`: for a moment only.
  void setMeasured(int row, const project::MeasuredRecord& measured, bool dragged = false);
  void remove(int row);
  // Removes a run so that restore() can bring it back, where and as it stood: the last five, the last one first. Their
  // results that are not saved stay until then. A run whose file is still being read is removed for good.
  void putAside(int row);
  bool canRestore() const { return !aside_.empty(); }
  int restore();  // returns its row
  // An empty name gives a run of this program the one that is made from what differs between runs.
  void rename(int row, const QString& name);
  void setColour(int row, const QColor& colour);  // not valid: the automatic one again
  int current() const { return current_; }
  int waitingCurrent() const;  // the row that becomes the current one once it is read; -1: none
  void setCurrent(int row);
  ResultPointer currentResult() const;
  int rowOf(const ResultPointer& result) const;        // -1: not in the list (any more)
  int rowOfRecord(const RecordPointer& record) const;  // the same of runs and measured signals
  std::size_t signalNumber(int row);                   // StoredRun::signal, for as long as the store lives
  int rowOfSignal(std::size_t number) const;           // -1: not in the list
  int rowOfLink(const RunLink& link) const;            // of what a project links to and is not read yet
  const StoredRun& at(int row) const { return runs_.at(static_cast<std::size_t>(row)); }
  void setPath(int row, const QString& path);
  // What the comparison compares with: the one that was set, else the first measured signal, else the first run; -1:
  // there is none.
  int reference() const;
  int chosenReference() const { return reference_ ? rowOfRecord(reference_) : -1; }
  void setReference(int row);
  std::vector<ResultPointer> unsaved() const;  // computed results that are in no file
  std::vector<StoredRun> overlays() const;     // checked ones other than the current

 Q_SIGNALS:
  void currentChanged();
  void overlaysChanged();
  void namesChanged();
  void referenceChanged();
  void filled();

  void asideChanged();

 private:
  struct Aside {
    int row;
    StoredRun run;
    bool isCurrent;
  };
  void makeNames();
  bool fillRow(int row, const StoredRun& read);  // whether it becomes the current one
  std::size_t freeColourIndex() const;
  int computedNear(int row) const;  // the next computed run from this row on, else the one before; -1: none
  std::vector<StoredRun> runs_;
  int current_ = -1;
  std::vector<Aside> aside_;
  RecordPointer reference_;  // null: none was set
  RunLink waiting_;          // of the row that becomes the current one
  std::size_t lastSignal_ = 0;
};

}  // namespace squat::studio

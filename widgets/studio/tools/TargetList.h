// widgets/studio/tools/TargetList.h - what a calibrated case has to reproduce: shipped targets, files, measured
// signals.
#pragma once

#include <QPersistentModelIndex>
#include <QStringList>
#include <map>
#include <string>
#include <vector>

#include "project/MeasuredRecords.h"
#include "studio/tools/ButtonedList.h"

class QMenu;

namespace squat::studio {

class RunStore;

// What is chosen: names of shipped targets and paths, and measured signals as they are laid now.
struct ChosenTargets {
  struct Signal {
    std::string name;
    project::RecordPointer record;
  };
  std::vector<std::string> files;
  std::vector<Signal> measured;

  bool isEmpty() const { return files.empty() && measured.empty(); }
};

// Writes the measured signals as FOLDER/case/measured-1.csv and so on: what is shown, with its gain, whatever file it
// is from. Returns the paths. Throws CaseError where `table`, the tool's own file, stands in the folder and was
// computed from other signals (empty: the tool never resumes); FileError.
std::vector<std::string> writeMeasured(const ChosenTargets& chosen, const std::string& folder,
                                       const std::string& table = {});

class TargetList : public ButtonedList {
  Q_OBJECT
 public:
  enum class Offer { targets, passages };  // all that a case may have to reproduce; measured passages alone
  TargetList(const RunStore& store, Offer offer, QWidget* parent = nullptr);

  ChosenTargets chosen() const;
  void addFile(const QString& nameOrPath);
  void setFile(const QString& nameOrPath);  // in place of all that is listed
  void addSignal(int row);                  // of the store; measured
  // Names and paths alone: measured signals of another day are not offered again.
  QStringList files() const;

 private:
  void fillMenu();
  void removeChosen();

  const RunStore& store_;
  Offer offer_;
  std::map<QListWidgetItem*, QPersistentModelIndex> measured_;  // rows of the store
  QMenu* menu_;
};

}  // namespace squat::studio

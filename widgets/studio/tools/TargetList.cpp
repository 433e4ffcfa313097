#include "studio/tools/TargetList.h"

#include <QFileDialog>
#include <QMenu>
#include <filesystem>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "signals/SignalCatalogue.h"
#include "studio/runs/RunStore.h"
#include "text/Csv.h"

namespace squat::studio {
namespace {

constexpr int fileRole = Qt::UserRole;

}  // namespace

TargetList::TargetList(const RunStore& store, Offer offer, QWidget* parent)
    : ButtonedList("Target", offer == Offer::targets ? tr("Add a &target") : tr("Add a &passage"),
                   offer == Offer::targets ? tr("What the case has to reproduce") : tr("Measured passages"), 4, parent),
      store_(store),
      offer_(offer),
      menu_(new QMenu(this)) {
  list()->setObjectName("targets");
  add()->setPopupMode(QToolButton::InstantPopup);
  add()->setMenu(menu_);
  // A signal that has left the runs leaves this list.
  const auto forget = [this] {
    for (auto it = measured_.begin(); it != measured_.end();) {
      if (it->second.isValid()) {
        ++it;
        continue;
      }
      delete it->first;
      it = measured_.erase(it);
    }
  };
  connect(&store_, &RunStore::rowsRemoved, this, forget);
  connect(&store_, &RunStore::modelReset, this, forget);
  connect(menu_, &QMenu::aboutToShow, this, &TargetList::fillMenu);
  connect(remove(), &QToolButton::clicked, this, &TargetList::removeChosen);
  fillMenu();
}

void TargetList::fillMenu() {
  menu_->clear();
  const bool targets = offer_ == Offer::targets;
  if (targets) {
    menu_->addAction(tr("&Statements of the paper about the light defect"), this, [this] { addFile("light-defect"); });
    menu_->addAction(tr("&All statements of the paper about this case"), this, [this] { addFile("paper"); });
  }
  menu_->addAction(targets ? tr("&File: targets, signals or receptance…") : tr("&File…"), this, [this, targets] {
    const QString kinds =
        targets ? tr("Targets and tables (*.json *.csv *.txt *.gz *.h5 *.mat *.tdms *.lvm *.wav *.unv *.uff);;All "
                     "files (*)")
                : tr("Signals (*.csv *.txt *.gz *.h5 *.mat *.tdms *.lvm *.wav *.unv *.uff);;All files (*)");
    for (const QString& path : QFileDialog::getOpenFileNames(this, tr("Add files"), QString(), kinds)) addFile(path);
  });
  menu_->addSeparator();
  for (int row = 0; row < store_.rowCount(); ++row)
    if (store_.at(row).isMeasured() && !store_.at(row).isMissing())
      menu_->addAction(tr("Measured: %1").arg(store_.at(row).label), this, [this, row] { addSignal(row); });
}

void TargetList::addFile(const QString& nameOrPath) {
  for (int i = 0; i < list()->count(); ++i)
    if (list()->item(i)->data(fileRole).toString() == nameOrPath) return;
  auto* item = new QListWidgetItem(nameOrPath);
  item->setData(fileRole, nameOrPath);
  list()->addItem(item);  // complete: who hears of a new row asks what it is
  list()->setCurrentItem(item);
}

void TargetList::setFile(const QString& nameOrPath) {
  measured_.clear();
  list()->clear();
  addFile(nameOrPath);
}

void TargetList::addSignal(int row) {
  if (row < 0 || row >= store_.rowCount() || !store_.at(row).isMeasured()) return;
  const StoredRun& run = store_.at(row);
  for (const auto& [item, known] : measured_)
    if (known.row() == row) return;
  auto* item = new QListWidgetItem(tr("Measured: %1").arg(run.label));
  item->setToolTip(run.path);
  measured_.emplace(item, store_.index(row));
  list()->addItem(item);
  list()->setCurrentItem(item);
}

void TargetList::removeChosen() {
  QListWidgetItem* item = list()->takeItem(list()->currentRow());
  measured_.erase(item);
  delete item;
}

QStringList TargetList::files() const {
  QStringList all;
  for (int i = 0; i < list()->count(); ++i)
    if (const QString file = list()->item(i)->data(fileRole).toString(); !file.isEmpty()) all << file;
  return all;
}

ChosenTargets TargetList::chosen() const {
  ChosenTargets all;
  for (const QString& file : files()) all.files.push_back(file.toStdString());
  for (int i = 0; i < list()->count(); ++i) {
    const auto found = measured_.find(list()->item(i));
    if (found == measured_.end() || !found->second.isValid()) continue;  // removed from the list of runs
    const StoredRun& run = store_.at(found->second.row());
    if (!run.isMissing()) all.measured.push_back({run.label.toStdString(), run.record});
  }
  return all;
}

std::vector<std::string> writeMeasured(const ChosenTargets& chosen, const std::string& folder,
                                       const std::string& table) {
  std::vector<std::string> paths, made;
  for (const auto& [name, record] : chosen.measured) {
    paths.push_back(folder + "/case/measured-" + std::to_string(paths.size() + 1) + ".csv");
    const auto text = text::csvColumns({"time [s]", "position [m]", "aba [m/s2]"},
                                       {&record->time, &record->position, record->signal(signals::names::axleBox)});
    made.push_back(text);
  }
  const bool isUsed = !table.empty() && std::filesystem::exists(table);
  for (std::size_t i = 0; i < paths.size(); ++i)
    if (isUsed && !(std::filesystem::exists(paths[i]) && std::filesystem::file_size(paths[i]) == made[i].size() &&
                    readWholeFile(paths[i], made[i].size() + 1) == made[i]))
      throw CaseError({{"folder", folder, "a folder without results from other signals", "Choose another folder"}});
  if (!paths.empty()) makeFolder(folder + "/case");
  for (std::size_t i = 0; i < paths.size(); ++i) writeDurably(paths[i], std::string_view(made[i]));
  return paths;
}

}  // namespace squat::studio

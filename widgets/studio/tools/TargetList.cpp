#include "studio/tools/TargetList.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/DurableFile.h"
#include "studio/runs/RunStore.h"
#include "text/Csv.h"

namespace squat::studio {
namespace {

constexpr int fileRole = Qt::UserRole;

QToolButton* buttonOf(const QString& text, const QString& name, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setObjectName(name);
  button->setAccessibleName(QString(text).remove('&'));
  return button;
}

}  // namespace

TargetList::TargetList(const RunStore& store, Offer offer, QWidget* parent)
    : QWidget(parent), store_(store), offer_(offer), list_(new QListWidget(this)), menu_(new QMenu(this)) {
  list_->setObjectName("targets");
  list_->setAccessibleName(offer == Offer::targets ? tr("What the case has to reproduce") : tr("Measured passages"));
  constexpr int lines = 4;
  list_->setMaximumHeight(lines * (list_->fontMetrics().height() + 4));
  auto* add = buttonOf(offer == Offer::targets ? tr("Add a &target") : tr("Add a &passage"), "addTarget", this);
  add->setPopupMode(QToolButton::InstantPopup);
  add->setMenu(menu_);
  auto* remove = buttonOf(tr("Re&move"), "removeTarget", this);
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(add);
  buttons->addWidget(remove);
  buttons->addStretch(1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(list_, 1);
  layout->addLayout(buttons);
  connect(menu_, &QMenu::aboutToShow, this, &TargetList::fillMenu);
  connect(remove, &QToolButton::clicked, this, &TargetList::removeChosen);
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
    const QString kinds = targets ? tr("Targets and tables (*.json *.csv *.txt *.h5 *.mat);;All files (*)")
                                  : tr("Signals (*.csv *.txt *.h5 *.mat);;All files (*)");
    for (const QString& path : QFileDialog::getOpenFileNames(this, tr("Add files"), QString(), kinds)) addFile(path);
  });
  menu_->addSeparator();
  for (int row = 0; row < store_.rowCount(); ++row)
    if (store_.at(row).isMeasured() && !store_.at(row).isMissing())
      menu_->addAction(tr("Measured: %1").arg(store_.at(row).label), this, [this, row] { addSignal(row); });
}

void TargetList::addFile(const QString& nameOrPath) {
  for (int i = 0; i < list_->count(); ++i)
    if (list_->item(i)->data(fileRole).toString() == nameOrPath) return;
  auto* item = new QListWidgetItem(nameOrPath, list_);
  item->setData(fileRole, nameOrPath);
  list_->setCurrentItem(item);
}

void TargetList::addSignal(int row) {
  if (row < 0 || row >= store_.rowCount() || !store_.at(row).isMeasured()) return;
  const StoredRun& run = store_.at(row);
  for (const auto& [item, known] : measured_)
    if (known.row() == row) return;
  auto* item = new QListWidgetItem(tr("Measured: %1").arg(run.label), list_);
  item->setToolTip(run.path);
  measured_.emplace(item, store_.index(row));
  list_->setCurrentItem(item);
}

void TargetList::removeChosen() {
  QListWidgetItem* item = list_->takeItem(list_->currentRow());
  measured_.erase(item);
  delete item;
}

QStringList TargetList::files() const {
  QStringList all;
  for (int i = 0; i < list_->count(); ++i)
    if (const QString file = list_->item(i)->data(fileRole).toString(); !file.isEmpty()) all << file;
  return all;
}

ChosenTargets TargetList::chosen() const {
  ChosenTargets all;
  for (const QString& file : files()) all.files.push_back(file.toStdString());
  for (int i = 0; i < list_->count(); ++i) {
    const auto found = measured_.find(list_->item(i));
    if (found == measured_.end() || !found->second.isValid()) continue;  // removed from the list of runs
    const StoredRun& run = store_.at(found->second.row());
    if (!run.isMissing()) all.measured.push_back({run.label.toStdString(), run.record});
  }
  return all;
}

std::vector<std::string> writeMeasured(const ChosenTargets& chosen, const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& [name, record] : chosen.measured) {
    paths.push_back(folder + "/case/measured-" + std::to_string(paths.size() + 1) + ".csv");
    const auto text = text::csvColumns({"time [s]", "position [m]", "aba [m/s2]"},
                                       {&record->time, &record->position, record->signal("aba")});
    makeFolder(folder + "/case");
    writeDurably(paths.back(), std::string_view(text));
  }
  return paths;
}

}  // namespace squat::studio

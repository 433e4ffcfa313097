#include "studio/runs/RunsPanel.h"

#include <QHBoxLayout>
#include <QListView>
#include <QPushButton>
#include <QVBoxLayout>

#include "studio/common/ButtonKeys.h"
#include "studio/runs/RunStore.h"

namespace squat::studio {

RunsPanel::RunsPanel(RunStore& store, QWidget* parent) : QWidget(parent), store_(store) {
  list_ = new QListView(this);
  list_->setModel(&store_);
  list_->setAccessibleName(tr("Runs"));
  list_->setObjectName("runs");
  list_->setMinimumHeight(50);
  auto* buttons = new QHBoxLayout;
  const auto button = [&](const QString& text, const QString& tip, auto action) {
    auto* made = new QPushButton(text, this);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setObjectName(text);
    buttons->addWidget(made);
    connect(made, &QPushButton::clicked, this, action);
  };
  button(tr("Open…"), tr("Open a result"), &RunsPanel::openRequested);
  button(tr("Save…"), tr("Save the current result"), &RunsPanel::saveRequested);
  button(tr("Measured…"), tr("Overlay a measured signal"), &RunsPanel::measuredRequested);
  button(tr("Remove"), tr("Remove the selected run from the list"), [this] {
    if (list_->currentIndex().isValid()) Q_EMIT removeRequested(list_->currentIndex().row());
  });
  giveKeys(*this, {{tr("Open…"), "Ctrl+Shift+O"}, {tr("Remove"), "Ctrl+Delete"}});  // the others stand in a menu
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(list_, 1);
  layout->addLayout(buttons);
  const auto show = [this](const QModelIndex& index) {
    if (index.isValid() && !store_.at(index.row()).isMeasured()) store_.setCurrent(index.row());
  };
  // A click on the box overlays the run; it does not make it the current one.
  connect(list_, &QListView::pressed, this, [this] { ticked_ = false; });
  connect(&store_, &RunStore::overlaysChanged, this, [this] { ticked_ = true; });
  connect(list_, &QListView::clicked, this, [this, show](const QModelIndex& index) {
    if (!ticked_) show(index);
  });
  connect(list_, &QListView::activated, this, show);  // by keyboard
  connect(&store_, &RunStore::currentChanged, this,
          [this] { list_->setCurrentIndex(store_.index(store_.current(), 0)); });
}

}  // namespace squat::studio

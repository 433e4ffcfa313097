// widgets/studio/runs/RunsPanel.h - the list of runs: click to see one, tick to overlay it.
#pragma once

#include <QWidget>

class QListView;

namespace squat::studio {

class RunStore;

class RunsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunsPanel(RunStore& store, QWidget* parent = nullptr);
  QListView* list() const { return list_; }

 Q_SIGNALS:
  void openRequested();
  void saveRequested();
  void measuredRequested();
  void removeRequested(int row);

 private:
  RunStore& store_;
  QListView* list_;
  bool ticked_ = false;  // by the mouse button that is down
};

}  // namespace squat::studio

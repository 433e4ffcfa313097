// widgets/studio/comparison/MapWindow.h - two signals as maps over position and frequency, side by side.
#pragma once

#include <QPersistentModelIndex>
#include <QWidget>
#include <array>

#include "plots/MapComparison.h"
#include "studio/runs/RunStore.h"

class QComboBox;
class QPushButton;

namespace squat::studio {

class FigureView;
class FixedLabel;

// Scalogram or short-time transform of a run or measured signal, of another one in the same colours, and their ratio.
// The maps are drawn anew when a choice or one of the two signals changes while the window is seen; of a signal that
// is dragged, when the drag ends.
class MapWindow : public QWidget {
  Q_OBJECT
 public:
  MapWindow(RunStore& store, QWidget* parent);

  void choose(int first, int second);  // rows of the store
  FigureView* view(std::size_t panel) const { return views_.at(panel); }
  // All three as one file; format by its ending: png, svg or pdf. Throws FileError.
  void writeFile(const QString& path) const;

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;  // light and dark

 private:
  // What the maps show; drawn anew only where it differs.
  struct Shown {
    RecordPointer first, second;
    QString firstName, secondName;
    int kind = -1;
    bool dark = false;
    bool operator==(const Shown&) const = default;
  };
  QWidget* makeBar();
  void listSignals();
  void take();  // what the lists have chosen
  void draw();
  void stop(const QString& reason);
  Shown wanted() const;
  QString problem() const;  // why nothing can be drawn; empty: it can
  plots::FigureSheet sheetFor(const plots::Style& style) const;
  void askForFile();
  void say(const QString& problem);

  RunStore& store_;
  QComboBox *first_, *second_, *kind_;
  QPushButton* export_;
  FixedLabel* problem_;
  QPersistentModelIndex firstIndex_, secondIndex_;  // rows move
  Shown shown_;
  std::array<FigureView*, 3> views_{};
};

}  // namespace squat::studio

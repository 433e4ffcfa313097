// widgets/studio/comparison/MapWindow.h - two signals as maps over position and frequency, side by side.
#pragma once

#include <QWidget>
#include <array>

class QComboBox;
class QLabel;

namespace squat::studio {

class FigureView;
class RunStore;

// Scalogram or short-time transform of a run or measured signal, of another one in the same colours, and their ratio.
// The maps are drawn anew when a choice or a signal changes while the window is seen.
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
  QWidget* makeBar();
  void listSignals();
  void draw();
  void askForFile();
  void say(const QString& problem);

  RunStore& store_;
  QComboBox *first_, *second_, *kind_;
  QLabel* problem_;
  std::array<FigureView*, 3> views_{};
};

}  // namespace squat::studio

// widgets/studio/signals/SignalsPanel.h - the signals of the current run, with others overlaid.
#pragma once

#include <QWidget>
#include <map>
#include <optional>

#include "analysis/FigureSettings.h"
#include "plots/FigureRegistry.h"
#include "plots/PrintedSize.h"
#include "studio/runs/RunStore.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;
class QTabWidget;

namespace squat::studio {

class FigureView;
class FixedLabel;

class SignalsPanel : public QWidget {
  Q_OBJECT
 public:
  SignalsPanel(RunStore& store, const plots::Style& style, QWidget* parent = nullptr);

  void setStyle(const plots::Style& style) {
    style_ = style;
    update();
  }
  // The names of plots::figureRegistry() that are plots, a tab each. A figure that the current run has nothing for is
  // greyed; its tool tip says what it needs.
  static QStringList names();
  void showTab(const QString& name);
  QString currentTab() const;
  std::string colourMap() const { return style_.colourMap; }
  FigureView* view(const QString& name) const { return views_.contains(name) ? views_.at(name) : nullptr; }
  FigureView* currentView() const { return view(currentTab()); }
  const analysis::FigureSettings& settings() const { return settings_; }
  // As a project keeps them, with what is enlarged. `run`: the file of the run that they were chosen for, which may
  // still have to be read.
  project::FigureViews views() const;
  void setViews(const project::FigureViews& views, const QString& run);
  // Every figure of the run as it is zoomed, in every format, and the curves as CSV; the 3-D picture as PNG. Returns
  // the files. Throws FileError.
  QStringList exportAll(const QString& folder);          // replaces what stands there
  QStringList exportPaths(const QString& folder) const;  // what it writes
  void askForFolder();
  void toggleCursors();
  void askForSize();  // of copied and exported figures
  // Dragging in the figure of the acceleration along the track shifts what is aligned by hand, not the view.
  void setAligning(bool on);
  void setFigureSize(const plots::PrintedSize& size);
  void setNote(const QString& note);  // on the run that is shown, where nothing is wrong with it

 Q_SIGNALS:
  void failed(const QString& message);
  void tabChanged();
  void choicesChanged();
  void shifted(double metres, bool done);  // while aligning: since the button went down

 private:
  QWidget* makeControls();
  QWidget* makePage(const plots::FigureRow& row, FigureView* view);
  void takeWindow();
  void takeMoments();
  void showMoment();
  void update();
  void rebuild(const QString& name);
  void showProblem();
  bool applies(const plots::FigureRow& row) const;
  void hideWhatDoesNotApply();
  static bool isLinked(const QString& name);  // views along the track are
  void forgetRanges();
  void takeRanges();
  bool exportModel(const QString& path);
  void link(const QString& from, const QCPRange& range);
  void applyLink(const QString& name);

  RunStore& store_;
  plots::Style style_;
  analysis::FigureSettings settings_;
  plots::PrintedSize size_;
  ResultPointer shown_;
  std::weak_ptr<const results::RunResult> momentsOf_;  // whose patches the slider shows
  QString windowOf_;        // file of the run that low-pass, section and zoom were set for: read again, it keeps them
  int waitingMoment_ = -1;  // of that run, until its patches are read
  std::map<QString, project::FigureRange> waitingRanges_;  // of a project, until there is something to see
  QTabWidget* tabs_;
  std::map<QString, FigureView*> views_;
  std::map<QString, bool> stale_;
  std::optional<QCPRange> linked_;  // [mm] what all views along the track show, once the user has zoomed
  QString linkedFrom_;              // in this one
  bool linking_ = false;
  QDoubleSpinBox *cutoff_, *from_, *to_;
  QSpinBox *segment_, *hop_;
  QComboBox *window_, *map_, *spectrum_;
  QSlider* moment_;
  QLabel* momentText_;
  QPushButton* exportAll_;
  QCheckBox* cursors_;
  FixedLabel* problem_;
  QString problemText_, note_;
};

}  // namespace squat::studio

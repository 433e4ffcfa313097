// widgets/studio/SignalsPanel.h - the signals of the current run, with others overlaid.
#pragma once

#include <QWidget>
#include <map>
#include <memory>

#include "plots/Style.h"
#include "studio/RunStore.h"
#include "studio/SignalSettings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QTabWidget;

namespace squat::plots {
class Figure;
}

namespace squat::studio {

class FigureView;

class SignalsPanel : public QWidget {
  Q_OBJECT
 public:
  SignalsPanel(RunStore& store, const plots::Style& style, QWidget* parent = nullptr);

  void setStyle(const plots::Style& style);
  // "aba", "psd", "stft", "scalogram", "contact_force", "defect_profile"
  void showTab(const QString& name);
  FigureView* view(const QString& name) const;
  QStringList names() const;
  const SignalSettings& settings() const { return settings_; }
  // Every figure as seen, in every format, and the curves as CSV. Returns the files. Throws FileError.
  QStringList exportAll(const QString& folder);

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  QWidget* makeControls();
  void takeWindow();
  void update();
  void rebuild(const QString& name);
  std::unique_ptr<plots::Figure> makeFigure(const QString& name) const;
  void overlay(plots::Figure& figure, const QString& name) const;
  void askForFolder();

  RunStore& store_;
  plots::Style style_;
  SignalSettings settings_;
  ResultPointer shown_;
  QTabWidget* tabs_;
  std::map<QString, FigureView*> views_;
  std::map<QString, bool> stale_;
  QDoubleSpinBox *cutoff_, *from_, *to_;
  QComboBox *axis_, *window_, *map_;
  QLabel* problem_;
};

}  // namespace squat::studio

// widgets/studio/preview/PreviewPanel.h - the preview as the user sees it: acceleration, spectrum and scalogram, with
// the last whole run in grey.
#pragma once

#include <QWidget>

#include "plots/Figure.h"
#include "studio/preview/Preview.h"

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QStackedWidget;
class QVBoxLayout;

namespace squat::studio {

class CurvePlot;
class PreviewController;
class RunStore;

class PreviewPanel : public QWidget {
  Q_OBJECT
 public:
  PreviewPanel(PreviewController& controller, RunStore& store, const plots::Style& style, QWidget* parent = nullptr);

  void setStyle(const plots::Style& style);
  CurvePlot* acceleration() const { return acceleration_; }
  CurvePlot* spectrum() const { return spectrum_; }
  plots::Figure* scalogram() const { return scalogram_; }
  QCheckBox* onOff() const { return onOff_; }

 private:
  QWidget* makeHead();
  void makeFigures();
  void showPreview();
  void showState();
  void showResult(const results::RunResult& result);
  void showReference();
  void compareSpectra();

  PreviewController& controller_;
  RunStore& store_;
  plots::Style style_;
  QLabel *title_ = nullptr, *state_ = nullptr, *why_ = nullptr;
  QCheckBox* onOff_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QStackedWidget* pages_ = nullptr;  // the figures, or why there are none
  QWidget* figures_ = nullptr;
  QVBoxLayout* rows_ = nullptr;   // acceleration, below it
  QHBoxLayout* lower_ = nullptr;  // spectrum and scalogram
  CurvePlot *acceleration_ = nullptr, *spectrum_ = nullptr;
  plots::Figure* scalogram_ = nullptr;
  ResultPointer shown_;  // whose spectrum and scalogram are seen
};

}  // namespace squat::studio

#include "studio/preview/PreviewPanel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "plots/FigureRegistry.h"
#include "plots/LineFigure.h"
#include "signals/Features.h"
#include "signals/SignalCatalogue.h"
#include "signals/SignalError.h"
#include "studio/preview/CurvePlot.h"
#include "studio/preview/PreviewController.h"
#include "studio/runs/RunStore.h"

namespace squat::studio {
namespace {

constexpr double shownUpTo = 2500;  // [Hz], as the spectrum of a run
constexpr int fewTicks = 3;

std::unique_ptr<plots::Figure> scalogramOf(const results::RunResult& result, const plots::Style& style) {
  auto figure = plots::buildFigure(plots::figureRow("scalogram"), result, style);
  figure->setCaption({}, {});
  if (plots::holdsNothing(*figure))
    plots::showEmpty(*figure, PreviewPanel::tr("Change the profile:\nits preview is\ndrawn here"));
  // Half as wide as elsewhere: the words go into the tool tip, and fewer numbers fit.
  if (auto* scale = figure->findChild<QCPColorScale*>()) scale->axis()->setLabel({});
  figure->setToolTip(PreviewPanel::tr("Wavelet power [(m/s²)² s] of the preview"));
  figure->xAxis->ticker()->setTickCount(fewTicks);
  figure->xAxis->setLabel(PreviewPanel::tr("Position [mm]"));
  figure->setMinimumSize(150, 120);
  figure->setAccessibleName(PreviewPanel::tr("Scalogram of the preview"));
  return figure;
}

QString rangeText(const std::vector<double>& acceleration) {
  const auto [low, high] = std::minmax_element(acceleration.begin(), acceleration.end());
  return PreviewPanel::tr("%1 … %2 m/s²").arg(*low, 0, 'f', 0).arg(*high, 0, 'f', 0);
}

}  // namespace

PreviewPanel::PreviewPanel(PreviewController& controller, RunStore& store, const plots::Style& style, QWidget* parent)
    : QWidget(parent), controller_(controller), store_(store), style_(style) {
  figures_ = new QWidget(this);
  rows_ = new QVBoxLayout(figures_);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(2);
  lower_ = new QHBoxLayout;
  lower_->setSpacing(2);
  why_ = new QLabel(this);
  why_->setObjectName("previewReason");
  why_->setWordWrap(true);
  why_->setAlignment(Qt::AlignCenter);
  why_->setMargin(20);
  pages_ = new QStackedWidget(this);
  pages_->addWidget(figures_);
  pages_->addWidget(why_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->setSpacing(2);
  layout->addWidget(makeHead());
  layout->addWidget(pages_, 1);
  rows_->addLayout(lower_, 1);
  makeFigures();
  connect(&controller_, &PreviewController::changed, this, &PreviewPanel::showPreview);
  connect(&controller_, &PreviewController::stateChanged, this, &PreviewPanel::showState);
  connect(onOff_, &QCheckBox::toggled, &controller_, &PreviewController::setOn);
  connect(&store_, &RunStore::currentChanged, this, &PreviewPanel::showReference);
  showState();
}

QWidget* PreviewPanel::makeHead() {
  auto* head = new QWidget(this);
  title_ = new QLabel(tr("Preview, mesh tiny"), head);
  title_->setObjectName("previewTitle");
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  title_->setToolTip(tr("Rolled anew on a coarse mesh after every change of the profile; F5 runs the case itself"));
  state_ = new QLabel(head);
  state_->setObjectName("previewState");
  state_->setForegroundRole(QPalette::PlaceholderText);
  progress_ = new QProgressBar(head);
  progress_->setObjectName("previewProgress");
  progress_->setRange(0, 1000);
  progress_->setFixedWidth(130);
  progress_->setAccessibleName(tr("Progress of the preparation"));
  onOff_ = new QCheckBox(tr("Live"), head);
  onOff_->setObjectName("previewOn");
  onOff_->setToolTip(tr("Preview every change of the profile (F7)"));
  onOff_->setAccessibleName(tr("Live preview"));
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(2, 0, 2, 0);
  row->addWidget(title_);
  row->addSpacing(8);
  row->addWidget(state_, 1);
  row->addWidget(progress_);
  row->addWidget(onOff_);
  return head;
}

void PreviewPanel::makeFigures() {
  delete acceleration_;
  delete spectrum_;
  delete scalogram_;
  acceleration_ =
      new CurvePlot("preview_aba", tr("Wheel position relative to the defect [mm]"), tr("ABA [m/s²]"), style_);
  acceleration_->setRange(-100, 100);
  spectrum_ = new CurvePlot("preview_psd", tr("Frequency [Hz]"), tr("PSD [(m/s²)²/Hz]"), style_);
  spectrum_->setRange(0, shownUpTo);
  spectrum_->xAxis->ticker()->setTickCount(fewTicks);
  scalogram_ = scalogramOf(shown_ ? *shown_ : results::RunResult(), style_).release();
  rows_->insertWidget(0, acceleration_, 1);
  lower_->addWidget(spectrum_, 1);
  lower_->addWidget(scalogram_, 1);
  showReference();
  showPreview();
}

void PreviewPanel::setStyle(const plots::Style& style) {
  style_ = style;
  shown_.reset();
  makeFigures();
}

void PreviewPanel::showPreview() {
  const Preview& preview = controller_.latest();
  if (!preview.position.empty()) {
    acceleration_->setRange(1e3 * preview.from, 1e3 * preview.to);
    acceleration_->setBand(1e3 * preview.defectFrom, 1e3 * preview.defectTo);
    acceleration_->setCurve(plots::scaled(preview.position, 1e3), preview.acceleration,
                            preview.phase == PreviewPhase::done);
  }
  if (preview.result && preview.result != shown_) {
    shown_ = preview.result;
    showResult(*shown_);
  }
  showState();
}

// Old curves stay to be compared with, but as what they are.
void PreviewPanel::showState() {
  const Preview& preview = controller_.latest();
  const bool preparing = controller_.isOn() && preview.phase == PreviewPhase::preparing;
  const bool refused = controller_.isOn() && preview.phase == PreviewPhase::unavailable;
  onOff_->setChecked(controller_.isOn());
  progress_->setVisible(preparing && !controller_.isHeld());
  progress_->setValue(static_cast<int>(1000 * preview.fraction));
  progress_->setFormat(QString::fromStdString(preview.text));
  QString text;
  if (!controller_.isOn())
    text = tr("off");
  else if (controller_.isHeld())
    text = tr("waits for the run");
  else if (preparing && acceleration_->pointCount() > 0)
    text = tr("out of date");
  else if (preview.phase == PreviewPhase::done && !preview.acceleration.empty())
    text = rangeText(preview.acceleration);
  state_->setText(text);
  if (refused) why_->setText(QString::fromStdString(preview.text));
  pages_->setCurrentWidget(refused ? static_cast<QWidget*>(why_) : figures_);
  const bool stale = preparing || controller_.isHeld() || !controller_.isOn();
  acceleration_->setStale(stale);
  spectrum_->setStale(stale || preview.phase == PreviewPhase::rolling);
}

void PreviewPanel::showResult(const results::RunResult& result) {
  spectrum_->setCurve(result.frequency, result.psd, true);
  auto* map = scalogramOf(result, style_).release();
  delete lower_->replaceWidget(scalogram_, map);
  delete scalogram_;
  scalogram_ = map;
  compareSpectra();
}

void PreviewPanel::showReference() {
  const ResultPointer last = store_.currentResult();
  const auto* filtered = last ? last->signal(signals::names::axleBoxFiltered) : nullptr;
  if (!filtered || last->position.size() != filtered->size())
    acceleration_->setReference({}, {}, {});
  else
    acceleration_->setReference(plots::scaled(last->position, 1e3), *filtered, store_.at(store_.current()).label);
  compareSpectra();
}

// Over the same stretch: the density of an impact depends on how much of what is still around it is taken in.
void PreviewPanel::compareSpectra() {
  const ResultPointer last = store_.currentResult();
  if (!last || !shown_ || !last->signal(signals::names::axleBoxFiltered)) return spectrum_->setReference({}, {}, {});
  try {
    const auto spectrum = signals::stretchSpectrum(signals::passageOf(*last, signals::names::axleBoxFiltered),
                                                   shown_->psdFrom, shown_->psdTo);
    spectrum_->setReference(spectrum.frequency, spectrum.density, {});
  } catch (const signals::SignalError&) {  // its record does not reach so far
    spectrum_->setReference({}, {}, {});
  }
}

}  // namespace squat::studio

#include "studio/signals/SignalsPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "analysis/SignalViews.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "colours/ColourTables.h"
#include "core/Errors.h"
#include "plots/FigureBuilders.h"
#include "plots/FigureRegistry.h"
#include "plots/Figures.h"
#include "plots/Overlays.h"
#include "plots/ShownStretch.h"
#include "scene/ModelPicture.h"
#include "studio/common/EditorHabits.h"
#include "studio/common/FigureSizeDialog.h"
#include "studio/common/FixedLabel.h"
#include "studio/common/FlowLayout.h"
#include "studio/common/NarrowTabs.h"
#include "studio/common/NumberBox.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalFigures.h"

namespace squat::studio {
namespace {

// The figures that have a tab here; the 3-D picture has one of its own in the window.
std::vector<const plots::FigureRow*> tabRows() {
  std::vector<const plots::FigureRow*> rows;
  for (const auto& row : plots::figureRegistry())
    if (row.kind == plots::FigureKind::plot) rows.push_back(&row);
  return rows;
}

const plots::FigureRow& rowOf(const QString& name) { return plots::figureRow(name.toStdString()); }

QString nameOf(const plots::FigureRow& row) { return QString::fromStdString(row.name); }

QString unitOf(const QString& name) { return QString::fromStdString(plots::unitOf(rowOf(name).axis)); }

// Views along the track zoom together, whatever their unit: the speed links time and position.
bool isInMilliseconds(const QString& name) { return rowOf(name).axis == plots::FigureAxis::time; }

constexpr const char* alongTrack = "aba_position";  // where signals are aligned by hand; its axis is in mm

ResultPointer noRun(const QString& title) {
  auto none = std::make_shared<results::RunResult>();
  none->title = title.toStdString();
  none->complete = true;
  return none;
}

}  // namespace

bool SignalsPanel::isLinked(const QString& name) {
  return rowOf(name).axis == plots::FigureAxis::wheelPosition || isInMilliseconds(name);
}

SignalsPanel::SignalsPanel(RunStore& store, const plots::Style& style, QWidget* parent)
    : QWidget(parent), store_(store), style_(style) {
  settings_.section = {-plots::shownBefore, plots::shownAfter};
  settings_.hop = settings_.segment / 32;
  tabs_ = new QTabWidget(this);
  tabs_->setDocumentMode(true);
  tabs_->setAccessibleName(tr("Signal figures"));
  makeNarrow(*tabs_->tabBar());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 2, 2, 2);
  layout->setSpacing(2);
  layout->addWidget(makeControls());
  layout->addWidget(tabs_, 1);
  for (const auto* row : tabRows()) {
    const QString name = nameOf(*row);
    auto* view = new FigureView(name, tabs_);
    views_[name] = view;
    tabs_->addTab(makePage(*row, view), QString::fromStdString(row->tab));
    connect(view, &FigureView::failed, this, &SignalsPanel::failed);
    connect(view, &FigureView::cursorsToggled, cursors_, &QCheckBox::setChecked);
    connect(view, &FigureView::shifted, this,
            [this](double millimetres, bool done) { Q_EMIT shifted(millimetres * 1e-3, done); });
    connect(view, &FigureView::zoomed, this, [this] {
      if (!linking_) Q_EMIT choicesChanged();
    });
    if (!isLinked(name)) continue;
    connect(view, &FigureView::rangeChanged, this, [this, name](const QCPRange& range) { link(name, range); });
  }
  takeMoments();
  setFigureSize(storedFigureSize());
  const int all = tabs_->tabBar()->sizeHint().width();
  hideWhatDoesNotApply();
  const QMargins around = layout->contentsMargins();  // no tab behind an arrow, few or all
  setMinimumWidth(std::max(all, tabs_->tabBar()->sizeHint().width()) + around.left() + around.right());
  letWheelPass(*this);
  connect(tabs_, &QTabWidget::currentChanged, this, [this] {
    rebuild(currentTab());
    Q_EMIT tabChanged();
  });
  connect(&store_, &RunStore::currentChanged, this, [this] {
    takeWindow();
    takeMoments();
    update();
  });
  connect(&store_, &RunStore::overlaysChanged, this, &SignalsPanel::update);
  connect(&store_, &RunStore::namesChanged, this, [this] {
    if (!store_.overlays().empty()) update();  // legends name them
  });
  update();
}

namespace {

QDoubleSpinBox* number(const QString& label, const QString& unit, double low, double high, double value) {
  auto* box = new NumberBox;
  box->setRange(low, high);
  box->setDecimals(0);
  box->setValue(value);
  box->setSuffix(" " + unit);
  box->setKeyboardTracking(false);
  box->setAccessibleName(label);
  box->setToolTip(label);
  return box;
}

QSpinBox* samples(const QString& label, std::size_t value, int maximum) {
  auto* box = new QSpinBox;
  box->setRange(1, maximum);
  box->setValue(static_cast<int>(value));
  box->setSuffix(QObject::tr(" samples"));
  box->setKeyboardTracking(false);
  box->setAccessibleName(label);
  box->setToolTip(label);
  return box;
}

QComboBox* choice(const QString& label, const QStringList& entries) {
  auto* box = new QComboBox;
  box->addItems(entries);
  box->setAccessibleName(label);
  box->setToolTip(label);
  return box;
}

}  // namespace

// What holds for every figure.
QWidget* SignalsPanel::makeControls() {
  auto* bar = new QWidget(this);
  auto* rows = new QVBoxLayout(bar);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(2);
  auto* flow = new FlowLayout;
  rows->addLayout(flow);
  cutoff_ = number(tr("Cut-off frequency of the low-pass filter"), "Hz", 20, 12000, settings_.cutoff);
  cutoff_->setSingleStep(100);
  cutoff_->setObjectName("cutoff");
  connect(cutoff_, &QDoubleSpinBox::valueChanged, this, &SignalsPanel::update);
  flow->addTogether({new QLabel(tr("Low-pass")), cutoff_});
  QStringList maps;
  for (const auto& name : colours::mapNames()) maps << QString::fromStdString(name);
  map_ = choice(tr("Colour map"), maps);
  connect(map_, &QComboBox::currentIndexChanged, this, &SignalsPanel::update);
  flow->addTogether({new QLabel(tr("Colours")), map_});
  cursors_ = new QCheckBox(tr("Cursors"));
  cursors_->setObjectName("cursors");
  cursors_->setToolTip(tr("Two draggable lines; the figure shows their difference and 1/Δt"));
  connect(cursors_, &QCheckBox::toggled, this, [this](bool on) {
    for (const auto& [name, view] : views_) view->setCursors(on);
  });
  flow->addWidget(cursors_);
  exportAll_ = new QPushButton(tr("Export all…"));
  exportAll_->setObjectName("exportAllButton");
  exportAll_->setToolTip(tr("Export every figure as shown: PNG, SVG, PDF and CSV"));
  connect(exportAll_, &QPushButton::clicked, this, &SignalsPanel::askForFolder);
  flow->addWidget(exportAll_);
  problem_ = new FixedLabel(1, bar);
  problem_->setObjectName("signalProblem");
  rows->addWidget(problem_);
  return bar;
}

// What applies to one figure stands above it: its window or section.
QWidget* SignalsPanel::makePage(const plots::FigureRow& row, FigureView* view) {
  const plots::FigureControl control = row.control;
  auto* page = new QWidget(tabs_);
  auto* rows = new QVBoxLayout(page);
  rows->setContentsMargins(0, 4, 0, 0);
  rows->setSpacing(2);
  auto* flow = new FlowLayout;
  if (control == plots::FigureControl::spectrumSection) {
    window_ = choice(tr("Window function of the spectrum"), {"hann", "hamming", "blackman", "boxcar"});
    connect(window_, &QComboBox::currentIndexChanged, this, &SignalsPanel::update);
    flow->addTogether({new QLabel(tr("Window")), window_});
    from_ = number(tr("Start of the section that the spectrum is computed from"), "mm", -5000, 5000,
                   settings_.section->from * 1e3);
    to_ = number(tr("End of the section that the spectrum is computed from"), "mm", -5000, 5000,
                 settings_.section->to * 1e3);
    from_->setObjectName("psdFrom");
    to_->setObjectName("psdTo");
    for (QDoubleSpinBox* box : {from_, to_}) connect(box, &QDoubleSpinBox::valueChanged, this, &SignalsPanel::update);
    flow->addTogether({new QLabel(tr("from")), from_});
    flow->addTogether({new QLabel(tr("to")), to_});
    spectrum_ = choice(tr("Scale of the spectrum"), {tr("linear"), tr("logarithmic"), tr("dB"), tr("1/3 octaves")});
    spectrum_->setObjectName("spectrumScale");
    connect(spectrum_, &QComboBox::currentIndexChanged, this, &SignalsPanel::update);
    flow->addTogether({new QLabel(tr("Scale")), spectrum_});
  } else if (control == plots::FigureControl::shortTime) {
    segment_ = samples(tr("Window length of the short-time Fourier transform"), settings_.segment, 8192);
    segment_->setMinimum(16);
    segment_->setSingleStep(16);
    segment_->setObjectName("stftSegment");
    hop_ = samples(tr("Hop of the short-time Fourier transform: from one window to the next"), settings_.hop, 1024);
    hop_->setObjectName("stftHop");
    for (QSpinBox* box : {segment_, hop_}) connect(box, &QSpinBox::valueChanged, this, &SignalsPanel::update);
    flow->addTogether({new QLabel(tr("Window")), segment_});
    flow->addTogether({new QLabel(tr("Hop")), hop_});
  } else if (control == plots::FigureControl::moment) {
    moment_ = new QSlider(Qt::Horizontal);
    moment_->setAccessibleName(tr("Moment of the contact patch"));
    moment_->setToolTip(tr("Moment of the contact patch; axes and colours stay the same"));
    moment_->setObjectName("patchMoment");
    moment_->setMinimumWidth(160);
    momentText_ = new QLabel;
    momentText_->setObjectName("patchMomentText");
    connect(moment_, &QSlider::valueChanged, this, [this, name = nameOf(row)](int index) {
      settings_.moment = index;
      showMoment();
      stale_[name] = true;
      rebuild(currentTab());
      Q_EMIT choicesChanged();
    });
    flow->addTogether({new QLabel(tr("Moment")), moment_});
    flow->addWidget(momentText_);
  }
  if (flow->count() > 0)
    rows->addLayout(flow);
  else
    delete flow;
  rows->addWidget(view, 1);
  return page;
}

QStringList SignalsPanel::names() {
  QStringList list;
  for (const auto* row : tabRows()) list << nameOf(*row);
  return list;
}

void SignalsPanel::showTab(const QString& name) {
  const int index = static_cast<int>(names().indexOf(name));
  if (index >= 0) tabs_->setCurrentIndex(index);
}

// A new run is first seen whole, through the low-pass of its case and the section that its own spectrum has.
void SignalsPanel::takeWindow() {
  const ResultPointer current = store_.currentResult();
  const int row = std::max(store_.current(), store_.waitingCurrent());
  const QString file = row < 0 ? QString() : store_.at(row).file();
  if (!file.isEmpty() && file == windowOf_) return;
  forgetRanges();
  waitingMoment_ = -1;
  windowOf_ = current ? file : QString();
  if (current && current->resolvedCase) {  // one whose case cannot be read is seen as it was last chosen
    const QSignalBlocker quiet(cutoff_);
    cutoff_->setValue(current->resolvedCase->scenario.output.filterCutoff);
  }
  if (!current || !(current->psdTo > current->psdFrom)) return;
  const QSignalBlocker quietFrom(from_), quietTo(to_);
  from_->setValue(current->psdFrom * 1e3);
  to_->setValue(current->psdTo * 1e3);
}

// The patch of a new run is first seen at the impact, as in its file.
void SignalsPanel::takeMoments() {
  const ResultPointer current = store_.currentResult();
  if (current && current == momentsOf_.lock()) return;  // another run has gone
  momentsOf_ = current;
  const int count = current ? static_cast<int>(current->patches.size()) : 0;
  const auto* impact = current ? plots::shownPatch(*current) : nullptr;
  const QSignalBlocker quiet(moment_);
  moment_->setRange(0, std::max(count - 1, 0));
  const int usual = impact ? static_cast<int>(impact - current->patches.data()) : 0;
  moment_->setValue(waitingMoment_ >= 0 ? waitingMoment_ : usual);
  if (count > 0) waitingMoment_ = -1;
  moment_->setEnabled(count > 1);
  settings_.moment = count > 1 ? moment_->value() : -1;  // one scale for all moments, where there are several
  showMoment();
}

void SignalsPanel::showMoment() {
  const ResultPointer current = store_.currentResult();
  const auto index = static_cast<std::size_t>(moment_->value());
  if (!current || index >= current->patches.size()) return momentText_->clear();
  const auto& patch = current->patches[index];
  momentText_->setText(tr("%1: %2 mm, %3 ms")
                           .arg(QString::fromStdString(patch.name))
                           .arg(patch.position * 1e3, 0, 'f', 1)
                           .arg(patch.time * 1e3, 0, 'f', 2));
}

void SignalsPanel::update() {
  settings_.segment = static_cast<std::size_t>(segment_->value());
  settings_.hop = static_cast<std::size_t>(hop_->value());
  settings_.cutoff = cutoff_->value();
  settings_.window = window_->currentText().toStdString();
  settings_.spectrum = static_cast<analysis::SpectrumScale>(spectrum_->currentIndex());
  settings_.section = {from_->value() * 1e-3, to_->value() * 1e-3};
  style_.colourMap = settings_.colours = map_->currentText().toStdString();
  const ResultPointer current = store_.currentResult();
  std::string problem;
  shown_ = current ? analysis::resultThrough(settings_, *current, problem)
                   : noRun(tr("No results yet: press F5 to run, or open a result"));
  problemText_ = QString::fromStdString(problem);
  showProblem();
  exportAll_->setEnabled(current || !store_.overlays().empty());
  // Only what is seen is drawn now; the rest when its tab is opened.
  for (const auto& name : names()) stale_[name] = true;
  hideWhatDoesNotApply();
  rebuild(currentTab());
  takeRanges();
  Q_EMIT choicesChanged();
}

void SignalsPanel::setNote(const QString& note) {
  note_ = note;
  showProblem();
}

void SignalsPanel::showProblem() { problemText_.isEmpty() ? problem_->say(note_) : problem_->warn(problemText_); }

// Without a run there is nothing to judge by: every tab that any run fills says how to get one.
bool SignalsPanel::applies(const plots::FigureRow& row) const {
  return store_.currentResult() ? row.applies(*store_.currentResult()) : !row.expected;
}

void SignalsPanel::hideWhatDoesNotApply() {
  int index = 0;
  for (const auto* row : tabRows()) {
    const bool seen = applies(*row);
    tabs_->setTabVisible(index, seen);
    tabs_->setTabEnabled(index, seen);
    const std::string& more = seen ? row->shows : row->needs;
    tabs_->setTabToolTip(index++, QString::fromStdString(more.empty() ? row->title : row->title + ".\n" + more));
  }
}

void SignalsPanel::rebuild(const QString& name) {
  if (!stale_[name] || !shown_) return;
  stale_[name] = false;
  const plots::FigureRow& row = rowOf(name);
  const QString unit = unitOf(name);
  const double secondsPerMillimetre = shown_->speed > 0 ? 1e-3 / shown_->speed : 0;
  const double secondsPerUnit = !isLinked(name) ? 0 : unit == "ms" ? 1e-3 : secondsPerMillimetre;
  linking_ = true;
  try {
    auto figure = signalFigure(row.name, *shown_, store_.overlays(), settings_, style_);
    const bool isComing = store_.waitingCurrent() >= 0;
    if (!store_.currentResult()) showNextStep(*figure, !store_.overlays().empty(), isComing);
    views_[name]->show(std::move(figure), secondsPerUnit, unit,
                       row.table ? row.table(*shown_, settings_) : QByteArray());
  } catch (const std::exception& error) {  // a signal that cannot be analysed costs its figure, not the session
    problemText_ = QString::fromStdString(error.what());
    showProblem();
    views_[name]->show(signalFigure(row.name, *noRun(tr("This figure cannot be drawn")), {}, settings_, style_),
                       secondsPerUnit, unit, {});
  }
  linking_ = false;
  applyLink(name);
}

void SignalsPanel::setAligning(bool on) {
  views_.at(alongTrack)->setShifting(on);
  if (on) showTab(alongTrack);
}

void SignalsPanel::link(const QString& from, const QCPRange& range) {
  if (linking_ || !shown_ || !(shown_->speed > 0)) return;
  const double passage = 1e3 * plots::passageTime(*shown_);
  linkedFrom_ = from;
  linked_ = isInMilliseconds(from)
                ? QCPRange((range.lower - passage) * shown_->speed, (range.upper - passage) * shown_->speed)
                : range;
  for (const auto& [name, view] : views_)
    if (name != from) applyLink(name);
}

void SignalsPanel::applyLink(const QString& name) {
  if (!linked_ || !isLinked(name) || stale_[name]) return;
  const double passage = 1e3 * plots::passageTime(*shown_);
  const bool already = linking_;
  linking_ = true;
  views_[name]->setRange(isInMilliseconds(name) ? QCPRange(passage + linked_->lower / shown_->speed,
                                                           passage + linked_->upper / shown_->speed)
                                                : *linked_);
  linking_ = already;
}

QString SignalsPanel::currentTab() const { return names().value(tabs_->currentIndex()); }

void SignalsPanel::toggleCursors() { cursors_->toggle(); }

void SignalsPanel::setFigureSize(const plots::PrintedSize& size) {
  size_ = size;
  for (const auto& [name, view] : views_) view->setPrintedSize(size);
}

void SignalsPanel::askForSize() {
  auto* dialog = new FigureSizeDialog(size_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    setFigureSize(dialog->size());
    storeFigureSize(dialog->size());
  });
  dialog->open();
}

void SignalsPanel::askForFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Export figures to folder"));
  if (folder.isEmpty()) return;
  const QStringList paths = exportPaths(folder);
  const auto standing =
      std::count_if(paths.begin(), paths.end(), [](const QString& path) { return QFile::exists(path); });
  if (standing > 0 &&
      QMessageBox::question(
          this, tr("Export all"),
          tr("%1 already contains %n of these files. Replace them?", nullptr, static_cast<int>(standing)).arg(folder),
          QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel) != QMessageBox::Yes)
    return;
  try {
    exportAll(folder);
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
  }
}

QStringList SignalsPanel::exportPaths(const QString& folder) const {
  QStringList paths;
  const QDir into(folder);
  for (const auto& row : plots::figureRegistry()) {
    if (!applies(row)) continue;
    if (row.kind == plots::FigureKind::plot)
      for (const char* ending : {"png", "svg", "pdf", "csv"}) paths << into.filePath(nameOf(row) + "." + ending);
    else if (store_.currentResult())
      paths << into.filePath(nameOf(row) + ".png");
  }
  return paths;
}

QStringList SignalsPanel::exportAll(const QString& folder) {
  QStringList paths = exportPaths(folder);
  paths.removeIf([this](const QString& path) {
    const QString name = QFileInfo(path).completeBaseName();
    if (views_.find(name) == views_.end()) return !exportModel(path);
    rebuild(name);
    views_[name]->writeFile(path);
    return false;
  });
  return paths;
}

// False where this machine cannot draw it, which is said.
bool SignalsPanel::exportModel(const QString& path) {
  const auto outcome =
      scene::writeModelPicture(*store_.currentResult(), style_.colourMap, path.toStdString(), plots::modelSize(size_));
  if (!outcome.written) Q_EMIT failed(tr("3-D picture not drawn: %1").arg(QString::fromStdString(outcome.reason)));
  return outcome.written;
}

}  // namespace squat::studio

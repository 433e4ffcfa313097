#include "studio/SignalsPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QVBoxLayout>

#include "colours/ColourTables.h"
#include "core/Errors.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "studio/FigureView.h"

namespace squat::studio {
namespace {

const QList<QPair<QString, QString>>& tabTitles() {
  static const QList<QPair<QString, QString>> titles{{"aba", QObject::tr("ABA")},
                                                     {"psd", QObject::tr("PSD")},
                                                     {"stft", QObject::tr("STFT")},
                                                     {"scalogram", QObject::tr("Scalogram")},
                                                     {"contact_force", QObject::tr("Force")},
                                                     {"contact_patch", QObject::tr("Patch")},
                                                     {"defect_profile", QObject::tr("Defect")}};
  return titles;
}

ResultPointer noRun() {
  auto none = std::make_shared<results::RunResult>();
  none->title = QObject::tr("No run yet: press F5, or open a result").toStdString();
  none->complete = true;
  return none;
}

}  // namespace

SignalsPanel::SignalsPanel(RunStore& store, const plots::Style& style, QWidget* parent)
    : QWidget(parent), store_(store), style_(style) {
  tabs_ = new QTabWidget(this);
  tabs_->setDocumentMode(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 2);
  layout->setSpacing(2);
  layout->addWidget(makeControls());
  layout->addWidget(tabs_, 1);
  for (const auto& [name, title] : tabTitles()) {
    auto* view = new FigureView(name, tabs_);
    views_[name] = view;
    tabs_->addTab(view, title);
    connect(view, &FigureView::failed, this, &SignalsPanel::failed);
    if (name != "aba" && name != "contact_force") continue;
    // Views against position (or time) move together.
    const QString other = name == "aba" ? "contact_force" : "aba";
    connect(view, &FigureView::rangeChanged, this, [this, other](const QCPRange& range) {
      if (!settings_.againstTime) views_[other]->setRange(range);
    });
  }
  connect(tabs_, &QTabWidget::currentChanged, this,
          [this] { rebuild(tabTitles().value(tabs_->currentIndex()).first); });
  connect(&store_, &RunStore::currentChanged, this, [this] {
    takeWindow();
    update();
  });
  connect(&store_, &RunStore::overlaysChanged, this, &SignalsPanel::update);
  update();
}

QWidget* SignalsPanel::makeControls() {
  auto* bar = new QWidget(this);
  auto* rows = new QVBoxLayout(bar);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(2);
  auto* layout = new QHBoxLayout;
  auto* second = new QHBoxLayout;
  rows->addLayout(layout);
  rows->addLayout(second);
  const auto number = [&](QHBoxLayout* row, const QString& label, const QString& unit, double low, double high,
                          double value) {
    auto* box = new QDoubleSpinBox(bar);
    box->setRange(low, high);
    box->setDecimals(0);
    box->setValue(value);
    box->setSuffix(" " + unit);
    box->setKeyboardTracking(false);
    box->setAccessibleName(label);
    box->setToolTip(label);
    row->addWidget(box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &SignalsPanel::update);
    return box;
  };
  const auto choice = [&](QHBoxLayout* row, const QString& label, const QStringList& entries) {
    auto* box = new QComboBox(bar);
    box->addItems(entries);
    box->setAccessibleName(label);
    box->setToolTip(label);
    row->addWidget(box);
    return box;
  };
  axis_ = choice(layout, tr("Axis of the ABA"), {tr("against position"), tr("against time")});
  axis_->setObjectName("abaAxis");
  connect(axis_, &QComboBox::currentIndexChanged, this, &SignalsPanel::update);
  layout->addWidget(new QLabel(tr("Low-pass"), bar));
  cutoff_ = number(layout, tr("Cut-off of the low-pass"), "Hz", 20, 12000, settings_.cutoff);
  cutoff_->setSingleStep(100);
  cutoff_->setObjectName("cutoff");
  second->addWidget(new QLabel(tr("Spectrum"), bar));
  window_ = choice(second, tr("Window of the spectrum"), {"hann", "hamming", "blackman", "boxcar"});
  connect(window_, &QComboBox::currentIndexChanged, this, &SignalsPanel::update);
  from_ = number(second, tr("Stretch of the spectrum, from"), "mm", -5000, 5000, settings_.from * 1e3);
  to_ = number(second, tr("Stretch of the spectrum, to"), "mm", -5000, 5000, settings_.to * 1e3);
  QStringList maps;
  for (const auto& name : colours::mapNames()) maps << QString::fromStdString(name);
  map_ = choice(layout, tr("Colour map"), maps);
  connect(map_, &QComboBox::currentIndexChanged, this, &SignalsPanel::update);
  auto* cursors = new QCheckBox(tr("Cursors"), bar);
  cursors->setObjectName("cursors");
  connect(cursors, &QCheckBox::toggled, this, [this](bool on) {
    for (const auto& [name, view] : views_) view->setCursors(on);
  });
  layout->addWidget(cursors);
  layout->addStretch();
  auto* all = new QPushButton(tr("Export all…"), bar);
  all->setToolTip(tr("Every figure as seen, as PNG, SVG, PDF and CSV"));
  connect(all, &QPushButton::clicked, this, &SignalsPanel::askForFolder);
  second->addStretch();
  second->addWidget(all);
  problem_ = new QLabel(bar);
  problem_->setStyleSheet("color: #c0392b;");
  problem_->setWordWrap(true);
  rows->addWidget(problem_);
  problem_->hide();
  return bar;
}

void SignalsPanel::setStyle(const plots::Style& style) {
  style_ = style;
  update();
}

FigureView* SignalsPanel::view(const QString& name) const {
  const auto found = views_.find(name);
  return found == views_.end() ? nullptr : found->second;
}

QStringList SignalsPanel::names() const {
  QStringList list;
  for (const auto& [name, title] : tabTitles()) list << name;
  return list;
}

void SignalsPanel::showTab(const QString& name) {
  const int index = static_cast<int>(names().indexOf(name));
  if (index >= 0) tabs_->setCurrentIndex(index);
}

// A new run is first seen through the window that its own spectrum has.
void SignalsPanel::takeWindow() {
  const ResultPointer current = store_.currentResult();
  if (!current || !(current->psdTo > current->psdFrom)) return;
  const QSignalBlocker quietFrom(from_), quietTo(to_);
  from_->setValue(current->psdFrom * 1e3);
  to_->setValue(current->psdTo * 1e3);
}

void SignalsPanel::update() {
  settings_.againstTime = axis_->currentIndex() == 1;
  settings_.cutoff = cutoff_->value();
  settings_.window = window_->currentText().toStdString();
  settings_.from = from_->value() * 1e-3;
  settings_.to = to_->value() * 1e-3;
  style_.colourMap = map_->currentText().toStdString();
  const ResultPointer current = store_.currentResult();
  std::string problem;
  shown_ = current ? analysed(*current, settings_, problem) : noRun();
  problem_->setText(QString::fromStdString(problem));
  problem_->setVisible(!problem.empty());
  // Only what is seen is drawn now; the rest when its tab is opened.
  for (const auto& name : names()) stale_[name] = true;
  rebuild(tabTitles().value(tabs_->currentIndex()).first);
}

void SignalsPanel::rebuild(const QString& name) {
  if (!stale_[name] || !shown_) return;
  stale_[name] = false;
  const bool noTime = name == "psd" || name == "defect_profile" || name == "contact_patch";
  const bool inMillimetres = name != "psd" && !(name == "aba" && settings_.againstTime);
  const double speed = shown_->speed > 0 ? shown_->speed : 0;
  const double secondsPerMillimetre = speed > 0 ? 1e-3 / speed : 0;
  const double secondsPerUnit = noTime ? 0 : inMillimetres ? secondsPerMillimetre : 1e-3;
  views_[name]->show(makeFigure(name), secondsPerUnit, name == "psd" ? "Hz" : inMillimetres ? "mm" : "ms");
}

std::unique_ptr<plots::Figure> SignalsPanel::makeFigure(const QString& name) const {
  std::unique_ptr<plots::Figure> figure;
  if (name == "aba")
    figure = settings_.againstTime ? plots::abaTimeFigure(*shown_, style_) : plots::abaPositionFigure(*shown_, style_);
  else if (name == "psd")
    figure = plots::psdFigure(*shown_, style_);
  else if (name == "stft")
    figure = plots::stftFigure(*shown_, style_);
  else if (name == "scalogram")
    figure = plots::scalogramFigure(*shown_, style_);
  else if (name == "contact_force")
    figure = plots::contactForceFigure(*shown_, style_);
  else if (name == "contact_patch")
    figure = plots::patchFigure(*shown_, style_);
  else
    figure = plots::defectProfileFigure(*shown_, style_);
  overlay(*figure, name);
  return figure;
}

// Runs share the axis: positions count from the defect, times from the moment over it.
void SignalsPanel::overlay(plots::Figure& figure, const QString& name) const {
  if (name != "aba" && name != "psd" && name != "contact_force") return;
  std::size_t colour = 2;
  for (const StoredRun& run : store_.overlays()) {
    std::string ignored;
    const ResultPointer other = analysed(*run.result, settings_, ignored);
    if (name == "psd") {
      plots::addCurve(figure, {other->frequency, other->psd, run.label, colour++, 0.9});
      continue;
    }
    const auto* values = other->signal(name == "aba" ? "aba_filtered" : "contact_force");
    if (!values) continue;
    const auto x = name == "aba" && settings_.againstTime ? other->time : other->position;
    plots::addCurve(
        figure, {plots::scaled(x, 1e3), plots::scaled(*values, name == "aba" ? 1 : 1e-3), run.label, colour++, 0.9});
  }
  if (colour > 2 && name == "aba") plots::fitValues(figure);
}

void SignalsPanel::askForFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the figures"));
  if (folder.isEmpty()) return;
  try {
    exportAll(folder);
  } catch (const FileError& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
  }
}

QStringList SignalsPanel::exportAll(const QString& folder) {
  QStringList written;
  for (const auto& name : names()) {
    rebuild(name);
    for (const char* ending : {"png", "svg", "pdf", "csv"}) {
      const QString path = QDir(folder).filePath(name + "." + ending);
      views_[name]->writeFile(path);
      written << path;
    }
  }
  return written;
}

}  // namespace squat::studio

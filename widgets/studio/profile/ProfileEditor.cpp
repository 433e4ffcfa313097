#include "studio/profile/ProfileEditor.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/Errors.h"
#include "plots/FigureFiles.h"
#include "studio/common/ButtonKeys.h"
#include "studio/common/FixedLabel.h"
#include "studio/common/FlowLayout.h"
#include "studio/common/LocationToSave.h"
#include "studio/profile/EditedDefect.h"
#include "studio/profile/ImportDialog.h"
#include "studio/profile/ProfileModel.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/profile/ProfileTable.h"
#include "studio/profile/ShapeControls.h"
#include "studio/profile/SquatDialog.h"

namespace squat::studio {

ProfileEditor::ProfileEditor(CaseDocument& document, const plots::Style& style, QWidget* parent)
    : QWidget(parent), style_(style), defect_(new EditedDefect(document, this)) {
  table_ = new QTableView(this);
  points_ = new ProfileTable(*defect_, table_);
  table_->setModel(points_);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->setDefaultSectionSize(22);
  table_->setAccessibleName(tr("Points of the profile"));
  table_->setObjectName("profileTable");
  table_->setTabKeyNavigation(false);  // Tab leaves the table
  table_->setAccessibleDescription(tr("Insert adds a point halfway to the next one, Delete removes a point."));
  table_->installEventFilter(this);
  location_ = new QLabel(this);
  location_->setObjectName("locationInProfile");
  notes_ = new FixedLabel(1, this);
  notes_->setObjectName("profileNotes");
  auto* side = new QWidget(this);
  auto* sideLayout = new QVBoxLayout(side);
  sideLayout->setContentsMargins(0, 0, 0, 0);
  sideLayout->addWidget(new ShapeControls(*defect_, side));
  sideLayout->addWidget(table_, 1);
  side->setMinimumWidth(235);
  splitter_ = new QSplitter(Qt::Horizontal, this);
  splitter_->setChildrenCollapsible(false);
  splitter_->addWidget(new QWidget(splitter_));
  splitter_->addWidget(side);
  splitter_->setStretchFactor(0, 4);
  splitter_->setStretchFactor(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(makeToolBar());
  layout->addWidget(splitter_, 1);
  auto* foot = new QHBoxLayout;
  foot->addWidget(notes_, 1);
  foot->addWidget(location_);
  layout->addLayout(foot);
  makePlot(style);
  connect(defect_, &EditedDefect::changed, this, &ProfileEditor::showNotes);
  connect(defect_, &EditedDefect::sidesChanged, this, &ProfileEditor::showSides);
  connect(defect_, &EditedDefect::replaced, this, &ProfileEditor::showSides);
  connect(defect_, &EditedDefect::refused, this, &ProfileEditor::failed);
  showSides();
  showNotes();
  // Queued: the table lays out its rows first.
  connect(points_, &QAbstractItemModel::modelReset, this, &ProfileEditor::showPoints, Qt::QueuedConnection);
  showPoints();
}

QWidget* ProfileEditor::makeToolBar() {
  auto* bar = new QWidget(this);
  auto* layout = new FlowLayout(bar);
  layout->addWidget(makeSideChoice(bar));
  const auto button = [&](const QString& text, const QString& tip, auto action) {
    auto* made = new QToolButton(bar);
    made->setText(text);
    made->setFocusPolicy(Qt::StrongFocus);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    layout->addWidget(made);
    connect(made, &QToolButton::clicked, this, action);
    return made;
  };
  button(tr("Import…"), tr("Import a measured profile from a text table"), [this] {
    askForFile();
  })->setObjectName("importProfile");
  button(tr("Export…"), tr("Export the profile as CSV"), [this] { exportFile(); })->setObjectName("exportProfile");
  button(tr("Squat…"), tr("Choose a squat by class, form and size"), [this] {
    chooseSquat();
  })->setObjectName("chooseSquat");
  button(tr("To points"), tr("Convert the shape into points that can be dragged"), [this] {
    defect_->edit(tr("Convert the shape into points"), asPoints(defect_->description()));
  })->setObjectName("toPoints");
  button(tr("Fit"), tr("Show the whole defect (F)"), [this] { plot_->fit(); });
  giveKeys(*bar, {{"importProfile", "Ctrl+I"},
                  {"exportProfile", "Ctrl+Shift+I"},
                  {"chooseSquat", "Ctrl+Shift+T"},
                  {"toPoints", "Ctrl+T"}});
  snap_ = new QComboBox(bar);
  snap_->addItem(tr("Snapping off"), QPointF(0, 0));
  snap_->addItem(tr("Snap 0.5 mm, 1 µm"), QPointF(5e-4, 1e-6));
  snap_->addItem(tr("Snap 1 mm, 5 µm"), QPointF(1e-3, 5e-6));
  snap_->addItem(tr("Snap 5 mm, 10 µm"), QPointF(5e-3, 1e-5));
  snap_->setAccessibleName(tr("Snapping"));
  snap_->setObjectName("snap");
  connect(snap_, &QComboBox::currentIndexChanged, this, [this] {
    const QPointF steps = snap_->currentData().toPointF();
    plot_->setSnap(steps.x(), steps.y());
  });
  layout->addWidget(snap_);
  unitChoice_ = new QComboBox(bar);
  unitChoice_->addItems({tr("Heights in µm"), tr("Heights in mm")});
  unitChoice_->setAccessibleName(tr("Unit of heights"));
  unitChoice_->setObjectName("heightUnit");
  connect(unitChoice_, &QComboBox::currentIndexChanged, this, [this] {
    plot_->setUnit(unit());
    points_->setUnit(unit());
  });
  layout->addWidget(unitChoice_);
  return bar;
}

QComboBox* ProfileEditor::makeSideChoice(QWidget* parent) {
  side_ = new QComboBox(parent);
  side_->addItems({tr("Left side"), tr("Right side")});
  side_->setAccessibleName(tr("Side of the track"));
  side_->setToolTip(
      tr("Whose defect is shown and changed. The right side has the defect of the left one until it is "
         "changed here or in the form"));
  side_->setObjectName("profileSide");
  connect(side_, &QComboBox::currentIndexChanged, this, [this](int index) {
    defect_->show(index == 1 ? EditedDefect::Side::right : EditedDefect::Side::left);
    plot_->fit();
  });
  return side_;
}

// A half model has no choice.
void ProfileEditor::showSides() {
  const QSignalBlocker quiet(side_);
  side_->setCurrentIndex(defect_->side() == EditedDefect::Side::right ? 1 : 0);
  side_->setVisible(defect_->hasBothSides());
}

void ProfileEditor::makePlot(const plots::Style& style) {
  style_ = style;
  plot_ = new ProfilePlot(*defect_, style, this);
  delete splitter_->replaceWidget(0, plot_);
  splitter_->setStretchFactor(0, 4);
  plot_->show();
  const QPointF steps = snap_->currentData().toPointF();
  plot_->setSnap(steps.x(), steps.y());
  plot_->setUnit(unit());
  connect(plot_, &ProfilePlot::cursorMoved, this, [this](double position, double height) {
    location_->setText(tr("%1 mm, %2 %3")
                           .arg(position * 1e3, 0, 'f', 1)
                           .arg(height * unit().perMetre, 0, 'f', unit().digits)
                           .arg(unit().name));
  });
  connect(plot_, &ProfilePlot::pullRadiusChanged, this, &ProfileEditor::showNotes);
  connect(plot_, &ProfilePlot::chosenChanged, this, &ProfileEditor::showChosen);
  connect(table_, &QTableView::clicked, plot_,
          [this](const QModelIndex& index) { plot_->choose(static_cast<std::size_t>(index.row())); });
  // By keys as well.
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, plot_, [this](const QModelIndex& index) {
    if (index.isValid() && table_->hasFocus()) plot_->choose(static_cast<std::size_t>(index.row()));
  });
}

void ProfileEditor::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  QTimer::singleShot(0, this, &ProfileEditor::showPoints);
}

// Insert and Delete as on the curve; Delete would begin to type in the table.
bool ProfileEditor::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const bool inserts = key.key() == Qt::Key_Insert;
  if ((!inserts && key.key() != Qt::Key_Delete) || key.modifiers() & ~Qt::KeypadModifier) return false;
  if (const QModelIndex cell = table_->currentIndex(); cell.isValid() && !plot_->chosen())
    plot_->choose(static_cast<std::size_t>(cell.row()));
  inserts ? plot_->insertPoint() : plot_->removePoint();
  return true;
}

// The table begins where the defect is deepest, not with the smooth rail before it.
void ProfileEditor::showPoints() {
  showNotes();
  if (points_->rowCount() == 0) return;
  const auto& points = defect_->description().defect.points;
  const auto deepest =
      std::min_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.height < b.height; });
  const int row = static_cast<int>(deepest - points.begin());
  table_->scrollTo(points_->index(std::min(row, points_->rowCount() - 1), 0), QAbstractItemView::PositionAtCenter);
  if (plot_->chosen()) showChosen();  // the row went with the rows before
}

void ProfileEditor::showChosen() {
  QItemSelectionModel* rows = table_->selectionModel();
  const auto chosen = plot_->chosen();
  if (!chosen) return rows->clear();
  const int column = std::max(0, table_->currentIndex().column());  // that of the cell which was clicked
  rows->setCurrentIndex(points_->index(static_cast<int>(*chosen), column),
                        QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

// What must be known of the profile, else what can be done with it.
void ProfileEditor::showNotes() {
  const QString notes = profileNotes(defect_->description().defect);
  const QString hint =
      points_->rowCount() > 0
          ? tr("Drag the curve: points within %1 mm follow (mouse wheel). A double-click adds a point, Delete removes "
               "it")
                .arg(plot_->pullRadius() * 1e3)
          : tr("Pull the curve for its depth, its ends for its length. A double-click turns it into points");
  notes_->say(notes.isEmpty() ? hint : notes);
  notes_->setForegroundRole(notes.isEmpty() ? QPalette::PlaceholderText : QPalette::WindowText);
}

HeightUnit ProfileEditor::unit() const { return unitChoice_->currentIndex() == 1 ? millimetres() : micrometres(); }

void ProfileEditor::setStyle(const plots::Style& style) { makePlot(style); }

void ProfileEditor::askForFile() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Import a profile"), QString(),
                                                    tr("Tables (*.csv *.txt *.dat);;All files (*)"));
  if (!path.isEmpty()) importFile(path);
}

void ProfileEditor::importFile(const QString& path) {
  try {
    auto* dialog = new ImportDialog(path, style_, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
      cases::CaseDescription after = defect_->description();
      after.defect.shape = cases::DefectShape::profile;
      after.defect.points = dialog->points();
      after.defect.lines.clear();
      after.defect.file.clear();
      after.defect.level = dialog->levelsThroughEnds();  // what was levelled otherwise stays as it was seen
      after.defect.heightScale = 1;
      after.defect.from = after.defect.to = 0;
      after.defect.filter = cases::ProfileFilter::none;
      defect_->edit(tr("Import a profile"), after);
      plot_->choose(std::nullopt);  // even where one point alone differs from the profile before
      plot_->fit();
    });
    dialog->open();
  } catch (const FileError& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
  }
}

void ProfileEditor::chooseSquat() {
  auto* dialog = new SquatDialog(defect_->description(), style_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    defect_->edit(tr("Choose a squat"), dialog->description());
    plot_->choose(std::nullopt);
    plot_->fit();
  });
  dialog->open();
}

void ProfileEditor::exportFile() {
  const QString path = locationToSave(this, tr("Export the profile"), "profile.csv", tr("CSV (*.csv)"));
  if (path.isEmpty()) return;
  const ProfileView view = profileView(defect_->description());
  QByteArray text("position [mm],height [um]\n");
  for (const auto& point : view.handles.empty() ? view.surface : view.handles)
    text += QByteArray::number(point.position * 1e3, 'g', 12) + ',' + QByteArray::number(point.height * 1e6, 'g', 12) +
            '\n';
  try {
    plots::writeWhole(text, path.toStdString());
  } catch (const FileError& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
  }
}

}  // namespace squat::studio

#include "studio/document/ParameterForm.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

#include "case/InputPresets.h"
#include "case/MeshPresets.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "studio/common/EditorHabits.h"
#include "studio/common/FixedLabel.h"
#include "studio/common/Words.h"
#include "studio/document/CaseDocument.h"
#include "studio/document/ParameterRow.h"

namespace squat::studio {
namespace {

QString asSentence(const ParameterRow& row) {
  return QStringLiteral("%1: %2").arg(QString::fromStdString(row.key()), row.reason());
}

QString relation(const CaseProblem& problem) {
  return QObject::tr("must be %1. %2")
      .arg(printedUnits(QString::fromStdString(problem.allowed)), QString::fromStdString(problem.advice));
}

}  // namespace

ParameterForm::ParameterForm(CaseDocument& document, QWidget* parent) : QWidget(parent), document_(document) {
  search_ = new QLineEdit(this);
  search_->setPlaceholderText(tr("Search parameters"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search parameters"));
  search_->setObjectName("parameterSearch");
  changedOnly_ = new QCheckBox(tr("Changed only"), this);
  changedOnly_->setObjectName("changedOnly");
  changedOnly_->setToolTip(tr("Show only parameters that differ from their default"));
  makeLevels();
  makeSides();
  auto* top = new QHBoxLayout;
  top->addWidget(search_);
  top->addWidget(level_);
  top->addWidget(changedOnly_);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* inside = new QWidget(scroll);
  makeGroups(inside);
  scroll->setWidget(inside);
  letWheelPass(*inside);
  leaveUndoToWindow(*inside);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addLayout(top);
  layout->addWidget(sides_);
  layout->addWidget(scroll);
  why_ = new FixedLabel(2, this);
  why_->setObjectName("formReason");
  layout->addWidget(why_);
  connect(this, &ParameterForm::blockersChanged, this, &ParameterForm::showReason);
  connect(qApp, &QApplication::focusChanged, this, &ParameterForm::showReason);
  constexpr int scrollBar = 24;
  setMinimumWidth(inside->minimumSizeHint().width() + scrollBar);
  connect(search_, &QLineEdit::textChanged, this, &ParameterForm::filter);
  connect(changedOnly_, &QCheckBox::toggled, this, &ParameterForm::filter);
  connect(level_, &QComboBox::currentIndexChanged, this, [this](int level) {
    QSettings().setValue("parameterLevel", level);
    filter();
  });
  connect(&document_, &CaseDocument::changed, this, &ParameterForm::update);
  connect(&document_, &CaseDocument::replaced, this, [this] {
    for (ParameterRow* each : rows_) each->dropRefused();
    sides_->setCurrentIndex(0);
  });
  update();
}

// Hidden while it is whole: the field that loses the focus commits its text, which calls rows and form.
ParameterForm::~ParameterForm() { hide(); }

void ParameterForm::makeLevels() {
  level_ = new QComboBox(this);
  level_->setObjectName("parameterLevel");
  level_->setAccessibleName(tr("Parameters shown"));
  level_->addItem(tr("Basic"));
  level_->addItem(tr("Advanced"));
  level_->addItem(tr("Expert"));
  level_->setItemData(0, tr("What every case sets: speed, load, defect, pads, sleepers, mesh"), Qt::ToolTipRole);
  level_->setItemData(1, tr("All that describes track, vehicle, defect and outputs"), Qt::ToolTipRole);
  level_->setItemData(2, tr("All parameters, those of the model itself as well"), Qt::ToolTipRole);
  level_->setToolTip(
      tr("Which parameters are shown. What the case states itself, what is wrong and what a search finds "
         "is always shown"));
  level_->setCurrentIndex(std::clamp(QSettings().value("parameterLevel", 0).toInt(), 0, level_->count() - 1));
}

void ParameterForm::makeSides() {
  sides_ = new QTabBar(this);
  sides_->setObjectName("sides");
  sides_->setAccessibleName(tr("Side of the track"));
  sides_->setExpanding(false);
  sides_->addTab(tr("Left"));
  sides_->addTab(tr("Right"));
  sides_->setTabToolTip(0, tr("The left side, and what both sides have in common. What the right side has of its own "
                              "stands below its counterpart"));
  sides_->setTabToolTip(1, tr("What the right side may have of its own. It is as on the left until it is given here, "
                              "and again when its field is emptied"));
  sides_->hide();
  connect(sides_, &QTabBar::currentChanged, this, &ParameterForm::filter);
}

bool ParameterForm::isWhole() const { return document_.description().extent == cases::ModelExtent::whole; }

// Each below its counterpart on the left.
void ParameterForm::makeRightRows() {
  if (rows_.back()->isOnRight()) return;
  for (Group& group : groups_) {
    auto* layout = static_cast<QVBoxLayout*>(group.body->layout());
    std::vector<ParameterRow*> all;
    for (ParameterRow* left : group.rows) {
      all.push_back(left);
      if (!cases::mayDiffer(left->parameter().key)) continue;
      auto* row = new ParameterRow(document_, left->parameter(), RowSide::right, group.body);
      layout->insertWidget(layout->indexOf(left) + 1, row);
      row->followInTabOrder(*left);
      letWheelPass(*row);
      leaveUndoToWindow(*row);
      connect(row, &ParameterRow::reasonChanged, this, &ParameterForm::blockersChanged);
      all.push_back(row);
      rows_.push_back(row);
    }
    group.rows = std::move(all);
  }
}

void ParameterForm::makeGroups(QWidget* inside) {
  auto* layout = new QVBoxLayout(inside);
  layout->setContentsMargins(0, 0, 6, 0);
  layout->setSpacing(2);
  for (const auto& parameter : cases::parameterTable()) {
    const QString title = QString::fromStdString(parameter.group);
    if (groups_.empty() || groups_.back().header->objectName() != "group " + title) {
      auto* header = new QToolButton(inside);
      header->setText(title.left(1).toUpper() + title.mid(1));
      header->setObjectName("group " + title);
      header->setCheckable(true);
      header->setChecked(true);
      header->setAutoRaise(true);
      header->setArrowType(Qt::DownArrow);
      header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
      header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
      QFont font = header->font();
      font.setBold(true);
      header->setFont(font);
      auto* body = new QWidget(inside);
      auto* rows = new QVBoxLayout(body);
      rows->setContentsMargins(8, 0, 0, 4);
      rows->setSpacing(1);
      connect(header, &QToolButton::toggled, body, [header, body](bool open) {
        header->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        body->setVisible(open);
      });
      layout->addWidget(header);
      layout->addWidget(body);
      groups_.push_back({header, body, {}});
    }
    auto* row = new ParameterRow(document_, parameter, RowSide::left, groups_.back().body);
    groups_.back().body->layout()->addWidget(row);
    groups_.back().rows.push_back(row);
    rows_.push_back(row);
    connect(row, &ParameterRow::reasonChanged, this, &ParameterForm::blockersChanged);
  }
  layout->addStretch();
}

ParameterRow* ParameterForm::row(const std::string& key) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [&](const ParameterRow* candidate) { return candidate->key() == key; });
  return found == rows_.end() ? nullptr : *found;
}

void ParameterForm::update() {
  unplaced_.clear();
  if (isWhole()) makeRightRows();
  sides_->setVisible(isWhole());
  for (ParameterRow* each : rows_) {
    if (each->isOnRight() && !isWhole()) each->dropRefused();  // nobody could mend it
    each->showRelation({});
    each->showValue();
  }
  for (const auto& problem : document_.validation().problems) {
    if (ParameterRow* flagged = row(problem.key))
      flagged->showRelation(relation(problem));
    else
      unplaced_ << QString::fromStdString(toText(problem));
  }
  filter();
  Q_EMIT blockersChanged();
}

void ParameterForm::mark(const std::vector<CaseProblem>& problems) {
  for (const auto& problem : problems)
    if (ParameterRow* flagged = row(problem.key)) flagged->showRelation(relation(problem));
  filter();
  Q_EMIT blockersChanged();
}

bool ParameterForm::isOfLevel(const ParameterRow& row) const {
  return static_cast<int>(row.parameter().level) <= level_->currentIndex();
}

// What is wrong, and the row that is being edited.
bool ParameterForm::isNeeded(const ParameterRow& row) const {
  const QWidget* focus = QApplication::focusWidget();
  return !row.reason().isEmpty() || (focus && row.isAncestorOf(focus));
}

void ParameterForm::takePresets() {
  const auto& shown = document_.description();
  std::vector<std::string> names{cases::valueText(shown, *cases::findParameter("mesh.preset"))};
  for (const char* key : cases::inputPresetKeys) names.push_back(cases::valueText(shown, *cases::findParameter(key)));
  if (names == presetNames_) return;
  presetNames_ = names;
  presets_ = cases::defaultCase();
  cases::applyPreset(presets_, shown.mesh.preset);
  for (std::size_t i = 1; i < names.size(); ++i) try {
      cases::applyInputPreset(presets_, cases::inputPresetKeys[i - 1], names[i]);
    } catch (const FileError&) {  // validation says so; its keys count as stated
    }
}

// By the case itself: neither a default nor a preset gives this value.
bool ParameterForm::isStated(const ParameterRow& row) const {
  if (row.isOnRight()) return row.isChanged() || row.isRefused();
  if (cases::isList(row.parameter())) return row.isChanged();
  return row.isRefused() ||
         cases::valueText(document_.description(), row.parameter()) != cases::valueText(presets_, row.parameter());
}

// Both tabs show what the right side has of its own; results of a search and errors are always shown.
bool ParameterForm::isWanted(const ParameterRow& row, const QString& searched) const {
  if ((row.isOnRight() && !isWhole()) || !row.matches(searched)) return false;
  const bool isHidden = !row.isOnRight() && showsRight();
  if (changedOnly_->isChecked()) return row.isRefused() || (row.isChanged() && !isHidden);
  if (!searched.isEmpty() || isNeeded(row)) return true;
  if (isHidden) return false;
  return isStated(row) || (isOfLevel(row) && row.isOnRight() == showsRight());
}

void ParameterForm::filter() {
  const QString searched = search_->text().trimmed();
  takePresets();
  for (const Group& group : groups_) {
    bool any = false;
    for (ParameterRow* each : group.rows) {
      const bool shown = isWanted(*each, searched);
      each->setVisible(shown);
      any = any || shown;
    }
    group.header->setVisible(any);
    group.body->setVisible(any && group.header->isChecked());
  }
}

void ParameterForm::showReason() {
  const QWidget* focus = QApplication::focusWidget();
  const ParameterRow* wrong = nullptr;
  for (const ParameterRow* each : rows_) {
    if (each->reason().isEmpty()) continue;
    if (!wrong) wrong = each;
    if (focus && each->isAncestorOf(focus)) wrong = each;
  }
  why_->warn(wrong ? wrong->label() + ": " + wrong->reason() : unplaced_.value(0));
}

QStringList ParameterForm::blockers() const {
  QStringList reasons = unplaced_;
  for (const ParameterRow* each : rows_)
    if (!each->reason().isEmpty()) reasons << asSentence(*each);
  return reasons;
}

QStringList ParameterForm::refusals() const {
  QStringList reasons;
  for (const ParameterRow* each : rows_)
    if (each->isRefused()) reasons << asSentence(*each);
  return reasons;
}

}  // namespace squat::studio

#include "studio/document/ParameterForm.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "studio/common/EditorHabits.h"
#include "studio/common/Words.h"
#include "studio/document/CaseDocument.h"
#include "studio/document/ParameterRow.h"

namespace squat::studio {
namespace {

QString sentence(const ParameterRow& row) {
  return QStringLiteral("%1: %2").arg(QString::fromStdString(row.parameter().key), row.reason());
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
  auto* top = new QHBoxLayout;
  top->addWidget(search_);
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
  layout->addWidget(scroll);
  constexpr int scrollBar = 24;
  setMinimumWidth(inside->minimumSizeHint().width() + scrollBar);
  connect(search_, &QLineEdit::textChanged, this, &ParameterForm::filter);
  connect(changedOnly_, &QCheckBox::toggled, this, &ParameterForm::filter);
  connect(&document_, &CaseDocument::changed, this, &ParameterForm::update);
  connect(&document_, &CaseDocument::replaced, this, [this] {
    for (ParameterRow* each : rows_) each->dropRefused();
  });
  update();
}

// Hidden while it is whole: the field that loses the focus commits its text, which calls rows and form.
ParameterForm::~ParameterForm() { hide(); }

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
    auto* row = new ParameterRow(document_, parameter, groups_.back().body);
    groups_.back().body->layout()->addWidget(row);
    groups_.back().rows.push_back(row);
    rows_.push_back(row);
    connect(row, &ParameterRow::reasonChanged, this, &ParameterForm::blockersChanged);
  }
  layout->addStretch();
}

ParameterRow* ParameterForm::row(const std::string& key) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const ParameterRow* candidate) { return candidate->parameter().key == key; });
  return found == rows_.end() ? nullptr : *found;
}

void ParameterForm::update() {
  unplaced_.clear();
  for (ParameterRow* each : rows_) {
    each->showRelation({});
    each->showValue();
  }
  for (const auto& problem : document_.validation().problems) {
    if (ParameterRow* flagged = row(problem.key))
      flagged->showRelation(relation(problem));
    else
      unplaced_ << QString::fromStdString(toText(problem));
  }
  if (changedOnly_->isChecked()) filter();
  Q_EMIT blockersChanged();
}

void ParameterForm::mark(const std::vector<CaseProblem>& problems) {
  for (const auto& problem : problems)
    if (ParameterRow* flagged = row(problem.key)) flagged->showRelation(relation(problem));
  Q_EMIT blockersChanged();
}

void ParameterForm::filter() {
  const QString searched = search_->text().trimmed();
  for (const Group& group : groups_) {
    bool any = false;
    for (ParameterRow* each : group.rows) {
      const bool edited = each->isChanged() || each->isRefused();
      const bool shown = each->matches(searched) && (edited || !changedOnly_->isChecked());
      each->setVisible(shown);
      any = any || shown;
    }
    group.header->setVisible(any);
    group.body->setVisible(any && group.header->isChecked());
  }
}

QStringList ParameterForm::blockers() const {
  QStringList reasons = unplaced_;
  for (const ParameterRow* each : rows_)
    if (!each->reason().isEmpty()) reasons << sentence(*each);
  return reasons;
}

QStringList ParameterForm::refusals() const {
  QStringList reasons;
  for (const ParameterRow* each : rows_)
    if (each->isRefused()) reasons << sentence(*each);
  return reasons;
}

}  // namespace squat::studio

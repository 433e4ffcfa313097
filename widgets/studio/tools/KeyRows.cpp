#include "studio/tools/KeyRows.h"

#include <QComboBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "case/ParameterValue.h"
#include "studio/common/Words.h"

namespace squat::studio {

KeyRows::KeyRows(const std::function<bool(const cases::Parameter&)>& mayVary, const QString& hint, QWidget* parent)
    : QWidget(parent), hint_(hint), description_(cases::defaultCase()), lines_(new QVBoxLayout) {
  for (const auto& parameter : cases::parameterTable())
    if (mayVary(parameter)) keys_ << QString::fromStdString(parameter.key);
  auto* add = new QToolButton(this);
  add->setText(tr("&Add a key"));
  add->setObjectName("addKey");
  connect(add, &QToolButton::clicked, this, [this] {
    addRow({}, {});
    rows_.back().key->setFocus();
  });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  lines_->setSpacing(2);
  layout->addLayout(lines_);
  layout->addWidget(add, 0, Qt::AlignLeft);
  addRow({}, {});
}

void KeyRows::addRow(const QString& key, const QString& text) {
  Row row{new QWidget(this), nullptr, nullptr, nullptr};
  row.key = new QComboBox(row.line);
  row.key->setObjectName("key");
  row.key->setAccessibleName(tr("Key to vary"));
  row.key->setEditable(true);
  row.key->setInsertPolicy(QComboBox::NoInsert);
  row.key->addItems(keys_);
  row.key->completer()->setFilterMode(Qt::MatchContains);
  row.key->completer()->setCompletionMode(QCompleter::PopupCompletion);
  row.key->lineEdit()->setPlaceholderText(tr("key, for example defect.depth"));
  row.key->lineEdit()->setAccessibleName(tr("Key to vary"));
  row.key->setCurrentIndex(-1);
  row.key->setEditText(key);
  row.key->setMinimumContentsLength(22);
  row.text = new QLineEdit(text, row.line);
  row.text->setObjectName("values");
  row.text->setAccessibleName(tr("Values"));
  row.text->setPlaceholderText(hint_);
  row.now = new QLabel(row.line);
  row.now->setMinimumWidth(row.now->fontMetrics().horizontalAdvance(QString(28, 'x')));
  auto* remove = new QToolButton(row.line);
  remove->setText(QStringLiteral("✕"));
  remove->setToolTip(tr("Remove this key"));
  remove->setAccessibleName(tr("Remove this key"));
  remove->setAutoRaise(true);
  auto* layout = new QHBoxLayout(row.line);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(row.key, 2);
  layout->addWidget(row.text, 2);
  layout->addWidget(row.now, 2);
  layout->addWidget(remove);
  lines_->addWidget(row.line);
  connect(row.key, &QComboBox::editTextChanged, this, [this, row] { showValue(row); });
  connect(remove, &QToolButton::clicked, this, [this, line = row.line] { removeRow(line); });
  rows_.push_back(row);
  showValue(row);
}

void KeyRows::removeRow(const QWidget* line) {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.line == line; });
  if (found == rows_.end()) return;
  found->line->hide();
  found->line->deleteLater();
  rows_.erase(found);
  if (rows_.empty()) addRow({}, {});
}

void KeyRows::showValue(const Row& row) const {
  const std::string key = row.key->currentText().trimmed().toStdString();
  const auto* parameter = cases::findParameter(key);
  QString text, allowed;
  if (parameter && keys_.contains(QString::fromStdString(key))) {
    const bool bare = parameter->unit.empty() || parameter->unit == "-";
    text = tr("now %1").arg(QString::fromStdString(cases::valueText(description_, *parameter) +
                                                   (bare ? std::string() : " " + parameter->unit)));
    allowed = tr("Allowed: %1").arg(QString::fromStdString(cases::allowedText(*parameter)));
  } else if (parameter) {
    text = tr("cannot be varied here");
  } else if (!key.empty()) {
    text = tr("no such key");
  }
  row.now->setText(printedUnits(text));
  row.text->setToolTip(printedUnits(allowed));
}

void KeyRows::showCase(const cases::CaseDescription& description) {
  description_ = description;
  for (const Row& row : rows_) showValue(row);
}

std::vector<std::string> KeyRows::texts() const {
  std::vector<std::string> all;
  for (const Row& row : rows_) {
    const QString key = row.key->currentText().trimmed();
    if (!key.isEmpty()) all.push_back((key + "=" + row.text->text().trimmed()).toStdString());
  }
  return all;
}

void KeyRows::setTexts(const QStringList& texts) {
  while (!rows_.empty()) {
    rows_.back().line->hide();
    rows_.back().line->deleteLater();
    rows_.pop_back();
  }
  for (const QString& text : texts) addRow(text.section('=', 0, 0), text.section('=', 1));
  if (rows_.empty()) addRow({}, {});
}

}  // namespace squat::studio

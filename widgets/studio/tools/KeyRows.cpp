#include "studio/tools/KeyRows.h"

#include <QComboBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "studio/common/Words.h"

namespace squat::studio {
namespace {

constexpr int usualCount = 5, mostValues = 1000;

// "Depth (defect.depth)": found by the name and by the key.
QString entryOf(const cases::Parameter& parameter) {
  return QStringLiteral("%1 (%2)").arg(parameterLabel(parameter.key), QString::fromStdString(parameter.key));
}

QLineEdit* makeField(const QString& name, const QString& words, const QString& hint, QWidget* parent) {
  auto* field = new QLineEdit(parent);
  field->setObjectName(name);
  field->setAccessibleName(words);
  field->setPlaceholderText(hint);
  return field;
}

}  // namespace

KeyRows::KeyRows(const std::function<bool(const cases::Parameter&)>& mayVary, KeyValues values, QWidget* parent)
    : QWidget(parent), values_(values), description_(cases::defaultCase()), lines_(new QVBoxLayout) {
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

void KeyRows::addRow(const QString& key, const QString& values) {
  Row row{new QWidget(this), nullptr, nullptr, nullptr, nullptr, nullptr};
  row.key = new QComboBox(row.line);
  row.key->setObjectName("key");
  row.key->setAccessibleName(tr("Key to vary"));
  row.key->setEditable(true);
  row.key->setInsertPolicy(QComboBox::NoInsert);
  for (const QString& each : keys_) row.key->addItem(entryOf(*cases::findParameter(each.toStdString())), each);
  row.key->completer()->setFilterMode(Qt::MatchContains);
  row.key->completer()->setCompletionMode(QCompleter::PopupCompletion);
  row.key->lineEdit()->setPlaceholderText(tr("name or key, for example depth"));
  row.key->lineEdit()->setAccessibleName(tr("Key to vary"));
  row.key->setCurrentIndex(row.key->findData(key));
  if (row.key->currentIndex() < 0) row.key->setEditText(key);
  row.key->setMinimumContentsLength(22);
  makeValues(row);
  row.now = new QLabel(row.line);
  row.now->setMinimumWidth(row.now->fontMetrics().horizontalAdvance(QString(20, 'x')));
  auto* remove = new QToolButton(row.line);
  remove->setText(QStringLiteral("✕"));
  remove->setToolTip(tr("Remove this key"));
  remove->setAccessibleName(tr("Remove this key"));
  remove->setAutoRaise(true);
  auto* layout = new QHBoxLayout(row.line);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(row.key, 3);
  layout->addWidget(row.from, 2);
  layout->addWidget(new QLabel(tr("to"), row.line));
  layout->addWidget(row.to, 1);
  layout->addWidget(row.count);
  layout->addWidget(row.now, 2);
  layout->addWidget(remove);
  lines_->addWidget(row.line);
  const QStringList parts = values.split(':');
  row.from->setText(parts.value(0));
  row.to->setText(parts.value(1));
  if (parts.size() > 2) row.count->setValue(parts[2].toInt());
  connect(row.key, &QComboBox::editTextChanged, this, [this, row] { showValue(row); });
  connect(remove, &QToolButton::clicked, this, [this, line = row.line] { removeRow(line); });
  rows_.push_back(row);
  showValue(row);
}

void KeyRows::makeValues(Row& row) {
  const bool limits = values_ == KeyValues::limits;
  row.from = makeField("from", limits ? tr("Lower limit") : tr("First value, or all values with commas between them"),
                       limits ? tr("from") : tr("from; or 20, 35, 60"), row.line);
  row.to = makeField("to", limits ? tr("Upper limit") : tr("Last value"), tr("to"), row.line);
  row.count = new QSpinBox(row.line);
  row.count->setObjectName("count");
  row.count->setAccessibleName(tr("Number of values"));
  row.count->setToolTip(tr("Number of values from the first to the last"));
  row.count->setRange(2, mostValues);
  row.count->setValue(usualCount);
  row.count->setSuffix(tr(" values"));
  row.count->setVisible(!limits && counted_);
  row.count->setEnabled(false);
  connect(row.to, &QLineEdit::textChanged, row.count,
          [count = row.count](const QString& to) { count->setEnabled(!to.trimmed().isEmpty()); });
  for (QLineEdit* each : {row.from, row.to}) connect(each, &QLineEdit::textChanged, this, &KeyRows::edited);
  connect(row.count, &QSpinBox::valueChanged, this, &KeyRows::edited);
  connect(row.key, &QComboBox::editTextChanged, this, &KeyRows::edited);
}

void KeyRows::removeRow(const QWidget* line) {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.line == line; });
  if (found == rows_.end()) return;
  found->line->hide();
  found->line->deleteLater();
  rows_.erase(found);
  if (rows_.empty()) addRow({}, {});
  Q_EMIT edited();
}

// What was chosen from the list, or typed: a name, or a key.
QString KeyRows::keyOf(const Row& row) {
  const QString text = row.key->currentText().trimmed();
  const int entry = row.key->findText(text, Qt::MatchFixedString);
  return entry < 0 ? text : row.key->itemData(entry).toString();
}

void KeyRows::showValue(const Row& row) const {
  const std::string key = keyOf(row).toStdString();
  const auto* parameter = cases::findOnEitherSide(key);
  QString text, allowed;
  if (parameter && keys_.contains(QString::fromStdString(parameter->key))) {
    const bool bare = parameter->unit.empty() || parameter->unit == "-";
    text = tr("now %1").arg(QString::fromStdString(cases::valueText(cases::sideOf(description_, key), *parameter) +
                                                   (bare ? std::string() : " " + parameter->unit)));
    allowed = tr("Allowed: %1").arg(QString::fromStdString(cases::allowedText(*parameter)));
  } else if (parameter) {
    text = tr("cannot be varied here");
  } else if (!key.empty()) {
    text = tr("no such key");
  }
  row.now->setText(printedUnits(text));
  for (QLineEdit* each : {row.from, row.to}) each->setToolTip(printedUnits(allowed));
}

void KeyRows::showCase(const cases::CaseDescription& description) {
  description_ = description;
  for (const Row& row : rows_) showValue(row);
}

void KeyRows::setCounted(bool counted) {
  counted_ = counted;
  for (const Row& row : rows_) row.count->setVisible(values_ == KeyValues::values && counted);
}

std::string KeyRows::textOf(const Row& row, bool counted) const {
  const QString to = row.to->text().trimmed();
  QString text = keyOf(row) + "=" + row.from->text().remove(' ');
  if (!to.isEmpty()) text += ":" + to;
  if (!to.isEmpty() && counted && values_ == KeyValues::values) text += ":" + QString::number(row.count->value());
  return text.toStdString();
}

std::vector<std::string> KeyRows::texts() const {
  std::vector<std::string> all;
  for (const Row& row : rows_)
    if (!keyOf(row).isEmpty()) all.push_back(textOf(row, true));
  return all;
}

std::vector<std::string> KeyRows::limits() const {
  std::vector<std::string> all;
  for (const Row& row : rows_)
    if (!keyOf(row).isEmpty()) all.push_back(textOf(row, false));
  return all;
}

int KeyRows::combinations() const {
  double all = 0;
  for (const Row& row : rows_) {
    if (keyOf(row).isEmpty()) continue;
    const auto listed = row.from->text().split(',', Qt::SkipEmptyParts).size();
    if (listed == 0) return 0;
    const auto values = row.to->text().trimmed().isEmpty() ? static_cast<int>(listed) : row.count->value();
    all = std::max(all, 1.0) * values;
  }
  constexpr double most = 1e9;
  return static_cast<int>(std::min(all, most));
}

void KeyRows::setTexts(const QStringList& texts) {
  while (!rows_.empty()) {
    delete rows_.back().line;
    rows_.pop_back();
  }
  for (const QString& text : texts) addRow(text.section('=', 0, 0), text.section('=', 1));
  if (rows_.empty()) addRow({}, {});
  Q_EMIT edited();
}

}  // namespace squat::studio

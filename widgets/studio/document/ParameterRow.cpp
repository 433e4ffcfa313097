#include "studio/document/ParameterRow.h"

#include <QEvent>
#include <QGridLayout>
#include <QSignalBlocker>

#include "case/Applicability.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "studio/common/DecimalComma.h"
#include "studio/common/Theme.h"
#include "studio/common/Words.h"
#include "studio/document/CaseDocument.h"
#include "studio/document/OtherUnits.h"

namespace squat::studio {
namespace {

QString adviceOf(const cases::Parameter& parameter, const CaseProblem& problem) {
  const QString text = QString::fromStdString(problem.value);
  if (parameter.kind == cases::Kind::number && text.contains(','))
    return QObject::tr(". Write one decimal point or comma, and nothing between thousands");
  // It names the point of a curve or the seat that is wrong.
  return text.startsWith('[') ? ". " + QString::fromStdString(problem.advice) : QString();
}

QString sentence(const cases::Parameter& parameter, const CaseProblem& problem) {
  QString text = QString::fromStdString(problem.value);
  if (text.size() > 40) text = text.left(40) + QChar(0x2026);
  return QObject::tr("“%1” must be %2").arg(text, printedUnits(QString::fromStdString(problem.allowed))) +
         adviceOf(parameter, problem);
}

// With the decimal comma of a number as a point. What a comma is depends on the kind of the key: in a curve or in seats
// "1,5" are two values, in a title or a path it is a letter.
std::string asWritten(const cases::Parameter& parameter, const QString& typed) {
  return (parameter.kind == cases::Kind::number ? withDecimalPoint(typed) : typed).toStdString();
}

// Of long lists, how many there are.
QString shownValue(const cases::CaseDescription& description, const cases::Parameter& parameter) {
  if (!cases::isList(parameter)) return QString::fromStdString(cases::valueText(description, parameter));
  auto copy = description;  // the table gives access to what may be changed
  if (const auto* points = std::get_if<4>(&parameter.access))
    return QObject::tr("%n points", nullptr, static_cast<int>((*points)(copy).size()));
  return QObject::tr("%n lines", nullptr, static_cast<int>(std::get<5>(parameter.access)(copy).size()));
}

// What it is called where the right side has no value of its own.
QString asLeft(const QString& value) {
  return value.isEmpty() ? QObject::tr("as left") : QObject::tr("%1, as left").arg(value);
}

}  // namespace

ParameterRow::ParameterRow(CaseDocument& document, const cases::Parameter& parameter, RowSide side, QWidget* parent)
    : QWidget(parent),
      document_(document),
      parameter_(parameter),
      side_(side),
      key_(side == RowSide::right ? std::string(cases::rightGroup) + "." + parameter.key : parameter.key) {
  makeEditor();
  name_ = new QLabel(label(), this);
  name_->setBuddy(editor_);
  auto* unit = new QLabel(parameter.unit == "-" || cases::isList(parameter)
                              ? QString()
                              : printedUnits(QString::fromStdString(parameter.unit)),
                          this);
  unit->setFixedWidth(46);
  makeReset();
  other_ = new QLabel(this);
  other_->setObjectName("otherUnits");
  other_->setForegroundRole(QPalette::PlaceholderText);
  other_->hide();
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(2, 1, 2, 1);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(0);
  grid->addWidget(name_, 0, 0);
  const bool wide = parameter.kind == cases::Kind::text || parameter.kind == cases::Kind::forceCurve ||
                    parameter.kind == cases::Kind::seats;
  grid->addWidget(editor_, 0, 1, 1, wide ? 2 : 1);
  if (!wide) grid->addWidget(unit, 0, 2);
  unit->setVisible(!wide);
  grid->addWidget(reset_, 0, 3);
  other_->setAlignment(Qt::AlignRight);
  grid->addWidget(other_, 1, 0, 1, 3);
  grid->setColumnStretch(0, wide ? 1 : 5);
  grid->setColumnStretch(1, wide ? 6 : 4);
  name_->setMinimumWidth(wide ? name_->sizeHint().width() : 120);
  name_->setWordWrap(!wide);  // long names take a second line, not the room of the whole form
  showValue();
}

QString ParameterRow::label() const {
  const QString own = parameterLabel(parameter_.key);
  return isOnRight() ? tr("%1, right").arg(own) : own;
}

const cases::CaseDescription& ParameterRow::caseOfSide() const {
  return isOnRight() ? document_.right() : document_.description();
}

void ParameterRow::makeReset() {
  reset_ = new QToolButton(this);
  reset_->setText(QChar(0x21ba));
  reset_->setAutoRaise(true);
  QSizePolicy keepsLocation = reset_->sizePolicy();
  keepsLocation.setRetainSizeWhenHidden(true);
  reset_->setSizePolicy(keepsLocation);
  const QString key = QString::fromStdString(key_);
  reset_->setToolTip(isOnRight() ? tr("Set back to what the left side has")
                                 : tr("Reset to default: %1").arg(QString::fromStdString(parameter_.defaultText)));
  reset_->setAccessibleName(isOnRight() ? tr("Set %1 as on the left").arg(key) : tr("Reset %1").arg(key));
  reset_->setFocusPolicy(Qt::StrongFocus);
  connect(reset_, &QToolButton::clicked, this, &ParameterRow::reset);
}

void ParameterRow::reset() {
  dropRefused();
  document_.resetParameter(key_);
}

// On the right side the first entry is that of the left side, whatever it is.
void ParameterRow::makeChoice() {
  editor_ = choice_ = new QComboBox(this);
  if (isOnRight()) choice_->addItem(asLeft({}));
  if (parameter_.kind == cases::Kind::boolean) choice_->addItems({"true", "false"});
  for (const auto& name : parameter_.choices) choice_->addItem(QString::fromStdString(name));
  if (isOnRight()) choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(choice_, &QComboBox::activated, this,
          [this](int entry) { commit(isOnRight() && entry == 0 ? QString() : choice_->currentText()); });
}

void ParameterRow::makeEditor() {
  const QString key = QString::fromStdString(key_);
  if (parameter_.kind == cases::Kind::choice || (parameter_.kind == cases::Kind::boolean && isOnRight())) {
    makeChoice();
  } else if (parameter_.kind == cases::Kind::boolean) {
    editor_ = check_ = new QCheckBox(this);
    connect(check_, &QCheckBox::clicked, this, [this](bool on) { commit(on ? "true" : "false"); });
  } else {
    editor_ = line_ = new QLineEdit(this);
    line_->setReadOnly(cases::isList(parameter_));
    connect(line_, &QLineEdit::textEdited, this, &ParameterRow::tryText);
    connect(line_, &QLineEdit::editingFinished, this, [this] {
      if (line_->isModified()) commit(line_->text());
    });
  }
  editor_->setObjectName(key);
  editor_->setAccessibleName(key);
  editor_->setFixedHeight(editor_->sizeHint().height());  // with the frame of a wrong value as well
  editor_->setMinimumWidth(choice_ ? 116 : 90);
}

void ParameterRow::showText() {
  const QString shown = shownValue(caseOfSide(), parameter_);
  if (line_ && !isRefused()) {
    const QString own = isAsLeft() ? QString() : shown;  // so that typing begins with an empty field
    line_->setPlaceholderText(isAsLeft() ? asLeft(shown) : QString());
    if (line_->text() != own) line_->setText(own);
    if (!line_->hasFocus()) line_->setCursorPosition(0);  // long texts are seen from their beginning
    line_->setModified(false);
  }
  if (choice_ && isOnRight()) choice_->setItemText(0, asLeft(shownValue(document_.description(), parameter_)));
  if (choice_ && isAsLeft()) choice_->setCurrentIndex(0);
  if (choice_ && !isAsLeft()) choice_->setCurrentText(shown);
  if (check_) check_->setChecked(shown == "true");
}

// A text that the user still has to mend is not taken away by a change of something else.
void ParameterRow::showValue() {
  const bool asOnLeft = isOnRight() && !cases::isStatedOnRight(document_.description(), parameter_.key);
  const std::string text = asOnLeft ? std::string() : cases::valueText(caseOfSide(), parameter_);
  const bool dropsRefused = isRefused() && text != value_;
  value_ = text;
  if (dropsRefused) wrongText_.clear();
  const bool noPoints = cases::isList(parameter_) && text == "[]";
  changed_ = isOnRight() ? !asOnLeft : text != parameter_.defaultText && !noPoints;
  showText();
  QFont font = name_->font();
  font.setBold(changed_);
  name_->setFont(font);
  const QString other = asOnLeft ? QString() : inOtherUnits(document_.description(), parameter_.key);
  other_->setText(other);
  other_->setVisible(!other.isEmpty());
  showReason();
  if (dropsRefused) Q_EMIT reasonChanged();
}

QString ParameterRow::withoutEffect() const {
  const auto& description = document_.description();
  if (isOnRight()) return QString::fromStdString(cases::reasonWithoutRight(description, document_.right(), parameter_));
  if (cases::applies(description, parameter_)) return {};
  return QString::fromStdString(cases::reasonWithoutEffect(description, parameter_));
}

void ParameterRow::showEffect() {
  const QString without = withoutEffect();
  const bool counts = without.isEmpty();
  // Greyed, and still there for keys and screen readers: a value can be prepared, and F1 explains it.
  name_->setForegroundRole(counts ? QPalette::WindowText : QPalette::PlaceholderText);
  const bool greyed = !counts || (choice_ && isAsLeft());  // an empty field is grey by itself
  QPalette colours;
  if (greyed)
    for (const auto role : {QPalette::Text, QPalette::ButtonText, QPalette::WindowText})
      colours.setColor(role, palette().color(QPalette::PlaceholderText));
  editor_->setPalette(greyed ? colours : QPalette());
  const QString doc = QString::fromStdString(parameter_.doc);
  const QString explained = isAsLeft() ? asLeft(shownValue(caseOfSide(), parameter_)) + ". " + doc : doc;
  editor_->setAccessibleDescription(counts ? explained : without);
  const QString first = reason().isEmpty() ? without : reason();
  setToolTip((first.isEmpty() ? QString() : "<b>" + first.toHtmlEscaped() + "</b><br>") + toolTipText());
}

void ParameterRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && reset_) showEffect();  // once the row is made
}

void ParameterRow::dropRefused() {
  if (!isRefused()) return;
  wrongText_.clear();
  showValue();
  Q_EMIT reasonChanged();
}

void ParameterRow::showRelation(const QString& reason) {
  if (reason == relation_) return;
  relation_ = reason;
  showReason();
}

void ParameterRow::tryText(const QString& text) {
  cases::CaseDescription copy = caseOfSide();
  const auto problem = cases::trySetValue(copy, parameter_, asWritten(parameter_, text));
  const bool asOnLeft = isOnRight() && text.isEmpty();
  wrongText_ = problem && !asOnLeft ? sentence(parameter_, *problem) : QString();
  showReason();
  Q_EMIT reasonChanged();
}

// A field of the right side that was emptied is as on the left again.
void ParameterRow::commit(const QString& text) {
  if (isOnRight() && text.isEmpty()) {
    reset();
    return showValue();  // also where nothing has changed
  }
  if (const auto problem = document_.setParameter(key_, asWritten(parameter_, text))) {
    wrongText_ = sentence(parameter_, *problem);
    showReason();
    Q_EMIT reasonChanged();
    return;
  }
  dropRefused();
  showValue();
}

void ParameterRow::showReason() {
  const QString text = reason();
  reset_->setVisible((changed_ || isRefused()) && (isOnRight() || !cases::isList(parameter_)));
  editor_->setStyleSheet(text.isEmpty() ? QString() : QStringLiteral("border: 1px solid %1;").arg(wrongColour));
  showEffect();
}

bool ParameterRow::matches(const QString& searched) const {
  return searched.isEmpty() || QString::fromStdString(key_).contains(searched, Qt::CaseInsensitive) ||
         label().contains(searched, Qt::CaseInsensitive) ||
         QString::fromStdString(parameter_.doc).contains(searched, Qt::CaseInsensitive);
}

void ParameterRow::followInTabOrder(const ParameterRow& row) {
  setTabOrder(row.reset_, editor_);
  setTabOrder(editor_, reset_);
}

QString ParameterRow::toolTipText() const {
  const QString usual = isOnRight() ? asLeft(shownValue(document_.description(), parameter_))
                                    : QString::fromStdString(parameter_.defaultText);
  return QStringLiteral("<b>%1</b><br>%2<br>%3: %4<br>%5: %6<br><i>%7</i>")
      .arg(QString::fromStdString(key_).toHtmlEscaped(), QString::fromStdString(parameter_.doc).toHtmlEscaped(),
           tr("allowed values"), printedUnits(QString::fromStdString(cases::allowedText(parameter_))).toHtmlEscaped(),
           tr("default"), usual.toHtmlEscaped(), QString::fromStdString(parameter_.source).toHtmlEscaped());
}

}  // namespace squat::studio

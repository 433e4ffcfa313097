#include "studio/document/ParameterRow.h"

#include <QEvent>
#include <QGridLayout>
#include <QSignalBlocker>

#include "case/Applicability.h"
#include "case/ParameterValue.h"
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

}  // namespace

ParameterRow::ParameterRow(CaseDocument& document, const cases::Parameter& parameter, QWidget* parent)
    : QWidget(parent), document_(document), parameter_(parameter) {
  makeEditor();
  name_ = new QLabel(label(), this);
  name_->setBuddy(editor_);
  auto* unit = new QLabel(parameter.unit == "-" || cases::isList(parameter)
                              ? QString()
                              : printedUnits(QString::fromStdString(parameter.unit)),
                          this);
  unit->setFixedWidth(46);
  reset_ = new QToolButton(this);
  reset_->setText(QChar(0x21ba));
  reset_->setAutoRaise(true);
  QSizePolicy keepsLocation = reset_->sizePolicy();
  keepsLocation.setRetainSizeWhenHidden(true);
  reset_->setSizePolicy(keepsLocation);
  reset_->setToolTip(tr("Reset to default: %1").arg(QString::fromStdString(parameter.defaultText)));
  reset_->setAccessibleName(tr("Reset %1").arg(QString::fromStdString(parameter.key)));
  reset_->setFocusPolicy(Qt::StrongFocus);
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
  connect(reset_, &QToolButton::clicked, this, [this] {
    dropRefused();
    document_.resetParameter(parameter_.key);
  });
  showValue();
}

QString ParameterRow::label() const { return parameterLabel(parameter_.key); }

void ParameterRow::makeEditor() {
  const QString key = QString::fromStdString(parameter_.key);
  if (parameter_.kind == cases::Kind::choice) {
    editor_ = choice_ = new QComboBox(this);
    for (const auto& name : parameter_.choices) choice_->addItem(QString::fromStdString(name));
    connect(choice_, &QComboBox::activated, this, [this] { commit(choice_->currentText()); });
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

// A text that the user still has to mend is not taken away by a change of something else.
void ParameterRow::showValue() {
  const std::string text = cases::valueText(document_.description(), parameter_);
  const bool dropsRefused = isRefused() && text != value_;
  value_ = text;
  if (dropsRefused) wrongText_.clear();
  if (line_ && !isRefused()) {
    QString shown = QString::fromStdString(text);
    if (parameter_.kind == cases::Kind::points) {
      const auto* points = std::get_if<4>(&parameter_.access);
      auto copy = document_.description();
      shown = tr("%n points", nullptr, points ? static_cast<int>((*points)(copy).size()) : 0);
    }
    if (const auto* lines = std::get_if<5>(&parameter_.access)) {
      auto copy = document_.description();
      shown = tr("%n lines", nullptr, static_cast<int>((*lines)(copy).size()));
    }
    if (line_->text() != shown) line_->setText(shown);
    if (!line_->hasFocus()) line_->setCursorPosition(0);  // long texts are seen from their beginning
    line_->setModified(false);
  }
  if (choice_) choice_->setCurrentText(QString::fromStdString(text));
  if (check_) check_->setChecked(text == "true");
  const bool noPoints = cases::isList(parameter_) && text == "[]";
  changed_ = text != parameter_.defaultText && !noPoints;
  QFont font = name_->font();
  font.setBold(changed_);
  name_->setFont(font);
  const QString other = inOtherUnits(document_.description(), parameter_.key);
  other_->setText(other);
  other_->setVisible(!other.isEmpty());
  showReason();
  if (dropsRefused) Q_EMIT reasonChanged();
}

void ParameterRow::showEffect() {
  const bool counts = cases::applies(document_.description(), parameter_);
  const QString without =
      counts ? QString() : QString::fromStdString(cases::reasonWithoutEffect(document_.description(), parameter_));
  // Greyed, and still there for keys and screen readers: a value can be prepared, and F1 explains it.
  name_->setForegroundRole(counts ? QPalette::WindowText : QPalette::PlaceholderText);
  QPalette colours;
  if (!counts)
    for (const auto role : {QPalette::Text, QPalette::ButtonText, QPalette::WindowText})
      colours.setColor(role, palette().color(QPalette::PlaceholderText));
  editor_->setPalette(counts ? QPalette() : colours);
  editor_->setAccessibleDescription(counts ? QString::fromStdString(parameter_.doc) : without);
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
  cases::CaseDescription copy = document_.description();
  const auto problem = cases::trySetValue(copy, parameter_, asWritten(parameter_, text));
  wrongText_ = problem ? sentence(parameter_, *problem) : QString();
  showReason();
  Q_EMIT reasonChanged();
}

void ParameterRow::commit(const QString& text) {
  if (const auto problem = document_.setParameter(parameter_.key, asWritten(parameter_, text))) {
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
  reset_->setVisible((changed_ || isRefused()) && !cases::isList(parameter_));
  editor_->setStyleSheet(text.isEmpty() ? QString() : QStringLiteral("border: 1px solid %1;").arg(wrongColour));
  showEffect();
}

bool ParameterRow::matches(const QString& searched) const {
  return searched.isEmpty() || QString::fromStdString(parameter_.key).contains(searched, Qt::CaseInsensitive) ||
         label().contains(searched, Qt::CaseInsensitive) ||
         QString::fromStdString(parameter_.doc).contains(searched, Qt::CaseInsensitive);
}

QString ParameterRow::toolTipText() const {
  return QStringLiteral("<b>%1</b><br>%2<br>%3: %4<br>%5: %6<br><i>%7</i>")
      .arg(QString::fromStdString(parameter_.key).toHtmlEscaped(),
           QString::fromStdString(parameter_.doc).toHtmlEscaped(), tr("allowed values"),
           printedUnits(QString::fromStdString(cases::allowedText(parameter_))).toHtmlEscaped(), tr("default"),
           QString::fromStdString(parameter_.defaultText).toHtmlEscaped(),
           QString::fromStdString(parameter_.source).toHtmlEscaped());
}

}  // namespace squat::studio

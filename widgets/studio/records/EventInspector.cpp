#include "studio/records/EventInspector.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "plots/DetectionFigures.h"
#include "plots/Figure.h"
#include "studio/common/FixedLabel.h"
#include "studio/common/MouseZoom.h"

namespace squat::studio {
namespace {

QString percent(double share) { return QString::number(100 * share, 'f', 0) + " %"; }

// The 90 % range stands in brackets.
QString withRange(double value, double low, double high, int digits) {
  constexpr double toMillimetres = 1e3;
  return QObject::tr("%1 mm (%2 to %3)")
      .arg(toMillimetres * value, 0, 'f', digits)
      .arg(toMillimetres * low, 0, 'f', digits)
      .arg(toMillimetres * high, 0, 'f', digits);
}

// For a narrow place: without the caption, which the line above gives; the label of the colours is in the tool tip.
void makeSmall(plots::Figure& figure) {
  figure.setCaption({}, {});
  figure.xAxis->setLabel(QObject::tr("From the event [mm]"));
  figure.setMinimumSize(180, 130);
  new MouseZoom(figure);
  if (auto* scale = figure.findChild<QCPColorScale*>()) {
    figure.setToolTip(scale->axis()->label());
    scale->axis()->setLabel({});
  }
}

}  // namespace

QString eventInWords(const detection::CombinedEvent& combined) {
  const auto& event = combined.event;
  const auto& judged = event.judgement;
  const QString kind = QString::fromStdString(detection::toText(event.kind));
  QString words = QStringLiteral("%1 %2").arg(kind.left(1).toUpper() + kind.mid(1), percent(event.sureness));
  if (event.kind != detection::Kind::squat)
    return event.reason.empty() ? words : words + ": " + QString::fromStdString(event.reason);
  words += QObject::tr(": %1, %2 deep")
               .arg(withRange(judged.length, judged.lengthLow, judged.lengthHigh, 0),
                    withRange(judged.depth, judged.depthLow, judged.depthHigh, 2));
  const auto& shares = judged.severities;
  if (shares[0] + shares[1] + shares[2] == 0) return words;
  return words + QObject::tr("; light %1, moderate %2, severe %3")
                     .arg(percent(shares[0]), percent(shares[1]), percent(shares[2]));
}

EventInspector::EventInspector(const plots::Style& style, QWidget* parent)
    : QWidget(parent),
      style_(style),
      words_(new FixedLabel(1, this)),
      pages_(new QStackedWidget(this)),
      reason_(new QLabel(pages_)) {
  words_->setObjectName("eventWords");
  reason_->setObjectName("eventReason");
  reason_->setWordWrap(true);
  reason_->setAlignment(Qt::AlignCenter);
  reason_->setForegroundRole(QPalette::PlaceholderText);
  auto* figures = new QWidget(pages_);
  figures_ = new QHBoxLayout(figures);
  figures_->setContentsMargins(0, 0, 0, 0);
  pages_->addWidget(reason_);
  pages_->addWidget(figures);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 0, 0, 0);
  layout->addWidget(words_);
  layout->addWidget(pages_, 1);
  draw();
}

void EventInspector::inspect(const detection::CombinedEvent* event) {
  event_.reset();
  if (event) event_ = *event;
  draw();
}

void EventInspector::setStyle(const plots::Style& style) {
  style_ = style;
  draw();
}

void EventInspector::draw() {
  words_->setText(event_ ? eventInWords(*event_) : QString());
  auto sheet = event_ ? plots::eventFigure(*event_, style_) : plots::FigureSheet();
  if (sheet.panels.size() < 2) {
    reason_->setText(!event_ ? tr("Choose an event: N goes to the next one, P to the one before.")
                             : tr("The signal over this event is in no file. Start the search again to see it."));
    pages_->setCurrentIndex(0);
    return;
  }
  while (const QLayoutItem* before = figures_->takeAt(0)) {
    delete before->widget();
    delete before;
  }
  for (auto& panel : sheet.panels) {
    makeSmall(*panel);
    plots::Figure* figure = panel.release();
    figures_->addWidget(figure, 1);
    figure->show();
  }
  pages_->setCurrentIndex(1);
}

}  // namespace squat::studio

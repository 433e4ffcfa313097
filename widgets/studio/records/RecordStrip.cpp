#include "studio/records/RecordStrip.h"

#include <QMouseEvent>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plots/LineFigure.h"
#include "plots/UnitText.h"
#include "studio/common/KeyboardZoom.h"

namespace squat::studio {
namespace {

using detection::Kind;

constexpr int growEvery = 200;    // [ms] while a record is read
constexpr double nearEvent = 15;  // [m] on both sides of an event that is shown

struct Mark {
  Kind kind;
  QCPScatterStyle::ScatterShape shape;
};
constexpr std::array marks{
    Mark{Kind::squat, QCPScatterStyle::ssTriangle}, Mark{Kind::joint, QCPScatterStyle::ssSquare},
    Mark{Kind::weld, QCPScatterStyle::ssDiamond},   Mark{Kind::corrugation, QCPScatterStyle::ssCross},
    Mark{Kind::flat, QCPScatterStyle::ssCircle},    Mark{Kind::other, QCPScatterStyle::ssPlus}};

QString kindName(Kind kind) { return QString::fromStdString(detection::toText(kind)); }

}  // namespace

RecordStrip::RecordStrip(const plots::Style& style, QWidget* parent)
    : QWidget(parent),
      style_(style),
      sample_(new QPushButton(tr("Open the sam&ple record"), this)),
      timer_(new QTimer(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  setMinimumHeight(135);
  timer_->setInterval(growEvery);
  connect(timer_, &QTimer::timeout, this, &RecordStrip::grow);
  sample_->setObjectName("openSample");
  sample_->setToolTip(tr("300 m of signal with squats, joints, welds and a wheel flat, computed by the solver"));
  connect(sample_, &QPushButton::clicked, this, &RecordStrip::sampleRequested);
  makeFigure();
}

void RecordStrip::makeFigure() {
  const bool isRedrawn = figure_ != nullptr;
  const QCPRange kept = isRedrawn ? figure_->xAxis->range() : QCPRange();
  delete figure_;
  figure_ = new plots::Figure(QStringLiteral("record"), style_, this);
  layout()->addWidget(figure_);
  figure_->setObjectName("recordStrip");
  figure_->setAccessibleName(tr("The record along the track"));
  figure_->xAxis->setLabel(tr("Chainage [m]"));
  figure_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  figure_->axisRect()->setRangeDrag(Qt::Horizontal);
  figure_->axisRect()->setRangeZoom(Qt::Horizontal);
  signal_ = figure_->addGraph();
  signal_->setPen(QPen(style_.curve(0), 1));
  signal_->setAdaptiveSampling(false);  // the overview has as many points as there are pixels
  chosen_ = new QCPItemStraightLine(figure_);
  chosen_->setPen(QPen(style_.axis, 1, Qt::DashLine));
  connect(figure_->xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, [this] { draw(); });
  connect(figure_, &QCustomPlot::mouseDoubleClick, this, [this](const QMouseEvent* event) {
    if (figure_->legendEntryAt(event->pos()) < 0) showWhole();
  });
  connect(figure_, &QCustomPlot::mousePress, this, [this](QMouseEvent* event) { pick(event->pos()); });
  connect(figure_, &QCustomPlot::mouseWheel, this, [this] { whole_ = false; });
  const auto* keys = new KeyboardZoom(
      *figure_, {.showAll = [this] { showWhole(); },
                 .fixed = [this] { return position_; },
                 .alongOnly = true,
                 .others = [this](int key) { return eventKeys_ && eventKeys_(key); },
                 .more = tr("N goes to the next event, P to the one before; 1 to 8 set its label, 0 takes it off.")});
  connect(keys, &KeyboardZoom::moved, this, [this] { whole_ = false; });
  connect(figure_, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) whole_ = false;
  });
  nextStep_ = plots::addNotice(*figure_, tr("No record yet: add one above, or look at the sample"));
  nextStep_->position->setCoords(0.5, 0.25);  // the button stands below
  nextStep_->setFont(style_.labelFont());
  if (isRedrawn) figure_->xAxis->setRange(kept);
  sample_->raise();
  draw();
}

// Axes without numbers would be those of no record.
void RecordStrip::showEmptyState() {
  const bool empty = !overview_;
  for (QCPAxis* axis : figure_->axisRect()->axes()) axis->setVisible(!empty);
  nextStep_->setVisible(empty);
  sample_->setVisible(empty);
  for (QCPAxis* axis : {figure_->xAxis, figure_->yAxis})
    axis->grid()->setVisible(!empty), axis->setTickLabels(signal_->dataCount() > 0);
}

void RecordStrip::placeSample() {
  sample_->resize(sample_->sizeHint());
  sample_->move((width() - sample_->width()) / 2, (height() - sample_->height()) / 2);
}

void RecordStrip::setStyle(const plots::Style& style) {
  style_ = style;
  makeFigure();
}

void RecordStrip::follow(const std::shared_ptr<const records::Overview>& overview) {
  overviewBefore_ = overview_, reportBefore_ = report_;
  overview_ = overview;
  report_.reset();
  position_.reset();
  channel_.clear();
  whole_ = true;
  timer_->start();
  draw();
}

void RecordStrip::setEventKeys(std::function<bool(int key)> take) { eventKeys_ = std::move(take); }

// Without a report, the record before is shown again: its events stand in the list.
void RecordStrip::stopFollowing() {
  timer_->stop();
  if (report_ || !reportBefore_) return;
  overview_ = std::exchange(overviewBefore_, nullptr);
  channel_.clear();
  setReport(std::exchange(reportBefore_, nullptr));
}

void RecordStrip::clear() {
  timer_->stop();
  overview_.reset(), overviewBefore_.reset();
  report_.reset(), reportBefore_.reset();
  position_.reset();
  channel_.clear();
  whole_ = true;
  draw();
  Q_EMIT channelsChanged();
}

void RecordStrip::setReport(const ReportPointer& report) {
  report_ = report;
  grow();
}

QStringList RecordStrip::channels() const {
  QStringList names;
  if (overview_)
    for (const auto& channel : overview_->channels()) names << QString::fromStdString(channel.name);
  return names;
}

int RecordStrip::place() const { return static_cast<int>(channels().indexOf(channel_)); }

QString RecordStrip::channel() const { return channel_; }

void RecordStrip::setChannel(const QString& name) {
  channel_ = name;
  draw();
}

void RecordStrip::grow() {
  if (!overview_) return;
  if (channel_.isEmpty() && !channels().isEmpty()) {
    channel_ = channels().front();
    Q_EMIT channelsChanged();
  }
  if (whole_)
    showWhole();
  else
    draw();
}

void RecordStrip::showWhole() {
  whole_ = true;
  const auto [from, to] = overview_ ? overview_->extent() : std::pair{0.0, 0.0};
  if (to > from) figure_->xAxis->setRange(from, to);
  draw();
}

void RecordStrip::show(double position) {
  whole_ = false;
  position_ = position;
  figure_->xAxis->setRange(position - nearEvent, position + nearEvent);
  draw();
}

// Up and down in every column of pixels.
void RecordStrip::draw() {
  const auto points = static_cast<std::size_t>(std::max(100, figure_->axisRect()->width()));
  const QCPRange range = figure_->xAxis->range();
  QVector<double> x, y;
  if (overview_ && place() >= 0) {
    const auto at = static_cast<std::size_t>(place());
    const auto envelope = overview_->envelope(at, range.lower, range.upper, points);
    for (std::size_t i = 0; i < envelope.position.size(); ++i) {
      x << envelope.position[i] << envelope.position[i];
      y << envelope.low[i] << envelope.high[i];
    }
    const auto all = overview_->channels();
    if (at < all.size())
      figure_->yAxis->setLabel(QStringLiteral("%1 [%2]").arg(channel_, plots::unitText(all[at].unit)));
  }
  signal_->setData(x, y, true);
  double low = 0, high = 1e-3;
  for (const double value : y) low = std::min(low, value), high = std::max(high, value);
  figure_->yAxis->setRange(low - 0.06 * (high - low), high + 0.1 * (high - low));
  drawMarks();
  showEmptyState();
  chosen_->setVisible(position_.has_value());
  if (position_) {
    chosen_->point1->setCoords(*position_, 0);
    chosen_->point2->setCoords(*position_, 1);
  }
  figure_->replot(QCustomPlot::rpQueuedReplot);
}

QStringList RecordStrip::hiddenKinds() const {
  QStringList hidden;
  for (int i = 1; i < figure_->graphCount(); ++i)
    if (!figure_->graph(i)->visible()) hidden << figure_->graph(i)->name();
  return hidden;
}

// Kinds that the user has hidden in the legend stay hidden.
void RecordStrip::drawMarks() {
  const QStringList hidden = hiddenKinds();
  while (figure_->graphCount() > 1) figure_->removeGraph(figure_->graphCount() - 1);
  if (report_)
    for (std::size_t k = 0; k < marks.size(); ++k) {
      QVector<double> x, y;
      for (const auto& combined : report_->events) {
        const auto& event = combined.event;
        if (event.kind != marks[k].kind || QString::fromStdString(event.channel) != channel_) continue;
        x << event.position;
        y << event.peak;
      }
      if (x.isEmpty()) continue;
      QCPGraph* graph = figure_->addGraph();
      graph->setData(x, y);
      graph->setName(kindName(marks[k].kind));
      graph->setVisible(!hidden.contains(graph->name()));
      graph->setLineStyle(QCPGraph::lsNone);
      graph->setScatterStyle(QCPScatterStyle(marks[k].shape, style_.curve(k + 1), style_.curve(k + 1), 8));
    }
  signal_->removeFromLegend();
  figure_->showLegend(figure_->graphCount() > 1);
}

// Only marks that are seen: those of a kind that is hidden are nowhere for the user.
void RecordStrip::pick(const QPoint& point) {
  if (!report_ || figure_->legendEntryAt(point) >= 0) return;
  constexpr double reach = 12;  // [pixels]
  int nearest = -1;
  double distance = reach;
  const QStringList hidden = hiddenKinds();
  for (std::size_t i = 0; i < report_->events.size(); ++i) {
    const auto& event = report_->events[i].event;
    if (QString::fromStdString(event.channel) != channel_ || hidden.contains(kindName(event.kind))) continue;
    const double away = std::hypot(figure_->xAxis->coordToPixel(event.position) - point.x(),
                                   figure_->yAxis->coordToPixel(event.peak) - point.y());
    if (away < distance) distance = away, nearest = static_cast<int>(i);
  }
  if (nearest >= 0) Q_EMIT eventPicked(nearest);
}

void RecordStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeSample();
  draw();
}

}  // namespace squat::studio

#include "studio/profile/ProfilePlot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <cmath>

#include "studio/common/KeyboardZoom.h"
#include "studio/common/MouseZoom.h"
#include "studio/document/CaseDocument.h"

namespace squat::studio {
namespace {

constexpr double toMillimetres = 1e3;
constexpr double catchRadius = 9;     // [pixels]
constexpr double stripHeight = 0.06;  // share of the axes' height for the sleepers
constexpr double highest = 5e-3;      // [m] of a point that is dragged

QVector<double> positions(const std::vector<cases::ProfilePoint>& points) {
  QVector<double> values;
  for (const auto& point : points) values.push_back(point.position * toMillimetres);
  return values;
}

QVector<double> heights(const std::vector<cases::ProfilePoint>& points, double perMetre) {
  QVector<double> values;
  for (const auto& point : points) values.push_back(point.height * perMetre);
  return values;
}

}  // namespace

ProfilePlot::ProfilePlot(CaseDocument& document, const plots::Style& style, QWidget* parent)
    : Figure("profile_editor", style, parent), document_(document) {
  setAccessibleName(tr("Profile of the defect"));
  setMinimumSize(250, 180);
  yAxis->setLabel(tr("Height [%1]").arg(unit_.name));
  path_ = addGraph();
  path_->setPen(QPen(style.curve(1), 1.4, Qt::DashLine));
  path_->setName(tr("path of a rigid wheel"));
  surface_ = addGraph();
  surface_->setPen(QPen(style.curve(0), 1.8));
  surface_->setName(tr("rail surface"));
  removed_ = addGraph();
  removed_->setPen(QPen(style.muted, 1.4, Qt::DotLine));
  removed_->setName(tr("removed by levelling"));
  zero_ = new QCPItemStraightLine(this);
  zero_->setPen(QPen(style.muted, 0.8, Qt::DashDotLine));
  zero_->setSelectable(false);
  handles_ = addGraph();
  handles_->setLineStyle(QCPGraph::lsNone);
  handles_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, style.curve(0), style.background, 6));
  handles_->removeFromLegend();
  mark_ = addGraph();
  mark_->setLineStyle(QCPGraph::lsNone);
  mark_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, style.curve(1), style.curve(1), 10));
  mark_->removeFromLegend();
  showLegend(true);
  new MouseZoom(*this);  // sees no press that drags a point
  new KeyboardZoom(*this, {.showAll = [this] { fit(); },
                           .arrowsAreTaken = [this] { return isChosen(); },
                           .more = tr("A point that is chosen in the table is moved by the arrow keys and removed by "
                                      "Delete; Insert adds one behind it, Escape releases it.")});
  connect(&document_, &CaseDocument::changed, this, &ProfilePlot::update);
  connect(&document_, &CaseDocument::replaced, this, [this] { choose(std::nullopt); });
  update();
}

void ProfilePlot::setUnit(const HeightUnit& unit) {
  const double factor = unit.perMetre / unit_.perMetre;
  const QCPRange seen = yAxis->range();
  unit_ = unit;
  yAxis->setLabel(tr("Height [%1]").arg(unit_.name));
  yAxis->setRange(seen.lower * factor, seen.upper * factor);
  update();
}

void ProfilePlot::setSnap(double position, double height) {
  snapPosition_ = position;
  snapHeight_ = height;
}

void ProfilePlot::update() {
  view_ = profileView(document_.description());
  surface_->setData(positions(view_.surface), heights(view_.surface, unit_.perMetre), true);
  path_->setData(positions(view_.wheelPath), heights(view_.wheelPath, unit_.perMetre), true);
  handles_->setData(positions(view_.handles), heights(view_.handles, unit_.perMetre), true);
  const auto& points = document_.description().defect.points;
  const auto kept = chosen_ ? pointAfter(points_, points, *chosen_) : std::nullopt;
  points_ = points;
  choose(kept && *kept < view_.handles.size() ? kept : std::nullopt);
  drawFrame();
  drawSleepers();
  if (!fitted_) fit();
  fitted_ = true;
  replot(QCustomPlot::rpQueuedReplot);
}

// Where results count from, where that is not the profile's own zero, and what levelling removes.
void ProfilePlot::drawFrame() {
  removed_->setData(positions(view_.removed), heights(view_.removed, unit_.perMetre), true);
  if (view_.removed.empty())
    removed_->removeFromLegend();
  else
    removed_->addToLegend();
  const bool own = view_.shift != 0;
  xAxis->setLabel(own ? tr("x in the profile [mm]") : tr("x from deepest point [mm]"));
  zero_->setVisible(own);
  zero_->point1->setCoords(view_.shift * toMillimetres, 0);
  zero_->point2->setCoords(view_.shift * toMillimetres, 1);
  for (QCPItemPosition* end : {zero_->point1, zero_->point2}) end->setTypeY(QCPItemPosition::ptAxisRectRatio);
}

void ProfilePlot::drawSleepers() {
  for (QCPAbstractItem* item : sleepers_) removeItem(item);
  sleepers_.clear();
  for (double centre : view_.sleepers) {
    auto* box = new QCPItemRect(this);
    for (QCPItemPosition* corner : {box->topLeft, box->bottomRight}) {
      corner->setTypeX(QCPItemPosition::ptPlotCoords);
      corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    box->topLeft->setCoords((centre - view_.sleeperWidth / 2) * toMillimetres, 1 - stripHeight);
    box->bottomRight->setCoords((centre + view_.sleeperWidth / 2) * toMillimetres, 1);
    box->setPen(Qt::NoPen);
    QColor fill = style().muted;
    fill.setAlpha(90);
    box->setBrush(fill);
    box->setSelectable(false);
    auto* label = new QCPItemText(this);
    label->position->setTypeX(QCPItemPosition::ptPlotCoords);
    label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    label->position->setCoords(centre * toMillimetres, 1 - stripHeight / 2);
    label->setText(tr("sleeper"));
    label->setFont(style().tickFont());
    label->setColor(style().text);
    sleepers_.push_back(box);
    sleepers_.push_back(label);
  }
}

void ProfilePlot::fit() {
  bool found = false;
  const QCPRange keys = surface_->getKeyRange(found);
  if (found) xAxis->setRange(keys);
  QCPRange values = surface_->getValueRange(found);
  if (!found || values.size() < 1e-6 * unit_.perMetre) values = QCPRange(-1e-4 * unit_.perMetre, 2e-5 * unit_.perMetre);
  yAxis->setRange(values.lower - 0.2 * values.size(), values.upper + 0.15 * values.size());
  replot(QCustomPlot::rpQueuedReplot);
}

void ProfilePlot::choose(std::optional<std::size_t> index) {
  const bool other = chosen_ != index;
  chosen_ = index;
  if (chosen_ && *chosen_ < view_.handles.size()) {
    const auto& point = view_.handles[*chosen_];
    mark_->setData({point.position * toMillimetres}, {point.height * unit_.perMetre});
  } else {
    mark_->setData(QVector<double>(), QVector<double>());
  }
  replot(QCustomPlot::rpQueuedReplot);
  if (other) Q_EMIT chosenChanged();
}

QPointF ProfilePlot::locationOf(std::size_t index) const {
  if (index >= view_.handles.size()) return {};
  const auto& point = view_.handles[index];
  return {xAxis->coordToPixel(point.position * toMillimetres), yAxis->coordToPixel(point.height * unit_.perMetre)};
}

std::optional<std::size_t> ProfilePlot::pointAt(const QPointF& location) const {
  std::optional<std::size_t> nearest;
  double least = catchRadius;
  for (std::size_t i = 0; i < view_.handles.size(); ++i) {
    const QPointF offset = locationOf(i) - location;
    const double distance = std::hypot(offset.x(), offset.y());
    if (distance < least) least = distance, nearest = i;
  }
  return nearest;
}

cases::ProfilePoint ProfilePlot::profileAt(const QPointF& location) const {
  const double position = xAxis->pixelToCoord(location.x()) / toMillimetres;
  const double height = yAxis->pixelToCoord(location.y()) / unit_.perMetre;
  return {snapped(position, snapPosition_), std::clamp(snapped(height, snapHeight_), -highest, highest)};
}

void ProfilePlot::putPoint(std::size_t index, cases::ProfilePoint to, int gesture) {
  cases::CaseDescription after = document_.description();
  to = pointOfCase(after.defect, to, after.defect.points[index].height);
  after.defect.points = movedPoint(after.defect.points, index, to);
  after.defect.file.clear();
  document_.edit(tr("Move point %1").arg(index + 1), after, gesture);
}

void ProfilePlot::mousePressEvent(QMouseEvent* event) {
  if (dragging_ && event->button() != Qt::LeftButton) return;
  if (event->button() == Qt::LeftButton) {
    dragging_ = false;  // a release may have gone to another window
    if (const auto index = pointAt(event->position())) {
      choose(index);
      dragging_ = true;
      gesture_ = document_.newGesture();
      return;
    }
    choose(std::nullopt);
  }
  Figure::mousePressEvent(event);
}

void ProfilePlot::mouseMoveEvent(QMouseEvent* event) {
  const cases::ProfilePoint under{xAxis->pixelToCoord(event->position().x()) / toMillimetres,
                                  yAxis->pixelToCoord(event->position().y()) / unit_.perMetre};
  Q_EMIT cursorMoved(under.position, under.height);
  if (dragging_ && chosen_) {
    putPoint(*chosen_, profileAt(event->position()), gesture_);
    return;
  }
  setCursor(pointAt(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
  Figure::mouseMoveEvent(event);
}

void ProfilePlot::mouseReleaseEvent(QMouseEvent* event) {
  if (dragging_) {
    dragging_ = event->button() != Qt::LeftButton;
    return;
  }
  Figure::mouseReleaseEvent(event);
}

void ProfilePlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!axisRect()->rect().contains(event->pos()) || pointAt(event->position())) return;
  cases::CaseDescription after = asPoints(document_.description());
  const cases::ProfilePoint added = pointOfCase(after.defect, profileAt(event->position()));
  after.defect.points = withPoint(after.defect.points, added);
  after.defect.file.clear();
  document_.edit(tr("Insert point"), after);
  choose(pointAt(event->position()));
}

void ProfilePlot::wheelEvent(QWheelEvent* event) {
  const bool heightsOnly = event->modifiers() & Qt::ControlModifier;
  axisRect()->setRangeZoom(heightsOnly ? Qt::Vertical : Qt::Horizontal | Qt::Vertical);
  Figure::wheelEvent(event);
}

void ProfilePlot::insertPoint() {
  cases::CaseDescription after = document_.description();
  auto& points = after.defect.points;
  if (!isChosen() || points.size() < 2) return;
  const std::size_t from = std::min(*chosen_, points.size() - 2), before = points.size();
  const cases::ProfilePoint &first = points[from], &second = points[from + 1];
  points = withPoint(points, {(first.position + second.position) / 2, (first.height + second.height) / 2});
  if (points.size() == before) return;  // they are too near for one between them
  after.defect.file.clear();
  document_.edit(tr("Insert point"), after);
  choose(from + 1);
}

// Delete after Delete removes one after the other.
void ProfilePlot::removePoint() {
  if (!isChosen()) return;
  const std::size_t next = *chosen_;
  cases::CaseDescription after = document_.description();
  after.defect.points = withoutPoint(after.defect.points, next);
  after.defect.file.clear();
  document_.edit(tr("Delete point"), after);
  if (next < view_.handles.size()) choose(next);
}

void ProfilePlot::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_F) return fit();
  if (!isChosen()) return Figure::keyPressEvent(event);
  const double across = snapPosition_ > 0 ? snapPosition_ : 1e-4, up = snapHeight_ > 0 ? snapHeight_ : 1e-6;
  const QPoint arrow = arrowOf(*event);
  switch (event->key()) {
    case Qt::Key_Insert:
      return insertPoint();
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return removePoint();
    case Qt::Key_Escape:
      return choose(std::nullopt);
    default:
      break;
  }
  if (arrow.isNull()) return Figure::keyPressEvent(event);
  cases::ProfilePoint to = view_.handles[*chosen_];
  to.position += across * arrow.x();
  to.height += up * arrow.y();
  putPoint(*chosen_, to, 0);
}

}  // namespace squat::studio

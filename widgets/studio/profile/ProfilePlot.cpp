#include "studio/profile/ProfilePlot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QSettings>
#include <array>
#include <cmath>
#include <limits>

#include "studio/common/KeyboardZoom.h"
#include "studio/common/MouseZoom.h"
#include "studio/profile/EditedDefect.h"

namespace squat::studio {
namespace {

constexpr double toMillimetres = 1e3;
constexpr double catchRadius = 9;                                     // [pixels]
constexpr double curveRadius = 6;                                     // [pixels] above and below the curve
constexpr const char* pullKey = "profile/pullRadius";                 // in the settings
constexpr std::array pullRadii{0.0, 0.002, 0.005, 0.01, 0.02, 0.04};  // [m]
constexpr double stripHeight = 0.06;                                  // share of the axes' height for the sleepers
constexpr double highest = 5e-3;                                      // [m] of a point that is dragged

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

ProfilePlot::ProfilePlot(EditedDefect& defect, const plots::Style& style, QWidget* parent)
    : Figure("profile_editor", style, parent), defect_(defect) {
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
  grips_ = addGraph();
  grips_->setLineStyle(QCPGraph::lsNone);
  grips_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssSquare, style.curve(0), style.background, 9));
  grips_->removeFromLegend();
  mark_ = addGraph();
  mark_->setLineStyle(QCPGraph::lsNone);
  mark_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, style.curve(1), style.curve(1), 10));
  mark_->removeFromLegend();
  showLegend(true);
  new MouseZoom(*this, [this] { return !boxing_; });  // sees no press that drags
  radius_ = std::clamp(QSettings().value(pullKey, radius_).toDouble(), pullRadii.front(), pullRadii.back());
  new KeyboardZoom(*this, {.showAll = [this] { fit(); },
                           .arrowsAreTaken = [this] { return isChosen(); },
                           .more = tr("A point that is chosen in the table is moved by the arrow keys and removed by "
                                      "Delete; Insert adds one behind it, Escape releases it.")});
  connect(&defect_, &EditedDefect::changed, this, &ProfilePlot::update);
  connect(&defect_, &EditedDefect::replaced, this, [this] { choose(std::nullopt); });
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
  view_ = profileView(defect_.description());
  surface_->setData(positions(view_.surface), heights(view_.surface, unit_.perMetre), true);
  path_->setData(positions(view_.wheelPath), heights(view_.wheelPath, unit_.perMetre), true);
  handles_->setData(positions(view_.handles), heights(view_.handles, unit_.perMetre), true);
  shape_ = shapeHandles(defect_.description());
  QVector<double> along, up;
  for (const ShapeHandle& handle : shape_) {
    along << handle.at.position * toMillimetres;
    up << handle.at.height * unit_.perMetre;
  }
  grips_->setData(along, up, true);
  const auto& points = defect_.description().defect.points;
  const bool isDragged = dragging_ && chosen_ && points.size() == points_.size();
  const auto kept = isDragged ? chosen_ : chosen_ ? pointAfter(points_, points, *chosen_) : std::nullopt;
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
  return index < view_.handles.size() ? locationOf(view_.handles[index]) : QPointF();
}

QPointF ProfilePlot::locationOf(const cases::ProfilePoint& point) const {
  return {xAxis->coordToPixel(point.position * toMillimetres), yAxis->coordToPixel(point.height * unit_.perMetre)};
}

void ProfilePlot::setPullRadius(double radius) {
  radius_ = radius;
  QSettings().setValue(pullKey, radius);
  Q_EMIT pullRadiusChanged();
}

double ProfilePlot::distanceToCurve(const QPointF& location) const {
  const double position = xAxis->pixelToCoord(location.x()) / toMillimetres;
  const auto& curve = view_.surface;
  const auto behind = std::lower_bound(curve.begin(), curve.end(), position,
                                       [](const auto& point, double at) { return point.position < at; });
  if (behind == curve.begin() || behind == curve.end()) return std::numeric_limits<double>::max();
  return std::abs(locationOf(*behind).y() - location.y());
}

// A handle first, then the curve itself.
std::optional<ShapeHandle> ProfilePlot::gripAt(const QPointF& location) const {
  for (const ShapeHandle& handle : shape_) {
    const QPointF offset = locationOf(handle.at) - location;
    if (std::hypot(offset.x(), offset.y()) < catchRadius) return handle;
  }
  if (shape_.empty() || distanceToCurve(location) > curveRadius) return std::nullopt;
  return handleOnCurve(defect_.description(), xAxis->pixelToCoord(location.x()) / toMillimetres);
}

std::optional<std::size_t> ProfilePlot::pointUnder(const QPointF& location) const {
  if (view_.handles.empty() || distanceToCurve(location) > curveRadius) return std::nullopt;
  const double position = xAxis->pixelToCoord(location.x()) / toMillimetres;
  const auto nearest =
      std::min_element(view_.handles.begin(), view_.handles.end(), [&](const auto& one, const auto& other) {
        return std::abs(one.position - position) < std::abs(other.position - position);
      });
  return static_cast<std::size_t>(nearest - view_.handles.begin());
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

void ProfilePlot::putPoint(std::size_t index, cases::ProfilePoint to) {
  cases::CaseDescription after = defect_.description();
  to = pointOfCase(after.defect, to, after.defect.points[index].height);
  after.defect.points = movedPoint(after.defect.points, index, to);
  after.defect.file.clear();
  defect_.edit(tr("Move point %1").arg(index + 1), after);
}

// What is under the mouse: a point, a handle or the curve. False: nothing is.
bool ProfilePlot::grab(const QPointF& location) {
  auto point = pointAt(location);
  grip_ = point ? std::nullopt : gripAt(location);
  if (!point && !grip_) point = pointUnder(location);
  choose(point);
  if (!point && !grip_) return false;
  offset_ = (grip_ ? locationOf(grip_->at) : locationOf(*point)) - location;
  pressed_ = defect_.description();
  gesture_ = defect_.newGesture();
  return true;
}

void ProfilePlot::drag(const QPointF& location) {
  const cases::ProfilePoint to = profileAt(location + offset_);
  if (grip_)
    return defect_.edit(tr("Change %1").arg(QString::fromStdString(grip_->key)), pulled(pressed_, *grip_, to),
                        gesture_);
  if (!chosen_ || *chosen_ >= pressed_.defect.points.size()) return;
  cases::CaseDescription after = pressed_;
  const auto of = pointOfCase(after.defect, to, after.defect.points[*chosen_].height);
  after.defect.points = pulledPoints(pressed_.defect.points, *chosen_, of, radius_);
  after.defect.file.clear();
  defect_.edit(tr("Move point %1").arg(*chosen_ + 1), after, gesture_);
}

void ProfilePlot::moveView(const QPointF& location) {
  xAxis->moveRange(xAxis->pixelToCoord(last_.x()) - xAxis->pixelToCoord(location.x()));
  yAxis->moveRange(yAxis->pixelToCoord(last_.y()) - yAxis->pixelToCoord(location.y()));
  replot(QCustomPlot::rpQueuedReplot);
}

void ProfilePlot::mousePressEvent(QMouseEvent* event) {
  if (dragging_ && event->button() != Qt::LeftButton) return;
  if (event->button() == Qt::LeftButton) {
    last_ = event->position();
    boxing_ = event->modifiers() & Qt::ShiftModifier;
    dragging_ = !boxing_ && grab(event->position());  // a release may have gone to another window
    moving_ = !boxing_ && !dragging_ && axisRect()->rect().contains(event->pos());
    if (dragging_) return;
  }
  Figure::mousePressEvent(event);
}

void ProfilePlot::mouseMoveEvent(QMouseEvent* event) {
  const cases::ProfilePoint under{xAxis->pixelToCoord(event->position().x()) / toMillimetres,
                                  yAxis->pixelToCoord(event->position().y()) / unit_.perMetre};
  Q_EMIT cursorMoved(under.position, under.height);
  if (dragging_) {
    drag(event->position());
    last_ = event->position();
    return;
  }
  if (moving_ && event->buttons() & Qt::LeftButton) moveView(event->position());
  last_ = event->position();
  const auto grip = gripAt(event->position());
  const bool isPoint = pointAt(event->position()) || pointUnder(event->position());
  setCursor(grip      ? grip->isVertical ? Qt::SizeVerCursor : Qt::SizeHorCursor
            : isPoint ? Qt::PointingHandCursor
                      : Qt::ArrowCursor);
  Figure::mouseMoveEvent(event);
}

void ProfilePlot::mouseReleaseEvent(QMouseEvent* event) {
  if (dragging_) {
    dragging_ = event->button() != Qt::LeftButton;
    return;
  }
  if (event->button() == Qt::LeftButton) moving_ = false;
  Figure::mouseReleaseEvent(event);
}

// A shape becomes points; a profile that has them gets one more, on its curve.
void ProfilePlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!axisRect()->rect().contains(event->pos()) || pointAt(event->position())) return;
  dragging_ = moving_ = false;
  cases::CaseDescription after = asPoints(defect_.description());
  if (view_.handles.empty()) return defect_.edit(tr("Convert the shape into points"), after);
  cases::ProfilePoint added = pointOfCase(after.defect, profileAt(event->position()));
  added.height = heightOn(after.defect.points, added.position);
  after.defect.points = withPoint(after.defect.points, added);
  after.defect.file.clear();
  defect_.edit(tr("Insert point"), after);
  choose(pointAt({event->position().x(), locationOf({added.position, added.height * shownScale(after.defect)}).y()}));
}

void ProfilePlot::wheelEvent(QWheelEvent* event) {
  if (dragging_ && !grip_) {  // the radius, while a point is held
    auto at = std::lower_bound(pullRadii.begin(), pullRadii.end(), radius_ - 1e-9);
    if (event->angleDelta().y() > 0 && std::next(at) < pullRadii.end()) ++at;
    if (event->angleDelta().y() < 0 && at != pullRadii.begin()) --at;
    setPullRadius(*at);
    return drag(last_);
  }
  const bool heightsOnly = event->modifiers() & Qt::ControlModifier;
  axisRect()->setRangeZoom(heightsOnly ? Qt::Vertical : Qt::Horizontal | Qt::Vertical);
  Figure::wheelEvent(event);
}

void ProfilePlot::insertPoint() {
  cases::CaseDescription after = defect_.description();
  auto& points = after.defect.points;
  if (!isChosen() || points.size() < 2) return;
  const std::size_t from = std::min(*chosen_, points.size() - 2), before = points.size();
  const cases::ProfilePoint &first = points[from], &second = points[from + 1];
  points = withPoint(points, {(first.position + second.position) / 2, (first.height + second.height) / 2});
  if (points.size() == before) return;  // they are too near for one between them
  after.defect.file.clear();
  defect_.edit(tr("Insert point"), after);
  choose(from + 1);
}

// Delete after Delete removes one after the other.
void ProfilePlot::removePoint() {
  if (!isChosen()) return;
  const std::size_t next = *chosen_;
  cases::CaseDescription after = defect_.description();
  after.defect.points = withoutPoint(after.defect.points, next);
  after.defect.file.clear();
  defect_.edit(tr("Delete point"), after);
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
  putPoint(*chosen_, to);
}

}  // namespace squat::studio

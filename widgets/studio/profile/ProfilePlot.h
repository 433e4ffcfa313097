// widgets/studio/profile/ProfilePlot.h - the curve of the defect with points to drag, the path of a rigid wheel, the
// sleepers.
#pragma once

#include <memory>
#include <optional>

#include "plots/Figure.h"
#include "studio/common/HeightUnit.h"
#include "studio/profile/ProfileModel.h"
#include "studio/profile/ShapeHandles.h"

namespace squat::studio {

class EditedDefect;

// The curve is pulled with the left button: of an analytic shape up and down for its depth, its ends along the rail for
// its length; of a sampled one a point, and what is within a radius follows, which the wheel changes during the drag.
// Double-click inserts a point on the curve, Insert one halfway to the next; Delete removes the chosen one; arrow keys
// move it by a snap step, Escape releases it. Beside the curve the left button moves the view, and with Shift draws a
// box that is enlarged; the middle button moves the view as well, the wheel zooms (with Ctrl the heights only), F fits.
// Positions in mm, heights in um or mm. A point stays chosen while single points change, and in no other profile.
class ProfilePlot : public plots::Figure {
  Q_OBJECT
 public:
  ProfilePlot(EditedDefect& defect, const plots::Style& style, QWidget* parent = nullptr);

  void setUnit(const HeightUnit& unit);
  void setSnap(double position, double height);  // [m]; zero: free
  void fit();
  std::optional<std::size_t> chosen() const { return chosen_; }
  void choose(std::optional<std::size_t> index);
  void insertPoint();  // halfway from the chosen one to the next, from the last one to that before; it is chosen then
  void removePoint();  // the chosen one; the next one is chosen then
  QPointF locationOf(std::size_t index) const;  // [pixels] of a point, for tests and for the table
  QPointF locationOf(const cases::ProfilePoint& point) const;
  double pullRadius() const { return radius_; }  // [m] within which points follow one that is dragged
  void setPullRadius(double radius);

 Q_SIGNALS:
  void chosenChanged();
  void cursorMoved(double position, double height);  // [m]
  void pullRadiusChanged();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void update();
  void drawSleepers();
  void drawFrame();
  std::optional<std::size_t> pointAt(const QPointF& location) const;
  cases::ProfilePoint profileAt(const QPointF& location) const;
  bool isChosen() const { return chosen_ && *chosen_ < view_.handles.size(); }
  void putPoint(std::size_t index, cases::ProfilePoint to);  // by keys
  std::optional<ShapeHandle> gripAt(const QPointF& location) const;
  // Where the curve is under the mouse: its point that is nearest along the rail.
  std::optional<std::size_t> pointUnder(const QPointF& location) const;
  double distanceToCurve(const QPointF& location) const;  // [pixels] up or down
  bool grab(const QPointF& location);
  void drag(const QPointF& location);
  void moveView(const QPointF& location);

  EditedDefect& defect_;
  HeightUnit unit_;
  ProfileView view_;
  std::vector<cases::ProfilePoint> points_;  // of the case, as last seen
  QCPGraph *surface_, *path_, *removed_, *handles_, *grips_, *mark_;
  QCPItemStraightLine* zero_;  // of the positions in results
  std::vector<QCPAbstractItem*> sleepers_;
  std::optional<std::size_t> chosen_;
  std::vector<ShapeHandle> shape_;   // of an analytic shape
  std::optional<ShapeHandle> grip_;  // that is pulled
  cases::CaseDescription pressed_;   // when the button went down: a drag does not depend on its way
  QPointF offset_;                   // [pixels] from the mouse to what was grabbed
  QPointF last_;                     // [pixels] where the mouse was
  double radius_ = 0.01;             // [m]
  bool dragging_ = false, fitted_ = false, moving_ = false, boxing_ = false;
  int gesture_ = 0;
  double snapPosition_ = 0, snapHeight_ = 0;
};

}  // namespace squat::studio

// widgets/studio/profile/ProfilePlot.h - the curve of the defect with points to drag, the path of a rigid wheel, the
// sleepers.
#pragma once

#include <memory>
#include <optional>

#include "plots/Figure.h"
#include "studio/common/HeightUnit.h"
#include "studio/profile/ProfileModel.h"

namespace squat::studio {

class CaseDocument;

// Drag a point; double-click inserts one, Insert one halfway to the next; Delete removes the chosen one; arrow keys
// move it by a snap step, Escape releases it; wheel zooms (with Ctrl the heights only), a box drawn beside the points
// is enlarged, the middle button moves the view, F fits. Positions in mm, heights in um or mm. A point stays chosen
// while single points change, and in no other profile.
class ProfilePlot : public plots::Figure {
  Q_OBJECT
 public:
  ProfilePlot(CaseDocument& document, const plots::Style& style, QWidget* parent = nullptr);

  void setUnit(const HeightUnit& unit);
  void setSnap(double position, double height);  // [m]; zero: free
  void fit();
  std::optional<std::size_t> chosen() const { return chosen_; }
  void choose(std::optional<std::size_t> index);
  void insertPoint();  // halfway from the chosen one to the next, from the last one to that before; it is chosen then
  void removePoint();  // the chosen one; the next one is chosen then
  QPointF locationOf(std::size_t index) const;  // [pixels] of a point, for tests and for the table

 Q_SIGNALS:
  void chosenChanged();
  void cursorMoved(double position, double height);  // [m]

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
  void putPoint(std::size_t index, cases::ProfilePoint to, int gesture);

  CaseDocument& document_;
  HeightUnit unit_;
  ProfileView view_;
  std::vector<cases::ProfilePoint> points_;  // of the case, as last seen
  QCPGraph *surface_, *path_, *removed_, *handles_, *mark_;
  QCPItemStraightLine* zero_;  // of the positions in results
  std::vector<QCPAbstractItem*> sleepers_;
  std::optional<std::size_t> chosen_;
  bool dragging_ = false, fitted_ = false;
  int gesture_ = 0;
  double snapPosition_ = 0, snapHeight_ = 0;
};

}  // namespace squat::studio

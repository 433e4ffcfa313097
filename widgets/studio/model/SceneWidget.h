// widgets/studio/model/SceneWidget.h - the model in 3-D, painted from a picture drawn off screen.
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "scene/SceneView.h"

namespace squat::studio {

// Left button turns, middle button or Shift moves, the wheel zooms; R shows all again. By keys, arrows turn by five
// degrees, with Shift they move; + and - zoom, Home shows all again. The same path with and without a display, on X11
// and Wayland. While it moves it draws coarser, the fine picture follows when it rests.
class SceneWidget : public QWidget {
  Q_OBJECT
 public:
  explicit SceneWidget(QWidget* parent = nullptr);
  ~SceneWidget() override;

  void setResult(std::shared_ptr<const results::RunResult> result);
  void setHint(const QString& hint);  // shown where there is no model
  void setChoices(const scene::SceneChoices& choices, bool moving = false);
  void lookFrom(scene::StandardView view);
  bool isAvailable() const { return view_ != nullptr || !tried_; }
  QString reason() const { return reason_; }
  // Fine; `pixelRatio` as that of SceneView::render.
  QImage picture(int width, int height, double pixelRatio = 2);
  scene::Eye eye() const { return view_ ? view_->eye() : scene::Eye(); }
  double millisecondsPerFrame() const { return lastFrame_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool take(const QKeyEvent& event);
  bool ensureView();  // made when first shown: starting OpenGL takes a moment
  void refresh(bool moving);

  std::unique_ptr<scene::SceneView> view_;
  std::shared_ptr<const results::RunResult> result_;
  scene::SceneChoices choices_;
  QImage image_;
  QString reason_, hint_;
  QPoint last_;
  QTimer rest_;
  bool tried_ = false, stale_ = true, moving_ = false;
  double lastFrame_ = 0;
};

}  // namespace squat::studio

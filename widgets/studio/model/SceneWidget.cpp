#include "studio/model/SceneWidget.h"

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "studio/common/FocusFrame.h"
#include "studio/common/KeyboardZoom.h"

namespace squat::studio {
namespace {

constexpr double zoomNotch = 1.15;  // of the wheel, and of + and -

QImage asImage(const scene::Picture& picture) {
  if (picture.empty()) return {};
  return QImage(picture.rgb.data(), picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888).copy();
}

}  // namespace

SceneWidget::SceneWidget(QWidget* parent) : QWidget(parent) {
  setMinimumSize(240, 180);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Model in 3-D"));
  setAccessibleDescription(
      tr("Arrow keys turn the model, with Shift they move it; plus and minus zoom, Home shows all."));
  new FocusFrame(*this);
  setObjectName("scene");
  rest_.setSingleShot(true);
  rest_.setInterval(180);
  connect(&rest_, &QTimer::timeout, this, [this] { refresh(false); });
}

SceneWidget::~SceneWidget() = default;

bool SceneWidget::ensureView() {
  if (tried_) return view_ != nullptr;
  tried_ = true;
  std::string reason;
  view_ = scene::SceneView::create(reason);
  reason_ = QString::fromStdString(reason);
  if (!view_) return false;
  view_->setResult(result_);
  view_->setChoices(choices_);
  return true;
}

void SceneWidget::setResult(std::shared_ptr<const results::RunResult> result) {
  result_ = std::move(result);
  if (view_) view_->setResult(result_);
  refresh(false);
}

void SceneWidget::setHint(const QString& hint) {
  hint_ = hint;
  update();
}

void SceneWidget::setChoices(const scene::SceneChoices& choices, bool moving) {
  choices_ = choices;
  if (view_) view_->setChoices(choices);
  refresh(moving);
}

void SceneWidget::lookFrom(scene::StandardView view) {
  if (!ensureView()) return;
  view_->render(16, 16, true);  // settles the place of the wheel
  view_->lookFrom(view);
  refresh(false);
}

QImage SceneWidget::picture(int width, int height, double pixelRatio) {
  return ensureView() && result_ ? asImage(view_->render(width, height, false, pixelRatio)) : QImage();
}

void SceneWidget::refresh(bool moving) {
  stale_ = true;
  moving_ = moving;
  if (moving) rest_.start();
  update();
}

void SceneWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  const bool empty = !result_ || result_->surface.quads.empty();
  if (empty || !ensureView()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap, empty ? hint_ : reason_);
    return;
  }
  if (stale_) {
    QElapsedTimer clock;
    clock.start();
    const double ratio = moving_ ? 0.5 : devicePixelRatioF();
    image_ = asImage(view_->render(static_cast<int>(std::lround(width() * ratio)),
                                   static_cast<int>(std::lround(height() * ratio)), moving_, ratio));
    lastFrame_ = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    stale_ = false;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, moving_);
  painter.drawImage(rect(), image_);
}

void SceneWidget::mousePressEvent(QMouseEvent* event) { last_ = event->pos(); }

void SceneWidget::mouseMoveEvent(QMouseEvent* event) {
  if (!view_ || event->buttons() == Qt::NoButton) return;
  const QPoint by = event->pos() - last_;
  last_ = event->pos();
  if (event->buttons() & Qt::LeftButton && !(event->modifiers() & Qt::ShiftModifier)) {
    constexpr double degreesPerPixel = 0.4;
    view_->rotate(-degreesPerPixel * by.x(), degreesPerPixel * by.y());
  } else {
    view_->pan(by.x(), -by.y(), height());
  }
  refresh(true);
}

void SceneWidget::mouseReleaseEvent(QMouseEvent*) { refresh(false); }

void SceneWidget::wheelEvent(QWheelEvent* event) {
  if (!view_) return;
  view_->zoom(std::pow(zoomNotch, event->angleDelta().y() / 120.0));
  refresh(true);
  event->accept();
}

void SceneWidget::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_R || event->key() == Qt::Key_Home) return lookFrom(scene::StandardView::overview);
  if (!view_ || !take(*event)) return QWidget::keyPressEvent(event);
  refresh(true);
}

// The model follows the arrow, as it follows the mouse.
bool SceneWidget::take(const QKeyEvent& event) {
  constexpr double degrees = 5, share = 0.1;  // of the height
  const auto modifiers = event.modifiers() & ~Qt::KeypadModifier;
  if (modifiers & ~Qt::ShiftModifier) return false;
  const QPoint arrow = arrowOf(event);
  if (const int nearer = zoomOf(event); nearer != 0)
    view_->zoom(nearer > 0 ? zoomNotch : 1 / zoomNotch);
  else if (arrow.isNull())
    return false;
  else if (modifiers)
    view_->pan(share * height() * arrow.x(), share * height() * arrow.y(), height());
  else
    view_->rotate(-degrees * arrow.x(), -degrees * arrow.y());
  return true;
}

void SceneWidget::resizeEvent(QResizeEvent*) { refresh(false); }

}  // namespace squat::studio

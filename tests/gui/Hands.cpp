#include "gui/Hands.h"

#include <QtTest/qtestspontaneevent.h>
#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <QWindow>
#include <stdexcept>

namespace squat::tests {
namespace {

constexpr int lookEvery = 50;  // [ms]

QString bare(QString text) { return text.remove('&'); }

QAction* entry(const QList<QAction*>& actions, const QString& title) {
  for (QAction* action : actions)
    if (bare(action->text()) == title) return action;
  throw std::runtime_error("no menu entry " + title.toStdString());
}

// An X server without a window manager activates nothing by itself.
void bringToFront(QWidget& window) {
  if (QApplication::activeWindow() == &window || QApplication::activePopupWidget()) return;
  window.activateWindow();
  QApplication::setActiveWindow(&window);
}

}  // namespace

void press(QWidget& window, int key, Qt::KeyboardModifiers modifiers) {
  bringToFront(window);
  QTest::keyClick(window.windowHandle(), static_cast<Qt::Key>(key), modifiers);
}

void type(QWidget& window, const QString& text) {
  bringToFront(window);
  for (const QChar character : text) QTest::keyClick(window.windowHandle(), character.toLatin1());
}

void click(QWidget& target) {
  QWidget& window = *target.window();
  bringToFront(window);
  const QPoint location = target.mapTo(&window, target.rect().center());
  const QWidget* hit = window.childAt(location);
  if (hit != &target && !target.isAncestorOf(hit))
    throw std::runtime_error(target.objectName().toStdString() + " cannot be reached with the mouse");
  QTest::mouseClick(window.windowHandle(), Qt::LeftButton, {}, location);
}

void drag(QWidget& target, const QPoint& from, const QPoint& to) {
  QWidget& window = *target.window();
  bringToFront(window);
  const auto location = [&](double share) {
    return target.mapTo(&window, (QPointF(from) * (1 - share) + QPointF(to) * share).toPoint());
  };
  QTest::mousePress(window.windowHandle(), Qt::LeftButton, {}, location(0));
  for (const double share : {0.25, 0.5, 0.75, 1.0}) QTest::mouseMove(window.windowHandle(), location(share));
  QTest::mouseRelease(window.windowHandle(), Qt::LeftButton, {}, location(1));
}

// Only what comes from the window system goes on to parents.
void turnWheel(QWidget& target) {
  const QPointF centre = QRectF(target.rect()).center();
  QWheelEvent turn(centre, target.mapToGlobal(centre), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                   false);
  QSpontaneKeyEvent::setSpontaneous(&turn);
  qApp->notify(&target, &turn);
}

void clickMenu(QWidget& window, const QStringList& titles) {
  bringToFront(window);
  auto* bar = dynamic_cast<QMainWindow&>(window).menuBar();
  QAction* action = entry(bar->actions(), titles.first());
  QTest::mouseClick(window.windowHandle(), Qt::LeftButton, {},
                    bar->mapTo(&window, bar->actionGeometry(action).center()));
  for (int i = 1; i < titles.size(); ++i) {
    QMenu* menu = action->menu();
    if (!menu || !QTest::qWaitFor([&] { return menu->isVisible(); })) throw std::runtime_error("the menu stays shut");
    action = entry(menu->actions(), titles[i]);
    QTest::mouseMove(menu->windowHandle(), menu->actionGeometry(action).center());
    QTest::mouseClick(menu->windowHandle(), Qt::LeftButton, {}, menu->actionGeometry(action).center());
  }
}

struct FileDialogTyping::Watch {
  QTimer timer;
  QString path;
  bool done = false;
};

// Return is pressed until the dialog has gone: the first one may only take the entry that the list of completions
// offers, where that came up in the meantime.
FileDialogTyping::FileDialogTyping(const QString& path) : watch_(std::make_unique<Watch>()) {
  watch_->path = path;
  QObject::connect(&watch_->timer, &QTimer::timeout, [watch = watch_.get()] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    auto* line = dialog ? dialog->findChild<QLineEdit*>("fileNameEdit") : nullptr;
    if (!line || !line->isVisible()) {
      if (watch->done) watch->timer.stop();
      return;
    }
    if (!watch->done) {
      bringToFront(*dialog);
      if (!line->hasFocus()) return;
      watch->done = true;
      press(*dialog, Qt::Key_A, Qt::ControlModifier);
      type(*dialog, watch->path);
    }
    press(*dialog, Qt::Key_Return);
  });
  watch_->timer.start(lookEvery);
}

FileDialogTyping::~FileDialogTyping() = default;

bool FileDialogTyping::done() const { return watch_->done; }

struct BoxAnswer::Watch {
  QTimer timer;
  QString button, question;
  bool done = false;
};

BoxAnswer::BoxAnswer(const QString& button) : watch_(std::make_unique<Watch>()) {
  watch_->button = button;
  QObject::connect(&watch_->timer, &QTimer::timeout, [watch = watch_.get()] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box || !box->isVisible()) return;
    for (QAbstractButton* each : box->buttons()) {
      if (bare(each->text()) != watch->button) continue;
      watch->timer.stop();
      watch->done = true;
      watch->question = box->text();
      click(*each);
      return;
    }
  });
  watch_->timer.start(lookEvery);
}

BoxAnswer::~BoxAnswer() = default;

bool BoxAnswer::done() const { return watch_->done; }

QString BoxAnswer::question() const { return watch_->question; }

}  // namespace squat::tests

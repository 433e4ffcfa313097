#include "studio/tools/ToolTabs.h"

#include <QCoreApplication>
#include <QEvent>
#include <QIcon>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QShortcut>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>

#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

constexpr QSize sizeOfTools(1180, 880), dotSize(8, 8);
constexpr const char *orderKey = "tools/order", *detachedKey = "tools/detached", *toolsGeometryKey = "tools/geometry";
constexpr const char* placeKeys = "Ctrl+Shift+D";

QString toolName(const QWidget* page) {
  const auto* tool = qobject_cast<const ToolWindow*>(page);
  return tool ? tool->form()->name() : QString();
}

// Beside its options, as before there were tabs.
QString geometryKeyOf(const ToolWindow& tool) { return QStringLiteral("tools/%1/geometry").arg(toolName(&tool)); }

void keepGeometryOf(const ToolWindow& tool) { QSettings().setValue(geometryKeyOf(tool), tool.saveGeometry()); }

// Takes the same room in every colour, so that the tabs stay where they are.
QIcon dotIcon(const QColor& colour) {
  constexpr int fineness = 2;  // for screens of double resolution
  QPixmap picture(dotSize * fineness);
  picture.setDevicePixelRatio(fineness);
  picture.fill(Qt::transparent);
  {
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(QRect(QPoint(0, 0), dotSize));
  }
  return QIcon(picture);
}

void bringForward(QWidget& window) {
  if (window.isMinimized()) window.setWindowState(window.windowState() & ~Qt::WindowMinimized);
  window.show();
  window.raise();
  window.activateWindow();
}

}  // namespace

ToolTabs::ToolTabs(QWidget* parent) : QWidget(parent, Qt::Window), tabs_(new QTabWidget(this)) {
  setObjectName("toolTabs");
  tabs_->setDocumentMode(true);
  tabs_->setMovable(true);
  tabs_->setTabsClosable(true);
  tabs_->setIconSize(dotSize);
  tabs_->setAccessibleName(tr("Tools"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(tabs_);
  connect(tabs_, &QTabWidget::currentChanged, this, &ToolTabs::showTitle);
  connect(tabs_, &QTabWidget::tabCloseRequested, this, [this](int at) { tabs_->widget(at)->close(); });
  connect(tabs_, &QTabWidget::tabBarDoubleClicked, this, [this](int at) {
    const QPointer<ToolWindow> tool = qobject_cast<ToolWindow*>(tabs_->widget(at));
    QTimer::singleShot(0, this, [this, tool] {  // once the bar has done with the click
      if (tool && !tool->isWindow()) detach(*tool);
    });
  });
  connect(tabs_->tabBar(), &QTabBar::tabMoved, this, &ToolTabs::takeOrder);
  connect(new QShortcut(QKeySequence("Ctrl+PgDown"), this), &QShortcut::activated, this, [this] { step(1); });
  connect(new QShortcut(QKeySequence("Ctrl+PgUp"), this), &QShortcut::activated, this, [this] { step(-1); });
  const QSettings settings;
  order_ = settings.value(orderKey).toStringList();
  detached_ = settings.value(detachedKey).toStringList();
  resize(sizeOfTools.boundedTo(screen()->availableSize()));
  restoreGeometry(settings.value(toolsGeometryKey).toByteArray());
  showTitle();
}

// While the members are still there: pages that go tell the tabs. Hidden, so that the next page does not begin to show
// itself.
ToolTabs::~ToolTabs() {
  hide();
  keep();
  tabs_->disconnect(this);
  tabs_->tabBar()->disconnect(this);
  for (const auto& tool : tools_) {
    if (!tool) continue;
    if (tool->isWindow()) keepGeometryOf(*tool);
    tool->removeEventFilter(this);
    tool->disconnect(this);
    delete tool.data();
  }
}

void ToolTabs::add(ToolWindow* tool) {
  tool->setParent(this);
  auto* place = new QPushButton(tool);
  place->setObjectName("toolPlace");
  tool->setCorner(place);
  tool->installEventFilter(this);
  // Queued: the button goes with the tool from window to window.
  const auto change = [this, tool] {
    if (isDetached(*tool))
      attach(*tool);
    else
      detach(*tool);
  };
  connect(place, &QPushButton::clicked, this, change, Qt::QueuedConnection);
  connect(tool, &ToolWindow::progressed, this, [this, tool] { showProgress(*tool); });
  tools_.emplace_back(tool);
  showPlace(*tool);
}

void ToolTabs::open(ToolWindow& tool) {
  if (isDetached(tool)) return showAlone(tool);
  if (tabs_->indexOf(&tool) < 0) insert(tool);
  tabs_->setCurrentWidget(&tool);
  tool.show();
  bringForward(*this);
}

void ToolTabs::detach(ToolWindow& tool) {
  if (!isDetached(tool)) detached_ << toolName(&tool);
  remove(tool);
  showAlone(tool);
  keep();
}

void ToolTabs::attach(ToolWindow& tool) {
  detached_.removeAll(toolName(&tool));
  tool.hide();
  tool.setParent(this);
  showPlace(tool);
  open(tool);
  keep();
}

void ToolTabs::reset() {
  detached_.clear();
  bool anyShown = isVisible();
  for (const auto& tool : tools_) {
    if (!tool || !tool->isWindow()) continue;
    const bool shown = tool->isVisible();
    tool->hide();
    tool->setParent(this);
    showPlace(*tool);
    if (shown) insert(*tool);
    anyShown = anyShown || shown;
  }
  setVisible(anyShown);
  QSettings settings;
  settings.beginGroup("tools");
  for (const QString& name : settings.childGroups()) settings.remove(name + "/geometry");
  keep();
}

bool ToolTabs::isDetached(const ToolWindow& tool) const { return detached_.contains(toolName(&tool)); }

bool ToolTabs::isOpen(const ToolWindow& tool) const {
  return tool.isWindow() ? tool.isVisible() : isVisible() && tabs_->indexOf(&tool) >= 0;
}

// At the place that it has in the order.
void ToolTabs::insert(ToolWindow& tool) {
  const QString name = toolName(&tool);
  if (!order_.contains(name)) order_ << name;
  int at = 0;
  while (at < tabs_->count() && order_.indexOf(toolName(tabs_->widget(at))) < order_.indexOf(name)) ++at;
  tabs_->insertTab(at, &tool, dotIcon(Qt::transparent), tool.form()->shortTitle());
  showProgress(tool);
  keep();
}

void ToolTabs::remove(ToolWindow& tool) {
  if (const int at = tabs_->indexOf(&tool); at >= 0) tabs_->removeTab(at);
  tool.hide();
  if (tabs_->count() == 0) hide();
}

// A detached tool belongs to the window that these tabs belong to: it does not go when they do.
void ToolTabs::showAlone(ToolWindow& tool) {
  if (!tool.isWindow()) {
    tool.setParent(parentWidget(), Qt::Window);
    tool.resize(tool.usualSize());
    tool.restoreGeometry(QSettings().value(geometryKeyOf(tool)).toByteArray());
    showPlace(tool);
  }
  bringForward(tool);
}

// The text takes the keys away, so they come after it.
void ToolTabs::showPlace(const ToolWindow& tool) {
  auto* place = tool.findChild<QPushButton*>("toolPlace");
  place->setText(isDetached(tool) ? tr("Attach") : tr("Detach"));
  place->setShortcut(QKeySequence(placeKeys));
  const QString tip = isDetached(tool) ? tr("Make this tool a tab of the window of tools (%1)")
                                       : tr("Give this tool a window of its own (%1)");
  place->setToolTip(tip.arg(placeKeys));
}

void ToolTabs::showProgress(const ToolWindow& tool) {
  const int at = tabs_->indexOf(&tool);
  if (at < 0) return;
  const QString progress = tool.progress(), title = tool.form()->title();
  tabs_->setTabIcon(at, dotIcon(progress.isEmpty() ? Qt::transparent : palette().color(QPalette::Highlight)));
  tabs_->setTabToolTip(at, progress.isEmpty() ? title : tr("%1: %2").arg(title, progress));
  tabs_->tabBar()->setAccessibleTabName(at, progress.isEmpty() ? title : tr("%1, computing").arg(title));
}

void ToolTabs::showTitle() {
  const QWidget* page = tabs_->currentWidget();
  setWindowTitle(page ? page->windowTitle() : tr("Tools - Squat Studio"));
}

void ToolTabs::step(int by) {
  if (const int count = tabs_->count(); count > 0) tabs_->setCurrentIndex((tabs_->currentIndex() + by + count) % count);
}

// The tabs that are there have changed places among each other.
void ToolTabs::takeOrder() {
  QStringList now;
  for (int at = 0; at < tabs_->count(); ++at) now << toolName(tabs_->widget(at));
  int next = 0;
  for (QString& name : order_)
    if (now.contains(name)) name = now[next++];
  keep();
}

void ToolTabs::keep() const {
  QSettings settings;
  settings.setValue(orderKey, order_);
  settings.setValue(detachedKey, detached_);
}

// A tab is closed as a window is: the tool in it is asked to close.
bool ToolTabs::eventFilter(QObject* watched, QEvent* event) {
  auto* tool = qobject_cast<ToolWindow*>(watched);
  if (tool && tool->isWindow() && event->type() == QEvent::Hide) keepGeometryOf(*tool);
  if (!tool || tool->isWindow() || event->type() != QEvent::Close) return QWidget::eventFilter(watched, event);
  remove(*tool);
  return true;
}

void ToolTabs::hideEvent(QHideEvent* event) {
  QSettings().setValue(toolsGeometryKey, saveGeometry());
  QWidget::hideEvent(event);
}

// Qt tells windows alone.
void ToolTabs::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::ActivationChange) return;
  if (QWidget* page = tabs_->currentWidget()) QCoreApplication::sendEvent(page, event);
}

}  // namespace squat::studio

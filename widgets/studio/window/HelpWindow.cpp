#include "studio/window/HelpWindow.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTextBrowser>
#include <QToolBar>

#include "case/ShippedCases.h"

namespace squat::studio {
namespace {

bool isIndex(const QString& page) {
  const QString name = QFileInfo(page).completeBaseName().toLower();
  return name == "index" || name == "contents";
}

// The first heading, else the name of the file.
QString titleOf(const QString& page) {
  QFile file(page);
  constexpr int linesLookedAt = 40;  // a picture or badges may stand above the heading
  if (file.open(QIODevice::ReadOnly))
    for (int i = 0; i < linesLookedAt && !file.atEnd(); ++i) {
      const QString line = QString::fromUtf8(file.readLine()).trimmed();
      if (line.startsWith("# ")) return line.mid(2).trimmed();
    }
  return QFileInfo(page).completeBaseName().replace('-', ' ');
}

QString listOf(const QStringList& pages) {
  QString text = QObject::tr("# Squat Studio: help\n\n");
  for (const QString& page : pages)
    text += QStringLiteral("- [%1](%2)\n").arg(titleOf(page), QUrl::fromLocalFile(page).toString(QUrl::FullyEncoded));
  if (pages.isEmpty())
    text += QObject::tr(
        "No manual pages are installed beside this program. `squat --help` lists the commands, "
        "`squat describe` all parameters; in this window every control has a tooltip.\n");
  return text;
}

}  // namespace

QStringList helpPages() {
  const QString resources = QString::fromStdString(cases::resourcesFolder().string());
  if (resources.isEmpty()) return {};
  QStringList pages;
  const auto found = QDir(resources + "/manual").entryInfoList({"*.md"}, QDir::Files, QDir::Name);
  for (const QFileInfo& page : found) pages << page.absoluteFilePath();
  // Installed: share/squat-studio and share/doc/squat-studio; in the source tree: resources and what it stands in.
  for (const char* location : {"/../doc/squat-studio/README.md", "/../README.md"})
    if (const QFileInfo readme(resources + location); readme.isFile()) {
      pages << QDir::cleanPath(readme.absoluteFilePath());
      break;
    }
  return pages;
}

HelpWindow::HelpWindow(const QStringList& pages, QWidget* parent)
    : QMainWindow(parent), pages_(pages), browser_(new QTextBrowser(this)) {
  setWindowTitle(tr("Squat Studio: help"));
  setObjectName("helpWindow");
  setAttribute(Qt::WA_DeleteOnClose);
  browser_->setAccessibleName(tr("Help page"));
  browser_->setOpenExternalLinks(true);
  setCentralWidget(browser_);
  auto* bar = addToolBar(tr("Navigation"));
  bar->setObjectName("helpNavigation");
  bar->setMovable(false);
  bar->addAction(tr("Contents"), this, &HelpWindow::showIndex)->setShortcut(QKeySequence("Alt+Home"));
  QAction* back = bar->addAction(tr("Back"), browser_, &QTextBrowser::backward);
  QAction* forward = bar->addAction(tr("Forward"), browser_, &QTextBrowser::forward);
  back->setShortcut(QKeySequence::Back);
  forward->setShortcut(QKeySequence::Forward);
  back->setEnabled(false);
  forward->setEnabled(false);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
  connect(browser_, &QTextBrowser::forwardAvailable, forward, &QAction::setEnabled);
  resize(860, 720);
  showIndex();
}

void HelpWindow::showIndex() {
  for (const QString& page : pages_)
    if (isIndex(page)) return browser_->setSource(QUrl::fromLocalFile(page));
  browser_->setSource(QUrl());
  browser_->setMarkdown(listOf(pages_));
}

}  // namespace squat::studio

#include "studio/window/HelpWindow.h"

#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolBar>

#include "case/ShippedCases.h"
#include "studio/window/HelpSearch.h"
#include "text/HeadingAnchor.h"

namespace squat::studio {
namespace {

constexpr const char* searchScheme = "search";  // what a search has found is a page of its own: Back leads to it

// The manual's own, resources/manual/README.md.
bool isIndex(const QString& page) {
  const QFileInfo file(page);
  const QString name = file.completeBaseName().toLower();
  return name == "index" || name == "contents" || (name == "readme" && file.dir().dirName() == "manual");
}

// Reads the same as Markdown and as HTML.
QString missingPage(const QString& path) {
  return QObject::tr(
             "The page “%1” is not there: the build writes it (target pages). In this window F1 and the tool tips "
             "explain each key; squat describe lists them all.")
      .arg(QFileInfo(path).completeBaseName());
}

// Pages by the links of Markdown: Qt does not know the anchors of headings, and what the build writes or installs
// elsewhere (reference pages, README) does not stand where a link says, but bears that name.
class PageBrowser : public QTextBrowser {
 public:
  PageBrowser(const QStringList& pages, QWidget* parent) : QTextBrowser(parent), pages_(pages) {}

 protected:
  void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override {
    QTextBrowser::doSetSource(found(url), type);
    nameHeadings();
    if (url.hasFragment()) scrollToAnchor(url.fragment());
  }

  QVariant loadResource(int type, const QUrl& name) override {
    if (name.scheme() == searchScheme) return listOfMatches(pages_, name.path());
    const QUrl url = found(name);
    const QString path = url.toLocalFile();
    const bool isText = type == QTextDocument::HtmlResource && !path.endsWith(".html");
    QFile file(path);
    const bool isPage = type == QTextDocument::MarkdownResource || type == QTextDocument::HtmlResource;
    if (isPage && !path.isEmpty() && !file.exists()) return missingPage(path);
    if (isText && file.open(QIODevice::ReadOnly))  // an example that a page links to
      return QStringLiteral("<pre>%1</pre>").arg(QString::fromUtf8(file.readAll()).toHtmlEscaped());
    return QTextBrowser::loadResource(type, url);
  }

 private:
  QUrl found(const QUrl& url) const {
    const QString path = url.toLocalFile();
    if (path.isEmpty() || QFile::exists(path)) return url;
    QUrl other = url;
    const auto at = path.indexOf("/resources/");  // as the README names pictures and pages
    if (const QString resources = QString::fromStdString(cases::resourcesFolder().string());
        at >= 0 && QFile::exists(resources + path.mid(at + 10)))
      other.setPath(resources + path.mid(at + 10));
    else
      for (const QString& page : pages_)
        if (QFileInfo(page).fileName() == QFileInfo(path).fileName() && !isIndex(page)) other.setPath(page);
    return other;
  }

  void nameHeadings() {
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
      if (block.blockFormat().headingLevel() == 0 || block.length() < 2) continue;
      QTextCursor cursor(block);
      cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
      QTextCharFormat name;
      name.setAnchor(true);
      name.setAnchorNames({QString::fromStdString(text::headingAnchor(block.text().toStdString()))});
      cursor.mergeCharFormat(name);
    }
  }

  const QStringList pages_;
};

QString listOf(const QStringList& pages) {
  QString text = QObject::tr("# Squat Studio: help\n\n");
  for (const QString& page : pages)
    text +=
        QStringLiteral("- [%1](%2)\n").arg(titleOfPage(page), QUrl::fromLocalFile(page).toString(QUrl::FullyEncoded));
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
  // What the build writes: installed it stands among the others, else beside the program.
  const QDir built(QCoreApplication::applicationDirPath() + "/../pages/manual");
  for (const QFileInfo& page : built.entryInfoList({"*.md"}, QDir::Files, QDir::Name))
    if (!QFile::exists(resources + "/manual/" + page.fileName())) pages << QDir::cleanPath(page.absoluteFilePath());
  // Installed: share/squat-studio and share/doc/squat-studio; in the source tree: resources and what it stands in.
  for (const char* name : {"CHANGELOG.md", "CONTRIBUTING.md", "README.md"})
    for (const char* location : {"/../doc/squat-studio/", "/../"})
      if (const QFileInfo text(resources + location + name); text.isFile()) {
        pages << QDir::cleanPath(text.absoluteFilePath());
        break;
      }
  return pages;
}

HelpWindow::HelpWindow(const QStringList& pages, QWidget* parent)
    : QMainWindow(parent), pages_(pages), browser_(new PageBrowser(pages, this)), search_(new QLineEdit(this)) {
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
  makeSearch(*bar);
  resize(860, 720);
  browser_->setFocus();  // keys scroll what is read
  showIndex();
}

void HelpWindow::makeSearch(QToolBar& bar) {
  search_->setObjectName("helpSearch");
  search_->setAccessibleName(tr("Search the pages"));
  search_->setPlaceholderText(tr("Search (Ctrl+F)"));
  search_->setToolTip(tr("Words that a page must hold; Return lists the pages"));
  search_->setClearButtonEnabled(true);
  search_->setMinimumWidth(120);
  search_->setMaximumWidth(320);
  QAction* find = bar.addWidget(search_);
  find->setText(tr("Search"));
  find->setShortcut(QKeySequence::Find);
  connect(find, &QAction::triggered, search_, [this] {
    search_->setFocus();
    search_->selectAll();
  });
  connect(search_, &QLineEdit::returnPressed, this, [this] { search(search_->text()); });
  connect(search_, &QLineEdit::textChanged, this, &HelpWindow::markMatches);
  connect(browser_, &QTextBrowser::sourceChanged, this, &HelpWindow::markMatches);
  setTabOrder(search_, browser_);
}

void HelpWindow::search(const QString& words) {
  const QString sought = words.simplified();
  if (sought.isEmpty()) return showIndex();
  search_->setText(sought);
  QUrl url;
  url.setScheme(searchScheme);
  url.setPath(sought);
  browser_->setSource(url, QTextDocument::HtmlResource);
  browser_->setFocus();  // Tab goes to the first page
}

// In every page that is shown, until the words are gone from the field.
void HelpWindow::markMatches() {
  QList<QTextEdit::ExtraSelection> marks;
  QTextCharFormat look;
  look.setBackground(palette().color(QPalette::Highlight));
  look.setForeground(palette().color(QPalette::HighlightedText));
  constexpr qsizetype fewestLetters = 3;  // of a word: below, half the page would be marked
  const auto words = search_->text().split(' ', Qt::SkipEmptyParts);
  for (const QString& word : words) {
    if (word.size() < fewestLetters) continue;
    QTextCursor at(browser_->document());
    while (!(at = browser_->document()->find(word, at)).isNull()) marks.push_back({at, look});
  }
  browser_->setExtraSelections(marks);
}

void HelpWindow::showIndex() {
  for (const QString& page : pages_)
    if (isIndex(page)) return browser_->setSource(QUrl::fromLocalFile(page));
  browser_->setSource(QUrl());
  browser_->setMarkdown(listOf(pages_));
}

void HelpWindow::showPage(const QString& target) {
  const QString name = target.section('#', 0, 0);
  for (const QString& page : pages_)
    if (QFileInfo(page).fileName() == name && !isIndex(page)) {
      QUrl url = QUrl::fromLocalFile(page);
      if (target.contains('#')) url.setFragment(target.section('#', 1));
      return browser_->setSource(url);
    }
  browser_->setSource(QUrl::fromLocalFile("/" + name));  // it is missing, and the browser says so
}

}  // namespace squat::studio

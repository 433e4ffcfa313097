// widgets/studio/window/HelpWindow.h - the installed manual pages in a window of their own.
#pragma once

#include <QMainWindow>
#include <QStringList>

class QLineEdit;
class QTextBrowser;
class QToolBar;

namespace squat::studio {

// Markdown pages that are installed with the program: the manual, then changelog, the text for developers and README.
// Empty: none found.
QStringList helpPages();

// Shows the index first: the manual's own, or the list of all pages. Links between pages, also to a heading, stay in
// the window.
class HelpWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit HelpWindow(const QStringList& pages, QWidget* parent = nullptr);

  QTextBrowser* browser() const { return browser_; }
  void showIndex();
  // "studio.md" or "studio.md#runs"; the index where there is no such page.
  void showPage(const QString& target);
  void search(const QString& words);  // lists the pages that hold all of them

 private:
  void makeSearch(QToolBar& bar);
  void markMatches();

  QStringList pages_;
  QTextBrowser* browser_;
  QLineEdit* search_;
};

}  // namespace squat::studio

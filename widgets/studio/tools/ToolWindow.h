// widgets/studio/tools/ToolWindow.h - a tool: options, progress, what came out as text and figures. A tab or a window.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "plots/FigureSheet.h"
#include "plots/Style.h"
#include "studio/runs/BackgroundJob.h"
#include "studio/tools/ToolForm.h"

class QBoxLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTabWidget;

namespace squat::studio {

class CaseDocument;
class MessageBar;

// Computes in a thread of its own; the rest of the studio stays usable. What comes out is written into the folder as
// the command writes it, figures included, and shown here.
class ToolWindow : public QWidget {
  Q_OBJECT
 public:
  // Takes what is being typed elsewhere; returns why the case cannot be computed, empty: it can.
  using Blocker = std::function<QString()>;
  ToolWindow(CaseDocument& document, ToolForm* form, Blocker blocker, const plots::Style& style,
             QWidget* parent = nullptr);
  ~ToolWindow() override;

  ToolForm* form() const { return form_; }
  void setFolder(const QString& folder);
  void setProject(const QString& path);  // files go beside it, unless the user has named a folder; empty: there is none
  void start();
  void cancel();
  QString progress() const { return progressText_; }  // "43 %, 1 min left"; empty: it computes nothing
  bool isComputing() const { return job_.isRunning(); }
  bool isBusy() const { return job_.isRunning() || !toWrite_.empty(); }  // computes, or writes its figures
  bool waitFor(int milliseconds);  // runs the event loop until it is no longer busy
  QString text() const;            // what came out
  MessageBar* messages() const { return messages_; }
  void setStyle(const plots::Style& style);
  void setCorner(QWidget* corner);  // shown at the top, at the right
  QSize usualSize() const;          // of a window of its own

 Q_SIGNALS:
  void progressed();  // progress() has changed
  void caseFound(const QString& path);
  void openCaseRequested(const QString& path);
  void resultsKept(const std::vector<std::pair<std::string, std::string>>& namedFiles);
  void runRequested(const QString& file, const QString& name);
  void helpRequested();
  void ended();  // whether it was finished, cancelled or failed; its files are written

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeOptions();
  QWidget* makeBar();
  void makeResults();
  QString usualFolder() const;
  void showCase();
  void showNextStep();
  void askForFolder();
  void showState();
  void showNews(const WorkerMonitor::News& news);
  void conclude(const std::exception_ptr& error);
  void refuse(const QString& reason, const QString& details = {});
  void showFigures();
  void takeFigureSize();
  void writeNext();
  void saveOptions() const;
  void finish();

  CaseDocument& document_;
  ToolForm* form_;
  Blocker blocker_;
  plots::Style style_;
  MessageBar* messages_;
  QBoxLayout* head_;
  QLabel *state_, *case_;
  QLineEdit* folder_;
  QPushButton *start_, *cancel_, *openCase_, *openFolder_;
  QProgressBar* progress_;
  QTabWidget* tabs_;
  QPlainTextEdit *text_, *log_;
  std::shared_ptr<ToolResult> result_;
  std::vector<plots::FigureSheet> toWrite_;  // the last one first
  QString writtenTo_, project_;
  QString refusal_;  // of the options as they stood
  QString progressText_;
  int ownTabs_ = 0;         // before those of the figures
  bool ownFolder_ = false;  // the user has named it
  BackgroundJob job_;       // the last one: its thread uses what stands above
};

}  // namespace squat::studio

// widgets/studio/tools/ToolForm.h - what differs between the tools that compute many runs, or none, of the open case:
// their options, and the work that follows from them.
#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "case/CaseDescription.h"
#include "core/Monitor.h"
#include "plots/FigureSheet.h"
#include "plots/Style.h"

class QSettings;

namespace squat::studio {

// What a tool works on: the case as it stands in the window.
struct ToolInput {
  std::string name;  // of the case
  cases::CaseDescription description;
  std::string folder;              // of all that is written
  std::vector<std::string> files;  // that the case is from, which nothing may replace
  // What stands so far, as a call that shows it in the form's view, in the window's thread: it holds values of its own,
  // which nobody changes. Called in any thread of the work; of what was not shown yet, only the last one counts.
  std::function<void(const std::function<void()>&)> show = [](const std::function<void()>&) {};
};

struct ToolResult {
  bool complete = false;           // false: cancelled; the text says what is known so far
  std::string text;                // as the command prints it
  std::vector<std::string> files;  // written
  // Drawn in the window's thread.
  std::function<std::vector<plots::FigureSheet>(const plots::Style&)> figures;
  std::function<std::vector<plots::FigureSheet>(const plots::Style&)> shownFigures;  // in the window; empty: all
  std::function<void()> show;  // in the form's view, in the window's thread; empty: nothing
  std::string fate;            // cancelled: what becomes of it; empty: the form's own words
  std::string foundCase;       // the file of a case that was found; empty: none
  std::vector<std::pair<std::string, std::string>> results;  // files of runs for the list, and their names there
};

// Called in a thread of its own; throws what its command throws.
using ToolWork = std::function<ToolResult(const ToolInput&, Monitor&)>;

class ToolForm : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;

  virtual QString name() const = 0;   // "study": of its folder, its settings and its page of the manual
  virtual QString title() const = 0;  // of its window
  virtual QString shortTitle() const { return title(); }  // of its tab
  virtual QString explanation() const = 0;
  virtual QString subject() const = 0;  // of a sentence: "The study"
  // What becomes of it when it is stopped.
  virtual QString fate() const { return tr("To resume it, start it again in the same folder."); }
  // From the options as they stand. What is wrong with them is found by the work, as by the command.
  virtual ToolWork work() = 0;
  virtual QString missing() const { return {}; }     // what is not chosen yet, as a sentence; empty: nothing
  virtual bool usesCase() const { return true; }     // else a case that cannot be run does not matter
  virtual QWidget* view() const { return nullptr; }  // what stands beside text and figures, from the start on
  virtual QString viewTitle() const { return {}; }   // of the view's tab
  virtual void setStyle(const plots::Style&) {}
  virtual void showCase(const cases::CaseDescription&) {}  // whose values stand beside the options
  virtual void save(QSettings&) const {}
  virtual void restore(const QSettings&) {}
  virtual void conclude() {}  // it was finished, cancelled or failed

 Q_SIGNALS:
  void failed(const QString& problem);
  void noted(const QString& note);                              // shown until an option changes
  void runRequested(const QString& file, const QString& name);  // a result that the main window shows
  void edited();  // an option has changed: a message about the one before is out of date
};

// Writes the case as FOLDER/case/NAME.toml and returns its path: the tool reads it from there, so that edits meanwhile
// change nothing, and the command can resume in the folder. Throws CaseError where `table`, the tool's own file, stands
// in the folder and was computed from another case (empty: the tool never resumes); FileError.
std::string keepCase(const ToolInput& input, const std::string& table);

}  // namespace squat::studio

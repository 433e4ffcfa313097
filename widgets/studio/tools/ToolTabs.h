// widgets/studio/tools/ToolTabs.h - one window for all tools: each is a tab, or a window of its own once it is
// detached.
#pragma once

#include <QPointer>
#include <QStringList>
#include <QWidget>
#include <vector>

class QTabWidget;

namespace squat::studio {

class ToolWindow;

// Remembers the order of the tabs, which tools are detached, and where the windows stand. A tool whose tab or window is
// closed computes on.
class ToolTabs : public QWidget {
  Q_OBJECT
 public:
  explicit ToolTabs(QWidget* parent = nullptr);
  ~ToolTabs() override;

  void add(ToolWindow* tool);   // owned from now on, and not seen before it is opened
  void open(ToolWindow& tool);  // brings it to the front: its tab, or its window
  void detach(ToolWindow& tool);
  void attach(ToolWindow& tool);
  void reset();  // all detached tools become tabs, and it is forgotten where their windows stood
  bool isDetached(const ToolWindow& tool) const;
  bool isOpen(const ToolWindow& tool) const;  // it can be seen, perhaps behind another tab

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void insert(ToolWindow& tool);  // its tab
  void remove(ToolWindow& tool);
  void showAlone(ToolWindow& tool);
  void showPlace(const ToolWindow& tool);
  void showProgress(const ToolWindow& tool);
  void showTitle();
  void step(int by);
  void takeOrder();
  void keep() const;

  QTabWidget* tabs_;
  std::vector<QPointer<ToolWindow>> tools_;
  QStringList order_, detached_;  // names of tools; those without a tab keep their place in the order
};

}  // namespace squat::studio

// widgets/studio/window/PaperPanel.h - what the current run found, beside what the paper states.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "studio/runs/RunStore.h"

class QLabel;
class QTableWidget;

namespace squat::studio {

struct ComparedRow {
  QString what, ours, paper, verdict;
};
using Comparison = std::function<std::vector<ComparedRow>(const results::RunResult&)>;

class PaperPanel : public QWidget {
  Q_OBJECT
 public:
  PaperPanel(RunStore& store, Comparison comparison, QWidget* parent = nullptr);

 private:
  void update();
  RunStore& store_;
  Comparison comparison_;
  QLabel* title_;
  QTableWidget* table_;
};

}  // namespace squat::studio

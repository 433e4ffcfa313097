// widgets/studio/records/EventInspector.h - one event of a long record: its kind, its ranges, its signal and its
// scalogram.
#pragma once

#include <QWidget>

#include "detection/DetectionFiles.h"
#include "plots/Style.h"

class QHBoxLayout;
class QLabel;
class QStackedWidget;

namespace squat::studio {

class EventInspector : public QWidget {
  Q_OBJECT
 public:
  explicit EventInspector(const plots::Style& style, QWidget* parent = nullptr);
  void inspect(const detection::CombinedEvent* event);  // null: none; copied
  void setStyle(const plots::Style& style);

 private:
  void draw();

  plots::Style style_;
  std::optional<detection::CombinedEvent> event_;
  QLabel* words_;
  QStackedWidget* pages_;
  QLabel* reason_;  // why there is no signal
  QHBoxLayout* figures_;
};

// "Squat 97 %: 34 mm (28 to 41), 0.21 mm deep (0.15 to 0.30); light 12 %, moderate 80 %, severe 8 %", or why it is
// none.
QString eventInWords(const detection::CombinedEvent& event);

}  // namespace squat::studio

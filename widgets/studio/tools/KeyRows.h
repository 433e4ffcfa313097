// widgets/studio/tools/KeyRows.h - keys of the case and a text for each: values of a study, limits of a calibration.
#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "case/ParameterTable.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace squat::studio {

class KeyRows : public QWidget {
  Q_OBJECT
 public:
  // What may be chosen, and how the text of a row is written: "20:60:5 or 20,35,60".
  KeyRows(const std::function<bool(const cases::Parameter&)>& mayVary, const QString& hint, QWidget* parent = nullptr);

  // "defect.length=20:60:5", one for each row with a key.
  std::vector<std::string> texts() const;
  void setTexts(const QStringList& texts);
  void showCase(const cases::CaseDescription& description);  // values beside the keys

 private:
  struct Row {
    QWidget* line;
    QComboBox* key;
    QLineEdit* text;
    QLabel* now;
  };
  void addRow(const QString& key, const QString& text);
  void removeRow(const QWidget* line);
  void showValue(const Row& row) const;

  QStringList keys_;
  QString hint_;
  cases::CaseDescription description_;
  std::vector<Row> rows_;
  QVBoxLayout* lines_;
};

}  // namespace squat::studio

// widgets/studio/tools/KeyRows.h - keys of the case and the values that a tool gives them, a row each.
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
class QSpinBox;
class QVBoxLayout;

namespace squat::studio {

// What a row asks for: two limits; or values, which are given by the first, the last and how many, or as a list with
// commas in "from".
enum class KeyValues { limits, values };

class KeyRows : public QWidget {
  Q_OBJECT
 public:
  KeyRows(const std::function<bool(const cases::Parameter&)>& mayVary, KeyValues values, QWidget* parent = nullptr);

  // "defect.length=20:60:5", "defect.shape=cut,cosine": one for each row with a key, as the command writes them.
  std::vector<std::string> texts() const;
  void setTexts(const QStringList& texts);
  std::vector<std::string> limits() const;  // "defect.length=20:60": without numbers of values
  void setCounted(bool counted);            // whether numbers of values are asked for
  // Number of combinations of all values; 0: a row is not complete.
  int combinations() const;
  void showCase(const cases::CaseDescription& description);  // values beside the keys

 Q_SIGNALS:
  void edited();

 private:
  struct Row {
    QWidget* line;
    QComboBox* key;
    QLineEdit *from, *to;
    QSpinBox* count;
    QLabel* now;
  };
  void addRow(const QString& key, const QString& values);
  void makeValues(Row& row);
  void removeRow(const QWidget* line);
  void showValue(const Row& row) const;
  std::string textOf(const Row& row, bool counted) const;
  static QString keyOf(const Row& row);

  QStringList keys_;
  KeyValues values_;
  bool counted_ = true;
  cases::CaseDescription description_;
  std::vector<Row> rows_;
  QVBoxLayout* lines_;
};

}  // namespace squat::studio

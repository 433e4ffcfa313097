// widgets/studio/document/ParameterForm.h - the form of all parameters, made from the one parameter table. In a whole
// model it has a row more for each that the right side may have of its own, and tabs for the sides.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QStringList>
#include <QTabBar>
#include <QToolButton>
#include <QWidget>
#include <vector>

#include "case/CaseDescription.h"
#include "core/Errors.h"

namespace squat::studio {

class CaseDocument;
class FixedLabel;
class ParameterRow;

class ParameterForm : public QWidget {
  Q_OBJECT
 public:
  explicit ParameterForm(CaseDocument& document, QWidget* parent = nullptr);
  ~ParameterForm() override;

  // One sentence for each reason why the case cannot be run; empty: it can.
  QStringList blockers() const;
  // Those of them that are texts which the case has not taken: what is seen is not what would be saved.
  QStringList refusals() const;
  // Marks what only a run could find, until the case changes.
  void mark(const std::vector<CaseProblem>& problems);
  ParameterRow* row(const std::string& key) const;  // "right.defect.depth" as well; nullptr: there is none
  const std::vector<ParameterRow*>& rows() const { return rows_; }

 Q_SIGNALS:
  void blockersChanged();

 private:
  struct Group {
    QToolButton* header;
    QWidget* body;
    std::vector<ParameterRow*> rows;
  };
  void makeGroups(QWidget* inside);
  void makeSides();
  void makeRightRows();
  bool isWhole() const;
  bool showsRight() const { return isWhole() && sides_->currentIndex() == 1; }
  void update();
  void makeLevels();
  bool isOfLevel(const ParameterRow& row) const;
  bool isNeeded(const ParameterRow& row) const;
  bool isWanted(const ParameterRow& row, const QString& searched) const;
  void takePresets();
  bool isStated(const ParameterRow& row) const;
  void filter();
  void showReason();

  CaseDocument& document_;
  QLineEdit* search_;
  QCheckBox* changedOnly_;
  FixedLabel* why_;   // what is wrong: of the row that has the focus, else of the first one
  QComboBox* level_;  // cases::Level: this one and those before it are shown
  QTabBar* sides_;    // of a whole model: what is seen of the rows of left and right
  std::vector<Group> groups_;
  std::vector<ParameterRow*> rows_;       // those of the right side last, from the first whole model on
  cases::CaseDescription presets_;        // what the presets of the case give where it states nothing else
  std::vector<std::string> presetNames_;  // of presets_
  QStringList unplaced_;                  // problems of keys without a row
};

}  // namespace squat::studio

// widgets/studio/document/ParameterRow.h - one parameter in the form: name, editor, unit, reset, and what is wrong with
// it. On the right side of a whole model it shows in grey what the left side has, until it has a value of its own.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QWidget>
#include <string>

#include "case/ParameterTable.h"

namespace squat::studio {

class CaseDocument;

enum class RowSide { left, right };  // left: also of what both sides have in common

class ParameterRow : public QWidget {
  Q_OBJECT
 public:
  ParameterRow(CaseDocument& document, const cases::Parameter& parameter, RowSide side, QWidget* parent = nullptr);

  const cases::Parameter& parameter() const { return parameter_; }
  const std::string& key() const { return key_; }  // on the right side "right.defect.depth"
  bool isOnRight() const { return side_ == RowSide::right; }
  QString label() const;
  bool isChanged() const { return changed_; }  // differs from the default; on the right side: the case states it
  bool isRefused() const { return !wrongText_.isEmpty(); }  // what stands in the editor is not what the case holds
  void dropRefused();
  // What stands in the editor and cannot be taken, else what validation says of the value; empty: nothing.
  QString reason() const { return wrongText_.isEmpty() ? relation_ : wrongText_; }

  void showValue();                             // from the document; a refused text stays while the value does
  void showRelation(const QString& reason);     // from validation
  bool matches(const QString& searched) const;  // key, label or documentation
  QWidget* editor() const { return editor_; }
  void followInTabOrder(const ParameterRow& row);

 Q_SIGNALS:
  void reasonChanged();

 protected:
  void changeEvent(QEvent* event) override;  // light and dark have greys of their own

 private:
  void makeEditor();
  void makeChoice();
  void makeReset();
  bool isAsLeft() const { return isOnRight() && !changed_; }
  const cases::CaseDescription& caseOfSide() const;
  QString withoutEffect() const;  // why the key has none; empty: it has one
  void reset();
  void showText();                    // in the editor
  void tryText(const QString& text);  // while typing: flags, changes nothing
  void commit(const QString& text);
  void showReason();
  void showEffect();  // greyed, with the reason, where the key has none
  QString toolTipText() const;

  CaseDocument& document_;
  const cases::Parameter& parameter_;
  RowSide side_;
  std::string key_;
  QWidget* editor_ = nullptr;
  QLineEdit* line_ = nullptr;
  QComboBox* choice_ = nullptr;
  QCheckBox* check_ = nullptr;
  QLabel* name_;
  QLabel* other_;
  QToolButton* reset_ = nullptr;
  QString wrongText_, relation_;
  std::string value_;  // of the document, as last seen; empty while it is as on the left
  bool changed_ = false;
};

}  // namespace squat::studio

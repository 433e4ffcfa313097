// widgets/studio/profile/EditedDefect.h - the defect that the profile editor shows: of a whole model that of one side.
#pragma once

#include <QObject>
#include <QString>
#include <string>

#include "case/CaseDescription.h"
#include "core/Errors.h"

namespace squat::studio {

class CaseDocument;

// The document as the parts of the editor see it. A half model has one side, the left one. What is changed on the right
// is stated there; all else of its defect stays as on the left.
class EditedDefect : public QObject {
  Q_OBJECT
 public:
  enum class Side { left, right };
  explicit EditedDefect(CaseDocument& document, QObject* parent = nullptr);

  bool hasBothSides() const;
  Side side() const { return side_; }
  void show(Side side);  // left where there is no other

  const cases::CaseDescription& description() const;  // the case with the defect of that side
  // As those of CaseDocument. Of `after` the defect counts alone on the right. A value that the case may not have
  // changes nothing; refused() says why.
  void edit(const QString& what, const cases::CaseDescription& after, int gesture = 0);
  void setParameter(const std::string& key, const std::string& text);
  int newGesture();

 Q_SIGNALS:
  void changed();   // description()
  void replaced();  // by that of another case or side
  void sidesChanged();
  void refused(const QString& reason);  // an edit, which has changed nothing

 private:
  void take();
  void refuse(const CaseProblem& problem);
  CaseDocument& document_;
  Side side_ = Side::left;
  bool hadBothSides_ = false;
};

}  // namespace squat::studio

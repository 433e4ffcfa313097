// widgets/studio/document/CaseDocument.h - the case that is being edited: every change can be undone.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>
#include <optional>

#include "case/CaseDescription.h"
#include "case/Validation.h"
#include "core/Errors.h"

namespace squat::studio {

class CaseDocument : public QObject {
  Q_OBJECT
 public:
  explicit CaseDocument(QObject* parent = nullptr);
  ~CaseDocument() override;

  const cases::CaseDescription& description() const { return *current_; }
  const cases::CaseDescription& right() const { return right_; }  // the case of the right side alone
  const cases::Validation& validation() const { return validation_; }
  QUndoStack& undoStack() { return undo_; }  // of the window: it may hold steps that do not concern the case
  QString path() const { return path_; }     // empty: never saved (shipped cases open as copies)
  QString name() const { return name_; }     // stem of results
  bool isModified() const { return current_ != saved_; }

  // These forget the changes before. open() takes a path or the name of a shipped case; throws CaseError, FileError and
  // leaves the document as it was.
  void startNew();
  void open(const QString& nameOrPath);
  void startFrom(const cases::CaseDescription& description, const QString& path, const QString& name, bool modified);

  // Throws CaseError, FileError.
  void save(const QString& path);

  // Text in the unit of the case file. A wrong text changes nothing and comes back as the problem. A new mesh preset
  // brings its sizes with it, except those that the user has set otherwise than the one before. "right.defect.depth" is
  // a key of the right side.
  std::optional<CaseProblem> setParameter(const std::string& key, const std::string& text);
  void resetParameter(const std::string& key);  // to the default; of the right side as on the left

  // One undoable change. Changes with the same gesture (not zero) become one: a drag, a slider.
  void edit(const QString& what, const cases::CaseDescription& after, int gesture = 0);
  int newGesture() { return ++lastGesture_; }

 Q_SIGNALS:
  void changed();                   // the description
  void replaced();                  // by that of another case: what belonged to the one before goes
  void noted(const QString& note);  // what an edit has changed besides what was edited
  void titleChanged();              // name, path or whether it is modified

 private:
  friend class CaseCommand;
  std::optional<CaseProblem> setOnRight(const std::string& key, const std::string& text);
  void notePreset();  // that it has shortened what is rolled
  void become(std::shared_ptr<const cases::CaseDescription> description);
  void notifyModified();

  std::shared_ptr<const cases::CaseDescription> current_;
  std::shared_ptr<const cases::CaseDescription> saved_;  // null: what is in the file is none of the steps
  bool notified_ = false;                                // isModified() when titleChanged() was last emitted
  cases::CaseDescription right_;
  cases::Validation validation_;
  QUndoStack undo_;
  QString path_, name_;
  int lastGesture_ = 0;
};

// True where both write the same case file.
bool sameCase(const cases::CaseDescription& a, const cases::CaseDescription& b);

}  // namespace squat::studio

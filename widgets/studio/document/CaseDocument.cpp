#include "studio/document/CaseDocument.h"

#include <QDir>
#include <QFileInfo>

#include "case/CaseFile.h"
#include "case/InputPresets.h"
#include "case/MeshPresets.h"
#include "case/NamedTables.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "case/ShippedCases.h"
#include "core/Errors.h"
#include "studio/document/CaseCommand.h"

namespace squat::studio {
namespace {

// Shipped cases are opened as copies: saving asks for a place.
bool isShipped(const QString& path) {
  const QString resources = QString::fromStdString(cases::resourcesFolder().string());
  return !resources.isEmpty() &&
         QFileInfo(path).canonicalFilePath().startsWith(QFileInfo(resources).canonicalFilePath() + "/");
}

// A case keeps the numbers of a table beside the name of the file that they are from. `folder` is that of the case.
std::optional<CaseProblem> readTable(cases::CaseDescription& description, const cases::NamedTable& table,
                                     const QDir& folder) {
  const std::string named = table.file(description);
  const auto path = folder.filePath(QString::fromStdString(named)).toStdString();
  try {
    table.read(description, path);
    return std::nullopt;
  } catch (const FileError& error) {
    return CaseProblem{table.fileKey, path, table.holds, error.what()};
  }
}

// What the change of a key asks for: the file that it names, or one that was named before and counts now.
std::optional<CaseProblem> readTables(cases::CaseDescription& after, const cases::CaseDescription& before,
                                      const std::string& key, const QDir& folder) {
  for (const auto& table : cases::namedTables()) {
    const bool isNamed = key == table.fileKey;
    if (isNamed && key != "defect.file") table.clear(after);  // a profile stays as it was drawn
    const bool nowWanted = table.isWanted(after) && !table.isWanted(before) && !table.isFilled(after);
    const bool named = isNamed && !table.file(after).empty() && (table.isWanted(after) || key == "defect.file");
    if (!named && !nowWanted) continue;
    if (auto problem = readTable(after, table, folder)) return problem;
  }
  return std::nullopt;
}

// The same of a key of the right side. What was read is stated for that side alone.
std::optional<CaseProblem> readTablesOnRight(cases::CaseDescription& after, const cases::CaseDescription& before,
                                             const std::string& key, const QDir& folder) {
  auto right = cases::rightOf(after);
  if (auto problem = readTables(right, before, key, folder)) return cases::onRight(std::move(*problem));
  const auto unread = cases::rightOf(after);
  for (const auto& table : cases::namedTables())
    for (const auto& values : table.valueKeys) {
      if (!cases::mayDiffer(values)) continue;
      const std::string text = cases::valueText(right, *cases::findParameter(values));
      if (key != table.fileKey && text == cases::valueText(unread, *cases::findParameter(values))) continue;
      if (auto problem = cases::trySetRight(after, values, text)) return problem;
    }
  return std::nullopt;
}

// What differs from the preset before was set by the user and stays, as where the command line chooses another preset.
void takePreset(cases::CaseDescription& after, const cases::CaseDescription& before) {
  cases::CaseDescription preset = before;
  cases::applyPreset(preset, before.mesh.preset);
  cases::applyPreset(after, after.mesh.preset);
  for (const auto& row : cases::presetTable()) {
    const cases::Parameter& parameter = *cases::findParameter(row.key);
    const std::string own = cases::valueText(before, parameter);
    if (own != cases::valueText(preset, parameter)) cases::trySetValue(after, parameter, own);
  }
}

// All that the preset names takes its values: one step to undo. "none" leaves them.
std::optional<CaseProblem> takeInputPreset(cases::CaseDescription& after, const std::string& key,
                                           const std::string& name) {
  try {
    cases::applyInputPreset(after, key, name);
    return std::nullopt;
  } catch (const FileError& error) {
    return CaseProblem{key, name, "a preset of the program", error.what()};
  }
}

}  // namespace

CaseDocument::CaseDocument(QObject* parent) : QObject(parent), undo_(this) {
  connect(&undo_, &QUndoStack::cleanChanged, this, [this](bool clean) {
    if (clean) saved_ = current_;
    notifyModified();
  });
  startNew();
}

// The undo stack goes after name and path, and tells that it is clean: listeners would read what is gone.
CaseDocument::~CaseDocument() { undo_.disconnect(this); }

void CaseDocument::startNew() { startFrom(cases::defaultCase(), QString(), tr("untitled"), false); }

void CaseDocument::open(const QString& nameOrPath) {
  const std::string path = cases::findCase(nameOrPath.toStdString()).string();
  const cases::CaseDescription description = cases::readCase(path);
  const QString file = QString::fromStdString(path);
  startFrom(description, isShipped(file) ? QString() : QFileInfo(file).absoluteFilePath(),
            QFileInfo(file).completeBaseName(), false);
}

void CaseDocument::startFrom(const cases::CaseDescription& description, const QString& path, const QString& name,
                             bool modified) {
  path_ = path;
  name_ = name;
  undo_.clear();
  undo_.setClean();  // clear() leaves an empty stack as it is: that of a recovered case stayed modified
  const auto opened = std::make_shared<const cases::CaseDescription>(description);
  saved_ = modified ? nullptr : opened;
  become(opened);
  if (modified) undo_.resetClean();
  Q_EMIT replaced();
  Q_EMIT titleChanged();
}

void CaseDocument::save(const QString& path) {
  cases::saveCase(description(), path.toStdString());
  path_ = QFileInfo(path).absoluteFilePath();
  name_ = QFileInfo(path).completeBaseName();
  saved_ = current_;
  undo_.setClean();
  notifyModified();
  Q_EMIT titleChanged();
}

std::optional<CaseProblem> CaseDocument::setOnRight(const std::string& key, const std::string& text) {
  cases::CaseDescription after = description();
  if (auto problem = cases::trySetRight(after, key, text)) return problem;
  if (after.right == description().right) return std::nullopt;
  if (auto problem = readTablesOnRight(after, right_, key, QFileInfo(path_).dir())) return problem;
  edit(tr("Change right.%1").arg(QString::fromStdString(key)), after);
  return std::nullopt;
}

std::optional<CaseProblem> CaseDocument::setParameter(const std::string& key, const std::string& text) {
  if (const auto onRight = cases::keyOnRight(key); !onRight.empty()) return setOnRight(std::string(onRight), text);
  const cases::Parameter* parameter = cases::findParameter(key);
  if (!parameter) return cases::unknownKey(key);
  cases::CaseDescription after = description();
  if (auto problem = cases::trySetValue(after, *parameter, text)) return problem;
  if (cases::valueText(after, *parameter) == cases::valueText(description(), *parameter)) return std::nullopt;
  if (auto problem = readTables(after, description(), key, QFileInfo(path_).dir())) return problem;
  if (key == "mesh.preset") takePreset(after, description());
  if (cases::isInputPreset(key)) {
    if (auto problem = takeInputPreset(after, key, text)) return problem;
  }
  edit(tr("Change %1").arg(QString::fromStdString(key)), after);
  if (key == "mesh.preset") notePreset();
  return std::nullopt;
}

void CaseDocument::resetParameter(const std::string& key) {
  cases::CaseDescription after = description();
  if (const auto onRight = cases::keyOnRight(key); !onRight.empty()) {
    cases::setAsLeft(after, onRight);
    return edit(tr("Set %1 as on the left").arg(QString::fromStdString(key)), after);
  }
  const cases::Parameter* parameter = cases::findParameter(key);
  if (!parameter) return;
  cases::setToDefault(after, *parameter);
  if (const auto* table = cases::namedTable(key); table && key != "defect.file") table->clear(after);
  if (key == "mesh.preset") takePreset(after, description());
  edit(tr("Reset %1").arg(QString::fromStdString(key)), after);
  if (key == "mesh.preset") notePreset();
}

void CaseDocument::notePreset() {
  const QString note = QString::fromStdString(cases::presetNote(description()));
  if (!note.isEmpty()) Q_EMIT noted(note);
}

void CaseDocument::edit(const QString& what, const cases::CaseDescription& after, int gesture) {
  if (gesture == 0 && sameCase(*current_, after)) return;  // nothing to undo, and what could be redone stays
  undo_.push(new CaseCommand(*this, what, current_, std::make_shared<const cases::CaseDescription>(after), gesture));
}

void CaseDocument::become(std::shared_ptr<const cases::CaseDescription> description) {
  current_ = std::move(description);
  right_ = cases::rightOf(*current_);
  validation_ = cases::validate(*current_);
  Q_EMIT changed();
  notifyModified();
}

void CaseDocument::notifyModified() {
  if (isModified() == notified_) return;
  notified_ = isModified();
  Q_EMIT titleChanged();
}

bool sameCase(const cases::CaseDescription& a, const cases::CaseDescription& b) {
  return cases::writeCase(a) == cases::writeCase(b);
}

}  // namespace squat::studio

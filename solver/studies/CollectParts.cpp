#include "studies/CollectParts.h"

#include <filesystem>

#include "core/Errors.h"
#include "studies/StudyIdentity.h"

namespace squat::studies {
namespace {

constexpr std::size_t kMaximumNamed = 10;

void count(PartState& part, const StudyTable& table, std::size_t row) {
  switch (table.rows[row].state) {
    case RowState::done:
      ++part.done;
      break;
    case RowState::failed:
      ++part.failed;
      break;
    case RowState::open:
      part.open.push_back(row);
      break;
  }
}

std::string sentenceOf(const PartState& part, const StudyTable& table) {
  auto text = "part " + toText(part.part) + (part.hasStarted ? ": " : " was not started: ") +
              std::to_string(part.open.size()) + (part.open.size() == 1 ? " point (" : " points (");
  for (std::size_t i = 0; i < part.open.size() && i < 3; ++i)
    text += (i ? "; " : "") + toText(table.definition, table.rows[part.open[i]].point);
  return text + (part.open.size() > 3 ? "; ...)" : ")");
}

std::string missingText(const CollectedStudy& study) {
  auto text =
      std::to_string(study.missing()) + " of " + std::to_string(study.table.rows.size()) + " points are missing: ";
  std::size_t named = 0, parts = 0;
  for (const auto& part : study.parts) {
    if (part.isComplete() || ++parts > kMaximumNamed) continue;
    text += (named++ ? ", " : "") + sentenceOf(part, study.table);
  }
  return parts > named ? text + ", and points of " + std::to_string(parts - named) + " more parts" : text;
}

}  // namespace

CollectedStudy collectParts(const StudyDefinition& definition, const std::string& folder) {
  const auto family = partsIn(definition, folder);
  if (!family)
    throw FileError(folder + "/study-parts.json", "", "is missing: no part of a study was started here",
                    "Start the parts with --partition slice:1/N to slice:N/N, or name their folder with -o");
  CollectedStudy study{emptyTable(definition), {}};
  const auto rows = rowsByValues(study.table);
  for (auto part = *family; part.part <= part.parts; ++part.part) {
    const auto path = studyFiles(folder, part).front();
    study.parts.push_back({part, std::filesystem::exists(path), 0, 0, {}});
    if (study.parts.back().hasStarted) takeRows(path, definition.variations.size(), rows);
  }
  for (std::size_t row = 0; row < study.table.rows.size(); ++row)
    count(study.parts[partOf(*family, definition, study.table.rows[row].point) - 1], study.table, row);
  return study;
}

StudyTable writeCollected(const StudyDefinition& definition, const std::string& folder) {
  auto study = collectParts(definition, folder);
  if (study.missing() > 0)
    throw FileError(folder, "", missingText(study), "Start these parts again: they compute what is missing");
  requireOwnTable(definition, study.parts.front().part, folder);
  writeTable(study.table, folder);
  return std::move(study.table);
}

}  // namespace squat::studies

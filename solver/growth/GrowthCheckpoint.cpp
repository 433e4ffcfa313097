#include "growth/GrowthCheckpoint.h"

#include <utility>

#include "case/CaseFile.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "text/Numbers.h"

namespace squat::growth {

namespace {

std::string textOf(const std::vector<Grinding>& grindings, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count && i < grindings.size(); ++i)
    text += text::numberText(grindings[i].depth) + "@" + text::numberText(grindings[i].tonnage) + " ";
  return text;
}

}  // namespace

void writeGrowth(const std::string& path, const cases::CaseDescription& description, const GrowthOptions& options,
                 const GrowthState& rail) {
  auto tree = treeOf(rail);
  results::setAttribute(tree.attributes, "case_hash", cases::caseHash(description));
  results::setAttribute(tree.attributes, "grindings", textOf(options.grindings, rail.grindings));
  results::writeCheckpoint(path, std::move(tree));
}

std::optional<GrowthState> readGrowth(const std::string& path, const cases::CaseDescription& description,
                                      const GrowthOptions& options) {
  const auto tree = results::readCheckpoint(path);
  if (!tree) return {};
  if (results::textAttribute(tree->attributes, "case_hash") != cases::caseHash(description))
    throw CaseError({{"--resume", path, "the checkpoint of this case",
                      "It belongs to another case: choose another folder or name, or remove the file"}});
  auto rail = stateFrom(*tree, path);
  if (results::textAttribute(tree->attributes, "grindings") != textOf(options.grindings, rail.grindings))
    throw CaseError({{"--grind", textOf(options.grindings, options.grindings.size()), "as in " + path,
                      "Other grindings have been done already: choose another folder or name, or remove the file"}});
  return rail;
}

}  // namespace squat::growth

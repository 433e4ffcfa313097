#include "studio/tools/ReceptanceForm.h"

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "core/DurableFile.h"
#include "plots/ReceptanceFigures.h"
#include "receptance/ReceptanceFiles.h"
#include "receptance/ReceptanceSummary.h"

namespace squat::studio {
namespace {

ToolResult computeReceptance(const ToolInput& input, Monitor& monitor) {
  makeFolder(input.folder);  // whether it can be written is known before it takes time
  const auto found = std::make_shared<receptance::TrackReceptance>(
      receptance::trackReceptance(cases::resolve(input.description), {}, monitor));
  ToolResult result;
  result.complete = found->complete;
  if (!found->complete) return result;
  result.text = receptance::receptanceSummary(*found);
  const std::string stem = input.folder + "/" + input.name;
  receptance::writeReceptanceFiles(stem, *found, cases::writeCase(input.description));
  result.files = receptance::receptanceFiles(stem);
  result.figures = [found, name = input.name, title = input.description.title,
                    hash = cases::caseHash(input.description)](const plots::Style& style) {
    std::vector<plots::FigureSheet> sheets;
    sheets.push_back(plots::receptanceFigures(*found, name + "-receptance", title, hash, style));
    return sheets;
  };
  return result;
}

}  // namespace

QString ReceptanceForm::explanation() const {
  return tr(
      "Computes the receptance of the open case's track from 50 to 2000 Hz, over a sleeper and at midspan, and "
      "the natural modes of the free half wheelset.");
}

ToolWork ReceptanceForm::work() { return computeReceptance; }

}  // namespace squat::studio

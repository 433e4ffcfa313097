#include "plots/Figures.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

#include "colours/ColourTables.h"
#include "core/Errors.h"
#include "plots/FigureBuilders.h"
#include "plots/FigureFiles.h"
#include "scene/ModelPicture.h"

namespace squat::plots {
namespace {

using Builder = std::unique_ptr<Figure> (*)(const results::RunResult&, const Style&);
const std::vector<std::pair<std::string, Builder>>& builders() {
  static const std::vector<std::pair<std::string, Builder>> table{{"defect_profile", defectProfileFigure},
                                                                  {"aba_position", abaPositionFigure},
                                                                  {"aba_time", abaTimeFigure},
                                                                  {"psd", psdFigure},
                                                                  {"scalogram", scalogramFigure},
                                                                  {"contact_force", contactForceFigure},
                                                                  {"permanent_change", permanentChangeFigure},
                                                                  {"residual_stress", residualStressFigure}};
  return table;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void checkAll(const std::string& key, const std::vector<std::string>& found, const std::vector<std::string>& allowed,
              std::vector<CaseProblem>& problems) {
  for (const auto& name : found)
    if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
      problems.push_back({key, name, listed(allowed), "Name one or more of these, separated by commas"});
}

bool ofPlasticFlow(const std::string& name) { return name == "permanent_change" || name == "residual_stress"; }

// All figures, but for those of plastic flow where the rail is elastic.
std::vector<std::string> figuresFor(const results::RunResult& result) {
  auto names = figureNames();
  if (result.permanent.empty()) std::erase_if(names, ofPlasticFlow);
  return names;
}

// All mistakes of a request; a figure that was named is not drawn empty.
void check(const FigureRequest& request, const std::vector<std::string>& allowed) {
  std::vector<CaseProblem> problems;
  checkAll("--figures", request.figures, allowed, problems);
  for (auto& problem : problems)
    if (ofPlasticFlow(problem.value)) problem.advice = "The result has no plastic flow (rail.plastic)";
  checkAll("--format", request.formats, {"png", "svg", "pdf"}, problems);
  checkAll("--colours", {request.colourMap}, colours::mapNames(), problems);
  if (!problems.empty()) throw CaseError(problems);
}

}  // namespace

void checkRequest(const FigureRequest& request) { check(request, figureNames()); }

std::vector<std::string> figureNames() {
  std::vector<std::string> names;
  for (const auto& [name, builder] : builders()) names.push_back(name);
  names.push_back("model");
  return names;
}

std::vector<std::string> availableFigures(const results::RunResult& result) {
  auto names = figuresFor(result);
  std::erase_if(names, [&](const std::string& name) {
    if (name == "psd") return result.frequency.size() < 2 || result.psd.size() != result.frequency.size();
    if (name == "scalogram") return result.scalogramPower.empty();
    if (name == "contact_force") return result.signal("contact_force") == nullptr;
    if (name == "aba_position" || name == "aba_time")
      return !result.signal("aba_filtered") && !result.signal("aba") && !result.signal("wheel_acceleration_filtered");
    return false;
  });
  return names;
}

std::unique_ptr<Figure> makeFigure(const std::string& name, const results::RunResult& result, const Style& style) {
  for (const auto& [known, builder] : builders())
    if (known == name) return builder(result, style);
  return nullptr;
}

std::vector<std::string> renderFigures(const results::RunResult& result, const std::string& folder,
                                       const FigureRequest& request, std::vector<std::string>* messages) {
  check(request, availableFigures(result));
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw FileError(folder, "", "cannot create the folder: " + failure.message());
  Style style = lightStyle();
  style.colourMap = request.colourMap;
  std::vector<std::string> written;
  for (const auto& name : request.figures.empty() ? figuresFor(result) : request.figures) {
    const std::string stem = (std::filesystem::path(folder) / name).string();
    if (name == "model") {
      const scene::ModelPictureOutcome outcome = scene::writeModelPicture(result, request.colourMap, stem + ".png");
      if (outcome.written)
        written.push_back(stem + ".png");
      else if (messages)
        messages->push_back("figure model not drawn: " + outcome.reason);
      continue;
    }
    const std::unique_ptr<Figure> figure = makeFigure(name, result, style);
    for (const auto& format : request.formats) {
      writeFigure(*figure, format, stem + "." + format);
      written.push_back(stem + "." + format);
    }
  }
  return written;
}

}  // namespace squat::plots

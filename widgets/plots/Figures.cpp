#include "plots/Figures.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <future>

#include "colours/ColourTables.h"
#include "core/Errors.h"
#include "plots/FigureFiles.h"
#include "plots/FigureRegistry.h"
#include "scene/ModelPicture.h"

namespace squat::plots {
namespace {

using Fits = std::function<bool(const FigureRow&)>;

std::vector<std::string> namesWhere(const Fits& fits) {
  std::vector<std::string> names;
  for (const auto& row : figureRegistry())
    if (fits(row)) names.push_back(row.name);
  return names;
}

void checkAll(const std::string& key, const std::vector<std::string>& found, const std::vector<std::string>& allowed,
              std::vector<CaseProblem>& problems) {
  std::string list;
  for (const auto& name : allowed) list += (list.empty() ? "" : ", ") + name;
  for (const auto& name : found)
    if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
      problems.push_back({key, name, list, "Name one or more of these, separated by commas"});
}

// All mistakes of a request; a figure that was named is not drawn empty.
void check(const FigureRequest& request, const Fits& fits) {
  std::vector<CaseProblem> problems;
  checkAll("--figures", request.figures, namesWhere(fits), problems);
  for (auto& problem : problems)
    for (const auto& row : figureRegistry())
      if (row.name == problem.value) problem.advice = row.needs;
  checkAll("--format", request.formats, {"png", "svg", "pdf"}, problems);
  checkAll("--colours", {request.settings.colours}, colours::mapNames(), problems);
  if (!problems.empty()) throw CaseError(problems);
}

void makeFolder(const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw FileError(folder, "", "cannot create the folder: " + failure.message());
}

}  // namespace

void checkRequest(const FigureRequest& request, const cases::CaseDescription* description) {
  check(request, [&](const FigureRow& row) { return !description || !row.expected || row.expected(*description); });
}

void checkRequest(const FigureRequest& request, const results::RunResult& result) {
  check(request, [&](const FigureRow& row) { return row.applies(result); });
}

scene::PictureSize modelSize(const PrintedSize& size) {
  scene::PictureSize chosen;
  if (size.width > 0) chosen.width = size.width, chosen.height = size.height;
  chosen.resolution = size.resolution;
  return chosen;
}

std::vector<std::string> renderFigures(const results::RunResult& result, const std::string& folder,
                                       const FigureRequest& request, std::vector<std::string>* messages) {
  const Fits applies = [&](const FigureRow& row) { return row.applies(result); };
  checkRequest(request, result);
  makeFolder(folder);
  Style style = lightStyle();
  style.colourMap = request.settings.colours;
  std::vector<std::string> written;
  const auto say = [&](const std::string& message) {
    if (messages) messages->push_back(message);
  };
  const auto names = request.figures.empty() ? namesWhere(applies) : request.figures;
  if (names.empty()) say("no figure drawn: the result holds nothing that could be shown");
  if (request.settings.spectrum != analysis::SpectrumScale::linear &&
      std::find(names.begin(), names.end(), "psd") == names.end())
    say("--spectrum has no effect: it is the scale of the figure psd, which is not drawn");
  const auto stemOf = [&](const std::string& name) { return (std::filesystem::path(folder) / name).string(); };
  // The picture of the model takes as long as all other figures together. It needs neither the application nor a
  // screen, so a thread of its own draws it while this one draws the others.
  std::future<scene::ModelPictureOutcome> model;
  for (const auto& name : names)
    if (figureRow(name).kind == FigureKind::model)
      model = std::async(std::launch::async, [&, path = stemOf(name) + ".png"] {
        return scene::writeModelPicture(result, request.settings.colours, path, modelSize(request.size));
      });
  for (const auto& name : names) {
    const auto& row = figureRow(name);
    const std::string stem = stemOf(name);
    if (row.kind == FigureKind::model) {
      if (!model.valid()) continue;  // named twice
      const scene::ModelPictureOutcome outcome = model.get();
      if (outcome.written)
        written.push_back(stem + ".png");
      else
        say("figure " + name + " not drawn: " + outcome.reason);
      continue;
    }
    const std::unique_ptr<Figure> figure = buildFigure(row, result, style, request.settings);
    if (request.size.width > 0) figure->setPrintedSize({request.size.width, request.size.height});
    for (const auto& format : request.formats) {
      writeFigure(*figure, format, stem + "." + format, {}, request.size.resolution);
      written.push_back(stem + "." + format);
    }
  }
  return written;
}

}  // namespace squat::plots

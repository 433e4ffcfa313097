// widgets/plots/FigureRegistry.h - the figures of a run, one row each. `render`, `run`, their help, the studio's tabs
// and every export read it: a figure that has a row is everywhere.
#pragma once

#include <QByteArray>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analysis/FigureSettings.h"
#include "case/CaseDeclaration.h"
#include "plots/LineFigure.h"
#include "signals/PowerSpectrum.h"

namespace squat::plots {

enum class FigureKind { plot, model };  // the 3-D picture is no plot: it comes as PNG, in the studio as its own tab

// What the x axis is, in the unit of the figure. Figures against the wheel's position and against time zoom together.
enum class FigureAxis { wheelPosition, time, railPosition, frequency, stress, patch };
std::string unitOf(FigureAxis axis);  // "mm", "ms", "Hz", "MPa"

enum class FigureMarks { none, extremes, lines };  // what a viewer marks: peaks of the first curve, of the map
// What a viewer lets the user choose beside the figure.
enum class FigureControl { none, spectrumSection, shortTime, moment };

// A record laid over the run that is shown, computed or measured.
struct OverlaidRun {
  std::shared_ptr<const signals::Record> record;
  signals::PowerSpectrum spectrum;  // of its axle box acceleration; empty: none
  std::string label;
  std::size_t colourIndex = 0;  // which colour of Style::overlay, unless it has one of its own
  QColor colour = {};
};

using analysis::FigureSettings;

struct FigureRow {
  std::string name;        // of the file and of the option: "contact_force"
  std::string tab;         // a short heading
  std::string title;       // in words, for help and tool tips
  std::string needs;       // a sentence: what a result must hold
  std::string shows = {};  // a sentence: what one sees, where the title is a term of signal processing
  FigureKind kind = FigureKind::plot;

  // Whether the result holds what the figure shows.
  std::function<bool(const results::RunResult& result)> applies = nullptr;
  // Whether a run of the case will; null: any run.
  std::function<bool(const cases::CaseDescription& description)> expected = nullptr;
  // Null for the model. A result that it does not apply to yields the figure with a notice in it.
  std::function<std::unique_ptr<Figure>(const results::RunResult& result, const Style& style,
                                        const FigureSettings& settings)>
      build = nullptr;

  // Another run over the one that is shown, on its axis; without points where that run lacks it. Null: no overlays.
  std::function<Curve(const OverlaidRun& other, const results::RunResult& shown, const FigureSettings&)> overlay =
      nullptr;
  // Range of y once other runs lie in it; null: fitValues().
  std::function<void(Figure& figure, const FigureSettings& settings)> fit = nullptr;

  FigureAxis axis = FigureAxis::wheelPosition;
  FigureMarks marks = FigureMarks::none;
  FigureControl control = FigureControl::none;
  bool drawsScalogram = false;  // a viewer that filters anew computes the scalogram anew before it builds
  // The numbers as CSV where they are more than the curves; null: the curves alone.
  std::function<QByteArray(const results::RunResult& result, const FigureSettings& settings)> table = nullptr;
};

// In the order of tabs and of help. Names are unique.
const std::vector<FigureRow>& figureRegistry();

// Throws CaseError (key --figures, with the names that there are) for an unknown name.
const FigureRow& figureRow(const std::string& name);

// As row.build, with other runs over it where the row has an overlay. The result has been through
// analysis::resultThrough() where the settings are not those of the run. Throws CaseError for a row that is no plot.
std::unique_ptr<Figure> buildFigure(const FigureRow& row, const results::RunResult& result, const Style& style,
                                    const FigureSettings& settings = {}, const std::vector<OverlaidRun>& overlays = {});

// "  psd              Power spectral density", a line for each row.
std::string figureList();

}  // namespace squat::plots

// widgets/plots/FigureBuilders.h - each figure of a run, as an object for screen or file.
// A result that lacks what a figure shows yields that figure with a notice in it, never an error.
#pragma once

#include <QByteArray>
#include <memory>

#include "analysis/FigureSettings.h"
#include "plots/Figure.h"
#include "plots/LineFigure.h"
#include "results/RunResult.h"

namespace squat::plots {

std::unique_ptr<Figure> defectProfileFigure(const results::RunResult& result, const Style& style);
std::unique_ptr<Figure> abaPositionFigure(const results::RunResult& result, const Style& style);
std::unique_ptr<Figure> abaTimeFigure(const results::RunResult& result, const Style& style);
// `section` [m]: of the track, that the spectrum was computed from; 0: psdFrom to psdTo.
std::unique_ptr<Figure> psdFigure(const results::AnalysedRecord& result, const Style& style,
                                  analysis::SpectrumScale scale = analysis::SpectrumScale::linear, double section = 0);
// A density [(m/s2)2/Hz] over frequencies [Hz] as it is drawn in a scale, and the range of y that holds such curves.
Curve spectrumCurve(const std::vector<double>& frequency, const std::vector<double>& density,
                    analysis::SpectrumScale scale);
void fitSpectrum(Figure& figure, analysis::SpectrumScale scale);
std::unique_ptr<Figure> scalogramFigure(const results::AnalysedRecord& result, const Style& style);
// The same of an amplitude-normalised transform: a tone of amplitude 1 m/s2 gives 1 (m/s2)2.
std::unique_ptr<Figure> amplitudeScalogramFigure(const results::AnalysedRecord& result, const Style& style);
// Short-time Fourier transform of aba_filtered under Hann windows of `segment` samples, one every `hop` samples (0: a
// 32nd of the segment); fewer where that would be more than 2000 columns. Throws SignalError for values that are not
// numbers.
std::unique_ptr<Figure> stftFigure(const results::AnalysedRecord& result, const Style& style, std::size_t segment = 128,
                                   std::size_t hop = 0);
// Contact pressure and slip at the impact, or at the moment `index` of result.patches; then axes and colours are those
// of all moments. Of a whole model whose right contact was stored, both contacts beside each other, on one scale.
std::unique_ptr<Figure> patchFigure(const results::RunResult& result, const Style& style, int index = -1);
// The moment that it draws. -1: the impact, else the last one that has pressures. Null where there is none.
const results::PatchSnapshot* shownPatch(const results::RunResult& result, int index = -1);
// Every point of contact with pressure, traction and slip, as CSV, of two contacts with the name of the side; empty
// without a patch.
QByteArray patchTable(const results::RunResult& result, int index = -1);
// What plastic flow leaves in the unloaded rail: change of the running surface; stress against depth where most flowed.
std::unique_ptr<Figure> permanentChangeFigure(const results::RunResult& result, const Style& style);
std::unique_ptr<Figure> residualStressFigure(const results::RunResult& result, const Style& style);
// Accelerations of the rail foot and of the nearest sleeper beside the track; a dashed line where the wheel is over the
// sensor.
std::unique_ptr<Figure> tracksideFigure(const results::RunResult& result, const Style& style);
std::unique_ptr<Figure> contactForceFigure(const results::RunResult& result, const Style& style);

}  // namespace squat::plots

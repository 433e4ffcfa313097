#include "receptance/DecayRate.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "core/Errors.h"
#include "core/ThreadTeam.h"
#include "receptance/Receptance.h"
#include "receptance/ThirdOctaves.h"
#include "receptance/TrackLosses.h"

namespace squat::receptance {

namespace {

// The half track moving in one of two ways, made for many frequencies.
struct CellWay {
  CellWay(const model::Model& model, const SectionShapes& shapes, TrackSymmetry symmetry, double bay, bool wholeSection)
      : system(model, shapes, symmetry), track(system, bay, wholeSection) {}
  TrackSystem system;
  PeriodicTrack track;
};

// Calls `solve` with the index and the angular frequency [rad/s] of each, shared among the threads; false where it was
// cancelled. Throws what `solve` throws.
bool overFrequencies(const char* phase, const std::vector<double>& frequency, int threads, Monitor& monitor,
                     const std::function<void(std::size_t, double)>& solve) {
  ThreadTeam team(threadCount(threads));
  std::atomic<std::size_t> next{0}, done{0};
  std::atomic<bool> cancelled{false};
  team.run([&](int index) {
    for (std::size_t f = next++; f < frequency.size() && !cancelled; f = next++) {
      solve(f, 2 * std::numbers::pi * frequency[f]);
      ++done;
      if (index != 0) continue;  // one thread talks to the monitor
      if (monitor.cancelled()) cancelled = true;
      Progress progress;
      progress.phase = phase;
      progress.fraction = static_cast<double>(done.load()) / static_cast<double>(frequency.size());
      monitor.report(progress);
    }
  });
  return !cancelled;
}

}  // namespace

EndlessTrackResponse endlessTrackResponse(const scenario::Scenario& asked, const std::vector<double>& frequency,
                                          const std::vector<PlaceResponse>& wanted, const EndlessTrackOptions& options,
                                          Monitor& monitor) {
  if (!asked.track.seats.empty())
    throw CaseError({{"track.seats", std::to_string(asked.track.seats.size()) + " seats that differ",
                      "none: an endless track has equal bays",
                      "Leave them out, or compute the receptance of the track of finite length"}});
  const auto scenario = receptanceCase(asked);
  const auto model = model::buildTrackCell(scenario, options.stationLength, options.sleeperIntervals);
  const auto shapes = railShapes(model, options.shapeTolerance);
  const double bay = scenario.track.sleeperSpacing;
  std::vector<std::unique_ptr<CellWay>> ways;
  for (const auto symmetry : symmetriesOf(options.rails))
    ways.push_back(std::make_unique<CellWay>(model, shapes, symmetry, bay, options.wholeSection));

  EndlessTrackResponse result;
  result.frequency = frequency;
  result.sectionShapes = static_cast<int>(shapes.shapes.cols());
  result.unknowns = static_cast<std::size_t>(ways.front()->system.groups().unknowns());
  for (const auto& one : wanted)
    result.values.emplace_back(one.read.size(), std::vector<std::complex<double>>(frequency.size()));
  const auto solve = [&](std::size_t f, double omega) {
    for (const auto& way : ways) {
      const auto answers = way->track.response(omega, wanted);
      for (std::size_t w = 0; w < answers.size(); ++w)
        for (std::size_t p = 0; p < answers[w].size(); ++p)
          result.values[w][p][f] += answers[w][p] / static_cast<double>(ways.size());
    }
  };
  result.complete = overFrequencies("endless track", frequency, options.threads, monitor, solve);
  return result;
}

std::vector<std::complex<double>> sleeperReceptance(const scenario::Scenario& asked,
                                                    const std::vector<double>& frequency, StruckRails rails,
                                                    int threads, Monitor& monitor) {
  constexpr int intervals = 32;   // along a half sleeper
  constexpr double coarse = 0.1;  // shapes of the rail, which is there, free, and coupled with nothing
  if (asked.sleeper.fixed)
    throw CaseError({{"sleeper.fixed", "true", "false for the receptance of a sleeper", "Leave it out"}});
  const auto scenario = receptanceCase(asked);
  const auto model = model::buildTrackCell(scenario, scenario.track.sleeperSpacing / 8, intervals);
  const auto shapes = railShapes(model, coarse);
  std::vector<std::unique_ptr<TrackSystem>> ways;
  std::vector<DynamicStiffness> stiffness;
  for (const auto symmetry : symmetriesOf(rails)) {
    ways.push_back(std::make_unique<TrackSystem>(model, shapes, symmetry));
    stiffness.emplace_back(ways.back()->termsWithoutPads());
  }
  const Eigen::MatrixXcd seat = ways.front()->sleeperSeat().cast<std::complex<double>>();
  std::vector<std::complex<double>> receptance(frequency.size());
  const bool finished = overFrequencies("sleeper", frequency, threads, monitor, [&](std::size_t f, double omega) {
    for (const auto& way : stiffness)
      receptance[f] +=
          seat.col(0).cwiseProduct(way.factor(omega).solve(seat).col(0)).sum() / static_cast<double>(stiffness.size());
  });
  return finished ? receptance : std::vector<std::complex<double>>();
}

// EN 15461:2008+A1:2010, Figure 2: every quarter bay at first, then ever farther apart.
const std::vector<double>& decayPositions() {
  static const std::vector<double> bays{0, 0.25, 0.5, 0.75, 1,  1.25, 1.5, 1.75, 2,  2.25, 2.5, 3,  3.5, 4, 5,
                                        6, 7,    8,   10,   12, 16,   20,  24,   30, 36,   42,  48, 54,  66};
  return bays;
}

// Each position stands for the rail half-way to its neighbours; the first for that on its one side, the last for as
// much beyond it.
double decayRate(const std::vector<double>& squares, double bay) {
  constexpr double decibelsOfSquare = 4.343;  // 10 lg e
  const auto& at = decayPositions();
  double sum = 0;
  for (std::size_t n = 0; n < at.size(); ++n) {
    const double before = n > 0 ? 0.5 * (at[n] - at[n - 1]) : 0;
    const double behind = n + 1 < at.size() ? 0.5 * (at[n + 1] - at[n]) : before;
    sum += squares[n] / squares[0] * (before + behind) * bay;
  }
  return decibelsOfSquare / sum;
}

double decayLimit(double band, RailDirection direction) {
  constexpr struct {
    double band, vertical, lateral;
  } limits[] = {{250, 2, 2.04},    {315, 2, 1.38},    {400, 6, 0.94},    {500, 6, 0.64},    {630, 6, 0.43},
                {800, 2.19, 0.29}, {1000, 0.8, 0.20}, {1250, 0.8, 0.20}, {1600, 0.8, 0.32}, {2000, 0.8, 0.50},
                {2500, 0.8, 0.50}, {3150, 0.8, 0.50}, {4000, 0.8, 0.50}, {5000, 0.8, 0.50}};
  for (const auto& row : limits)
    if (row.band == band) return direction == RailDirection::vertical ? row.vertical : row.lateral;
  return std::nan("");
}

DecayRates trackDecayRates(const scenario::Scenario& scenario, const DecayOptions& options, Monitor& monitor) {
  DecayRates rates;
  std::vector<double> frequency;
  for (const double band : nominalThirdOctaves()) {
    if (band < options.lowest || band > options.highest) continue;
    rates.band.push_back(band);
    for (int i = 0; i < options.linesPerBand; ++i)
      frequency.push_back(middleOfThirdOctave(band) *
                          std::pow(kThirdOctaveEdge, 2 * (i + 0.5) / options.linesPerBand - 1));
  }
  rates.notes = lossNotes(scenario);
  const double bay = scenario.track.sleeperSpacing;
  rates.smallest = 4.343 / (decayPositions().back() * bay);
  std::vector<PlaceResponse> wanted;
  for (const auto direction : {RailDirection::vertical, RailDirection::lateral}) {
    PlaceResponse places{{bay / 2, direction}, {}};
    for (const double bays : decayPositions()) places.read.push_back({bay / 2 + bays * bay, direction});
    wanted.push_back(places);
  }
  const auto response = endlessTrackResponse(scenario, frequency, wanted, options.track, monitor);
  rates.sectionShapes = response.sectionShapes;
  rates.complete = response.complete;
  if (!rates.complete) return rates;
  for (std::size_t b = 0; b < rates.band.size(); ++b)
    for (std::size_t w = 0; w < wanted.size(); ++w) {
      std::vector<double> squares(decayPositions().size(), 0.0);
      for (std::size_t n = 0; n < squares.size(); ++n)
        for (int i = 0; i < options.linesPerBand; ++i) {
          // Accelerance: the receptance times the frequency squared.
          const auto line = b * static_cast<std::size_t>(options.linesPerBand) + static_cast<std::size_t>(i);
          squares[n] += std::norm(response.values[w][n][line]) * std::pow(frequency[line], 4);
        }
      (w == 0 ? rates.vertical : rates.lateral).push_back(decayRate(squares, bay));
    }
  return rates;
}

}  // namespace squat::receptance

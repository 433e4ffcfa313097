// solver/detection/Examples.h - passages whose cause is known: what an event is taken for is what they were.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/Monitor.h"
#include "core/ThreadTeam.h"
#include "detection/EventFeatures.h"
#include "detection/Example.h"
#include "detection/Label.h"
#include "detection/Severity.h"
#include "detection/SizePosterior.h"

namespace squat::detection {

class KindDensity;

// kind, vehicle, length [mm], depth [mm], speed [m/s], offset [mm], weight, energies, before, reach [m], form,
// energies of the first arrival (empty where an example has none).
std::string examplesText(const std::vector<Example>& examples);
// Throws FileError with the line.
std::vector<Example> readExamples(const std::string& path);

// What the examples say of one event.
struct Judgement {
  Kind kind = Kind::other;
  double sureness = 0;  // [0..1] probability of the kind
  double squatProbability = 0;
  double nothing = 0;  // probability that it is the local noise alone
  Severity severity = Severity::light;
  double severitySureness = 0;
  double length = 0, lengthLow = 0, lengthHigh = 0;  // [m] median and 90 % range, of squats
  double depth = 0, depthLow = 0, depthHigh = 0;     // [m]
  double offset = 0;                                 // [m] mean, to be taken from the anchor's position
  std::array<double, 3> severities{};                // probability of each, if it is a squat
  // [0..1] how well the record's events go with an axle box as the examples have them; the kinds count as much.
  double axleBox = 1;
  double otherProbability = 0;
  // [0..1] of a wheel flat, against all else, by the signal alone. It is no kind: what does not repeat is no flat.
  double flatProbability = 0.5;
};

struct JudgementOptions {
  // Scatter of log10 energy between alike passages of different vehicles: of each band by itself, of all bands
  // together.
  double spread = 0.2, commonSpread = 0.2;
  double sizeSpread = 0.4;  // of the logarithm of length and depth: how far the next example is
  double nothing = 100;     // odds ahead of any event that a candidate is noise, to one example's kind
  SeverityLimits limits;
};

// Bayes' rule over the examples, one kernel each: with the local noise of the event added to an example's energies, the
// logarithms are taken to be normal, with the options' spreads and the scatter that noise of that many degrees of
// freedom brings. An example counts at the speed of the event: energies go with the square of the speed.
class Judge {
 public:
  // Where `sizes` is known, length, depth and severity of squats come from it, with `own`, passages of the records' own
  // vehicle; else from the examples as kind and sureness do.
  Judge(std::vector<Example> examples, JudgementOptions options, SizeModel sizes = {}, std::vector<Example> own = {});

  // The events of one record share vehicle and track: examples of vehicles that explain all of them well count more.
  // `labels`: of each event, or empty. What is labelled tells of the vehicle; its own judgement is not that of the
  // label. Nothing where it was cancelled; not influenced by the number of threads.
  std::optional<std::vector<Judgement>> judge(const std::vector<EventFeatures>& events,
                                              const std::vector<std::optional<Label>>& labels, ThreadTeam& team,
                                              Monitor& monitor) const;
  // The same on one thread, unwatched.
  std::vector<Judgement> judge(const std::vector<EventFeatures>& events) const;

  const SeverityLimits& limits() const { return options_.limits; }
  bool isEmpty() const { return examples_.empty(); }
  std::size_t vehicles() const { return vehicles_.size(); }

 private:
  std::vector<double> logLikelihoods(const EventFeatures& event) const;
  double logNothing(const EventFeatures& event) const;
  // What an event adds to the logarithm of each vehicle's weight.
  std::vector<double> forVehicles(const EventFeatures& event) const;
  // Weights and vehicle: nothing where it was cancelled.
  std::optional<std::vector<double>> vehicleWeights(const std::vector<EventFeatures>& events, ThreadTeam& team,
                                                    Monitor& monitor) const;
  void takeKind(const EventFeatures& event, const Vehicle& vehicle, const SquatSize& size, const KindDensity& densities,
                Judgement& judgement) const;
  std::optional<Vehicle> vehicleOf(const std::vector<EventFeatures>& events,
                                   const std::vector<std::optional<Label>>& labels, std::vector<Judgement> judgements,
                                   const SizePosterior& posterior, const KindDensity& densities, ThreadTeam& team,
                                   Monitor& monitor) const;
  Belief beliefOf(const Judgement& judgement, const std::optional<Label>& label) const;
  Judgement weigh(const EventFeatures& event, const std::vector<double>& vehicles) const;

  std::vector<Example> examples_;
  JudgementOptions options_;
  SizeModel sizes_;
  std::optional<PossibleDefects> possible_;  // where sizes_ is known
  std::vector<Example> own_;
  std::vector<std::string> vehicles_;
  std::vector<std::size_t> vehicleOf_;  // of each example
  std::vector<double>
      prior_;  // log: each kind, and each severity of squats, counts the same in all; each vehicle of it as well
};

}  // namespace squat::detection

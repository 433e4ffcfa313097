#include "receptance/Receptance.h"

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>

#include "case/Resolve.h"
#include "core/Errors.h"
#include "python/Arrays.h"
#include "python/Case.h"
#include "python/Computation.h"
#include "python/Module.h"
#include "receptance/DecayRate.h"
#include "text/Numbers.h"

namespace squat::python {

namespace py = pybind11;

namespace {

using receptance::ReceptanceQuantity;

struct Receptance {
  receptance::TrackReceptance track;  // its values stand for `quantity`
  ReceptanceQuantity quantity = ReceptanceQuantity::receptance;

  const receptance::PointReceptance& point(const std::string& name) const {
    std::string names;
    for (const auto& each : track.points) {
      if (each.name == name) return each;
      names += (names.empty() ? "" : ", ") + each.name;
    }
    throw py::key_error("'" + name + "' is no place of this receptance; it has " + names);
  }
};

ReceptanceQuantity quantityNamed(const std::string& name) {
  if (name == "receptance") return ReceptanceQuantity::receptance;
  if (name == "mobility") return ReceptanceQuantity::mobility;
  if (name == "accelerance") return ReceptanceQuantity::accelerance;
  throw CaseError({{"quantity", name, "receptance, mobility or accelerance", ""}});
}

// Over a sleeper and at midspan where nothing else is asked for; named as on the command line.
std::vector<receptance::ReceptancePlace> placesOf(const std::vector<double>& at, std::optional<double> struck,
                                                  bool lateral, double spacing) {
  const auto direction = lateral ? receptance::RailDirection::lateral : receptance::RailDirection::vertical;
  const std::string way = lateral ? "lateral, " : "";
  std::vector<receptance::ReceptancePlace> places;
  for (const double x : at) {
    auto name = way + "at " + text::numberText(x) + " m";
    if (struck) name += " struck at " + text::numberText(*struck) + " m";
    places.push_back({name, struck.value_or(x), x, direction});
  }
  if (!places.empty()) return places;
  return {{way + "over a sleeper", struck.value_or(0), 0, direction},
          {way + "midspan", struck.value_or(-spacing / 2), -spacing / 2, direction}};
}

void refuseWith(const char* name, bool isGiven, const char* other) {
  if (isGiven)
    throw CaseError({{name, "", "", std::string("has no effect with ") + other + "; leave out one of them"}});
}

Receptance compute(const Case& which, const std::vector<double>& at, std::optional<double> struck, bool lateral,
                   bool oneRail, bool endless, bool sleeper, double lowest, double highest, std::optional<double> step,
                   const std::string& quantity, int threads, const py::object& progress) {
  requireThreads(threads);
  requireBetween("lowest", lowest, 1, 5000, "1 to 5000 Hz");
  requireBetween("highest", highest, 10, 10000, "10 to 10000 Hz");
  if (!(lowest < highest)) throw CaseError({{"highest", text::numberText(highest), "above lowest", ""}});
  if (step) requireBetween("step", *step, 0.01, 1000, "0.01 to 1000 Hz");
  refuseWith("step", step && endless, "endless");
  for (const auto& [name, isGiven] : {std::pair{"at", !at.empty()},
                                      {"struck", struck.has_value()},
                                      {"lateral", lateral},
                                      {"endless", endless},
                                      {"step", step.has_value()}})
    refuseWith(name, sleeper && isGiven, "sleeper");
  receptance::ReceptanceOptions options;
  options.lowest = lowest, options.highest = highest, options.threads = threads, options.endless = endless;
  if (step) options.frequencyStep = *step;
  options.rails = oneRail ? receptance::StruckRails::one : receptance::StruckRails::both;
  options.places = placesOf(at, struck, lateral, which.description.track.sleeperSpacing);
  Receptance result;
  result.quantity = quantityNamed(quantity);
  const auto scenario = cases::resolve(which.description);
  computeAside(progress, [&](Monitor& monitor) {
    result.track = sleeper ? receptance::sleeperByItself(scenario, options, monitor)
                           : receptance::trackReceptance(scenario, options, monitor);
  });
  for (auto& point : result.track.points)
    point.receptance = receptance::asQuantity(result.track.frequency, point.receptance, result.quantity);
  return result;
}

std::vector<std::string> placeNames(const Receptance& self) {
  std::vector<std::string> names;
  for (const auto& point : self.track.points) names.push_back(point.name);
  return names;
}

py::dict freeModes(const py::object& self) {
  const auto& modes = self.cast<const Receptance&>().track.modes;
  py::dict all;
  all["frequency"] = viewOfMember(modes, &model::HarmonicMode::frequency, self);
  all["harmonic"] = viewOfMember(modes, &model::HarmonicMode::harmonic, self);
  py::list antisymmetric;
  for (const auto& mode : modes) antisymmetric.append(mode.centre == model::Centre::antisymmetric);
  all["antisymmetric"] = antisymmetric;
  all["box_share"] = viewOfMember(modes, &model::HarmonicMode::boxAmplitude, self);
  all["wheel_share"] = viewOfMember(modes, &model::HarmonicMode::wheelAmplitude, self);
  all["contact_share"] = viewOfMember(modes, &model::HarmonicMode::contactAmplitude, self);
  return all;
}

void addReceptanceClass(py::module_& module) {
  py::class_<Receptance>(
      module, "Receptance",
      R"(What a track answers to a harmonic force: receptance["midspan"] is a complex array (f), its phase
negative where the response lags. Arrays are read-only and not copied.)")
      .def("__getitem__",
           [](const py::object& self, const std::string& name) {
             return view(self.cast<const Receptance&>().point(name).receptance, self);
           })
      .def("__contains__",
           [](const Receptance& self, const std::string& name) {
             const auto names = placeNames(self);
             return std::find(names.begin(), names.end(), name) != names.end();
           })
      .def("keys", &placeNames, "Names of the places: a list of str.")
      .def("__iter__", [](const Receptance& self) { return py::iter(py::cast(placeNames(self))); })
      .def("__len__", [](const Receptance& self) { return self.track.points.size(); })
      .def(
          "resonances",
          [](const Receptance& self, const std::string& name) {
            return receptance::resonances(self.track.frequency, self.point(name).receptance);
          },
          py::arg("name"), "Local maxima of the magnitude at a place [Hz]: a list of float.")
      .def_property_readonly(
          "frequency",
          [](const py::object& self) { return view(self.cast<const Receptance&>().track.frequency, self); },
          "Frequencies [Hz]: array (f).")
      .def_property_readonly(
          "unit", [](const Receptance& self) { return receptance::unitOf(self.quantity); }, "Unit of the values: str.")
      .def_property_readonly(
          "modes", &freeModes,
          R"(Natural modes of the free wheelset: a dict of frequency [Hz], harmonic, antisymmetric (a list of bool: both
sides move oppositely; else alike, as in the half model), and box_share,
wheel_share and contact_share [1/sqrt(kg)], arrays (m).)")
      .def_property_readonly(
          "notes", [](const Receptance& self) { return self.track.notes; }, "A list of str.");
}

receptance::DecayRates decayRates(const Case& which, int threads, const py::object& progress) {
  requireThreads(threads);
  receptance::DecayOptions options;
  options.track.threads = threads;
  const auto scenario = cases::resolve(which.description);
  receptance::DecayRates rates;
  computeAside(progress, [&](Monitor& monitor) { rates = receptance::trackDecayRates(scenario, options, monitor); });
  return rates;
}

void addDecay(py::module_& module) {
  using receptance::DecayRates;
  const auto array = [](std::vector<double> DecayRates::*member) {
    return [member](const py::object& self) { return view(self.cast<const DecayRates&>().*member, self); };
  };
  py::class_<DecayRates>(module, "DecayRates", "Track decay rates after EN 15461. Arrays are read-only and not copied.")
      .def_property_readonly("band", array(&DecayRates::band), "Nominal middles of third octaves [Hz]: array (b).")
      .def_property_readonly("vertical", array(&DecayRates::vertical), "Vertical decay rates [dB/m]: array (b).")
      .def_property_readonly("lateral", array(&DecayRates::lateral), "Lateral decay rates [dB/m]: array (b).")
      .def_readonly("smallest", &DecayRates::smallest,
                    "What the positions can tell [dB/m]: rates below twice as much are upper bounds.")
      .def_readonly("notes", &DecayRates::notes, "A list of str.");
  module.def("decay_rates", &decayRates, py::arg("case"), py::arg("threads") = 0, py::arg("progress") = py::none(),
             R"(Track decay rates after EN 15461, 100 to 5000 Hz, one rail struck. `threads`, `progress` and Ctrl-C
as in run(). Returns DecayRates. Raises CaseError, and RunError where nothing damps the track.)");
}

}  // namespace

void addReceptance(py::module_& module) {
  addReceptanceClass(module);
  module.def("receptance", &compute, py::arg("case"), py::kw_only(), py::arg("at") = std::vector<double>(),
             py::arg("struck") = py::none(), py::arg("lateral") = false, py::arg("one_rail") = false,
             py::arg("endless") = false, py::arg("sleeper") = false, py::arg("lowest") = 50.0,
             py::arg("highest") = 2000.0, py::arg("step") = py::none(), py::arg("quantity") = "receptance",
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             R"(What the track of a case answers to a harmonic force, without a wheelset.

`at`: positions [m] from the sleeper in the middle of the track, none: over it and at midspan.
`struck` [m]: where the rail is struck, None: where it is read. `lateral`: sideways. `one_rail`: one
rail is struck, as by a hammer; else both alike. `endless`: equal bays without end. `sleeper`: a
sleeper by itself on its ballast. `lowest`, `highest`, `step`: frequencies [Hz]; None is 1 Hz, and
endless tracks and sleepers have 24 in each third octave. `quantity`: receptance [m/N], mobility
[m/s/N] or accelerance [m/s2/N]. `threads`, `progress` and Ctrl-C as in run().

Returns a Receptance. Raises CaseError, and RunError where nothing damps an endless track.)");
  addDecay(module);
}

}  // namespace squat::python

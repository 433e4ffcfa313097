#include "analysis/WheelForces.h"

#include <algorithm>
#include <utility>

#include "signals/SignalCatalogue.h"

namespace squat::analysis {
namespace {

// Of the largest force: less is none. The filter of the samples carries a little of what goes before and follows into a
// stretch without contact, with either sign.
constexpr double shareOfNone = 1e-3;

WheelForce wheelForce(std::string wheel, const std::vector<double>& force, const std::vector<double>& time) {
  WheelForce found{std::move(wheel), *std::min_element(force.begin(), force.end()), {}, 0};
  const double limit = shareOfNone * *std::max_element(force.begin(), force.end());
  if (!(found.smallest <= limit)) return found;
  found.smallest = 0;
  const std::size_t count = std::min(force.size(), time.size());
  std::size_t aloft = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(force[i] <= limit)) continue;
    if (!found.liftOff) found.liftOff = time[i];
    ++aloft;
  }
  if (count > 1)
    found.aloft = static_cast<double>(aloft) * (time[count - 1] - time[0]) / static_cast<double>(count - 1);
  return found;
}

}  // namespace

std::vector<WheelForce> wheelForces(const signals::Record& record) {
  namespace names = signals::names;
  const auto onRight = [](const char* name) { return std::string(name) + "_right"; };
  const bool hasRight = record.signal(onRight(names::contactForce)) != nullptr;
  const std::string left = hasRight ? "left wheel" : "wheel", right = "right wheel";
  const std::string second = " of the second wheelset";
  std::vector<WheelForce> wheels;
  const auto add = [&](const std::string& signal, const std::string& wheel) {
    const auto* force = record.signal(signal);
    if (force && !force->empty()) wheels.push_back(wheelForce(wheel, *force, record.time));
  };
  add(names::contactForce, left);
  add(onRight(names::contactForce), right);
  add(names::secondContactForce, left + second);
  add(onRight(names::secondContactForce), right + second);
  return wheels;
}

}  // namespace squat::analysis

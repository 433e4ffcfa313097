// solver/growth/RollingTraffic.h - all wheelsets of the traffic on one rail.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "growth/GrowthState.h"
#include "growth/PassingWheelset.h"
#include "growth/Traffic.h"
#include "statics/UnloadedShape.h"

namespace squat::growth {

// [m] at the ends of the stretch that changes: over `fadingLength` changes fade in and out, over `endEffect` what
// wheels do is not yet what they do farther in. The reference stretch begins behind that, as long as the fading.
inline constexpr double fadingLength = 0.030, endEffect = 0.015;

class RollingTraffic {
 public:
  // `description` as growingCase() makes it. Keeps a reference to the monitor.
  RollingTraffic(const cases::CaseDescription& description, int threads, const std::string& isa, Monitor& monitor);

  // Meshes, equilibria and run-ups of all; `done` gets the share of them that is. False where it was cancelled.
  bool release(const std::function<void(double)>& done);
  GrowthState newRail() const;
  // Before the first passage on a rail: one that is new or was read from a checkpoint, or has been taken back.
  void standOn(const GrowthState& rail);
  // All roll over the rail, one after the other, each over what those before have left: they change it, and the rates
  // are the mean of what they did. False where it was cancelled; the rail is not to be used then.
  bool rollOver(GrowthState& rail);
  // The case's own wheelset, which changes nothing. Nothing where it was cancelled.
  std::optional<Passage> measure(const GrowthState& rail);
  // Where the grinding train has been: takes the layer up.
  bool grind(GrowthState& rail, double depth);

  const SurfaceGrid& grid() const { return grid_; }
  const model::Model& model() const { return wheelsets_.front()->model(); }
  const std::vector<Draw>& draws() const { return draws_; }
  const std::vector<std::unique_ptr<PassingWheelset>>& wheelsets() const { return wheelsets_; }
  PassingWheelset& own() const { return own_ ? *own_ : *wheelsets_.front(); }  // that of the case
  double massPerPassage() const { return mass_; }
  double line() const;  // [m] y on which the case's own wheel runs
  // What wheels meet besides the defect, and with it.
  Field changeOf(const GrowthState& rail) const;
  Field heightsOf(const GrowthState& rail) const;

 private:
  Field risenOf(const GrowthState& rail) const;
  bool settle(GrowthState& rail);  // displacement of what the layer's plastic strain is now

  cases::CaseDescription description_;
  Monitor& monitor_;
  std::vector<Draw> draws_;
  std::vector<std::unique_ptr<PassingWheelset>> wheelsets_;
  std::unique_ptr<PassingWheelset> own_;  // null: the only one of the traffic is that of the case
  SurfaceGrid grid_;
  std::unique_ptr<statics::UnloadedShapes> unloaded_;
  double mass_ = 0;
};

}  // namespace squat::growth

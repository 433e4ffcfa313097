#include "growth/RollingTraffic.h"

#include <algorithm>
#include <utility>

#include "growth/LayerChange.h"

namespace squat::growth {

namespace {

constexpr double followed = 1e-4;  // of what is new in the unloaded shape

plasticity::LayerForces forcesOf(const PassingWheelset& wheelset, plasticity::LayerState& layer) {
  return plasticity::layerForces(wheelset.model().layer, plasticity::layerKernelsFor(wheelset.kernels().name), layer);
}

}  // namespace

RollingTraffic::RollingTraffic(const cases::CaseDescription& description, int threads, const std::string& isa,
                               Monitor& monitor)
    : description_(description), monitor_(monitor), draws_(drawTraffic(description.growth)) {
  for (const auto& draw : draws_) {
    wheelsets_.push_back(std::make_unique<PassingWheelset>(withDraw(description, draw), threads, isa, monitor));
    mass_ += axleMass(wheelsets_.back()->description()) / static_cast<double>(draws_.size());
  }
  const bool same = draws_.size() == 1 && description.motion.torque == 0 &&
                    description.motion.tractionCoefficient == draws_.front().traction;
  if (!same) own_ = std::make_unique<PassingWheelset>(description, threads, isa, monitor);
}

bool RollingTraffic::release(const std::function<void(double)>& done) {
  std::vector<PassingWheelset*> all;
  for (auto& wheelset : wheelsets_) all.push_back(wheelset.get());
  if (own_) all.push_back(own_.get());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i]->release()) return false;
    done(static_cast<double>(i + 1) / static_cast<double>(all.size()));
  }
  const auto& rail = description_.rail;
  grid_ = surfaceGrid(model(), rail.plasticFrom, rail.plasticTo);
  grid_.taper = fadingLength;
  grid_.referenceFrom = grid_.x.front() + endEffect, grid_.referenceTo = grid_.x.front() + endEffect + fadingLength;
  if (model().layer.empty()) return true;
  unloaded_ =
      std::make_unique<statics::UnloadedShapes>(model(), wheelsets_.front()->kernels(), wheelsets_.front()->team());
  return unloaded_->prepare(monitor_);
}

GrowthState RollingTraffic::newRail() const {
  GrowthState rail;
  rail.wear.assign(grid_.size(), 0.0), rail.flow = rail.cut = rail.relaxation = rail.wear;
  rail.rates = {rail.wear, rail.wear};
  rail.layer = plasticity::restState(model().layer);
  if (!model().layer.empty()) rail.displacement.assign(model().stateSize, 0.0);
  return rail;
}

void RollingTraffic::standOn(const GrowthState& rail) {
  if (!unloaded_) return;
  auto layer = rail.layer;
  unloaded_->startFrom(forcesOf(*wheelsets_.front(), layer));
}

bool RollingTraffic::settle(GrowthState& rail) {
  statics::UnloadedShape shape;
  shape.displacement = std::move(rail.displacement);
  unloaded_->follow(forcesOf(*wheelsets_.front(), rail.layer), followed, shape, monitor_);
  rail.displacement = std::move(shape.displacement);
  return !shape.cancelled;
}

Field RollingTraffic::changeOf(const GrowthState& rail) const {
  Field change(rail.wear.size());
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = rail.wear[i] + rail.flow[i];
  Field shape = relativeShape(grid_, change);
  for (std::size_t i = 0; i < shape.size(); ++i) shape[i] += rail.cut[i];
  return shape;
}

Field RollingTraffic::heightsOf(const GrowthState& rail) const {
  Field heights = changeOf(rail);
  const auto& defect = model().scenario.defectSurface;
  for (std::size_t s = 0; s < grid_.x.size(); ++s)
    for (std::size_t line = 0; line < grid_.y.size(); ++line)
      heights[grid_.index(s, line)] += defect.height(grid_.x[s], grid_.y[line]);
  return heights;
}

bool RollingTraffic::rollOver(GrowthState& rail) {
  const double share = 1.0 / static_cast<double>(wheelsets_.size());
  const Field wearBefore = rail.wear, flowBefore = rail.flow;
  rail.layerBefore = rail.layer;
  Field risen = risenOf(rail);
  for (auto& wheelset : wheelsets_) {
    auto passage = wheelset->roll(grid_, {rail.layer, rail.displacement, model(), changeOf(rail), risen});
    if (!passage) return false;
    const Field worn = meanAtNodes(grid_, wheelset->model().surfaces, passage->worn);
    for (std::size_t i = 0; i < worn.size(); ++i) rail.wear[i] -= worn[i];
    if (!unloaded_) continue;
    rail.layer = std::move(passage->layer);
    if (!settle(rail)) return false;
    const Field now = risenOf(rail);
    for (std::size_t i = 0; i < now.size(); ++i) rail.flow[i] += now[i] - risen[i];
    risen = now;
  }
  for (std::size_t i = 0; i < risen.size(); ++i) {
    rail.rates.wear[i] = share * (rail.wear[i] - wearBefore[i]);
    rail.rates.flow[i] = share * (rail.flow[i] - flowBefore[i]);
  }
  rail.passages += static_cast<double>(wheelsets_.size());
  rail.tonnage += static_cast<double>(wheelsets_.size()) * mass_;
  return true;
}

// By the displacement that the plastic strain leaves behind.
Field RollingTraffic::risenOf(const GrowthState& rail) const {
  return unloaded_ ? risenNodes(grid_, model(), rail.displacement) : Field(grid_.size(), 0.0);
}

std::optional<Passage> RollingTraffic::measure(const GrowthState& rail) {
  return own().roll(grid_, {rail.layer, rail.displacement, model(), changeOf(rail), risenOf(rail)});
}

bool RollingTraffic::grind(GrowthState& rail, double depth) {
  const Field heights = heightsOf(rail);
  for (std::size_t i = 0; i < heights.size(); ++i) rail.cut[i] += std::min(heights[i] + depth, 0.0) - heights[i];
  if (!unloaded_) return true;
  grindLayer(model().layer, model().blocks[model().rail], depth, rail.layer);
  rail.layerBefore = rail.layer;
  return settle(rail);
}

double RollingTraffic::line() const { return own().model().surfaces.touchY; }

}  // namespace squat::growth

#include <cmath>

#include "model/Model.h"

namespace squat::model {

namespace {

// Radius and y as in the section of the wheel body.
std::string partOfWheelset(const scenario::Wheelset& w, double radius, double y) {
  const double face = w.hubWidth / 2;
  constexpr double slack = 1e-6;  // [m]
  if (radius > w.rimInnerRadius - slack) return "rim of the wheel (wheelset.rim_inner_radius, wheelset.rim_width)";
  if (radius > w.hubRadius - slack)
    return "web of the wheel (wheelset.web_thickness, wheelset.web_hub_thickness, wheelset.web_offset)";
  const double webHalf = (w.webHubThickness > 0 ? w.webHubThickness : w.webThickness) / 2;
  if (std::abs(y - w.webOffset) < webHalf + slack)
    return "hub under the web (wheelset.web_hub_thickness, wheelset.web_thickness)";
  if (std::abs(y) < face - slack) return "hub (wheelset.hub_radius, wheelset.seat_radius)";
  if (y < 0) return "axle (wheelset.axle_radius, wheelset.bore_radius)";
  if (y < w.shoulderEnd - slack)
    return "shoulder of the axle (wheelset.shoulder_radius, wheelset.shoulder_end, wheelset.bore_radius)";
  return "journal (wheelset.journal_radius, wheelset.bore_radius)";
}

}  // namespace

std::string partName(const Model& model, std::size_t index) {
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const auto& block = model.blocks[b];
    if (index < block.offset || index >= block.offset + block.size()) continue;
    const int which = static_cast<int>(b);
    if (which == model.rail) return "rail (mesh.contact_size, mesh.rolling_size, mesh.section_size)";
    if (which == model.rim) return "tread of the wheel (mesh.contact_size, mesh.rolling_size)";
    if (which != model.body) return "sleeper (sleeper.height, sleeper.width)";
    const auto& p = block.section.nodes[block.unknownAt(index).node];
    return partOfWheelset(model.scenario.wheelset, p[0], p[1]);
  }
  return index >= model.boxX && index <= model.boxZ ? "axle box (wheelset.axle_box_mass, wheelset.bearing_stiffness)"
                                                    : "sprung mass (suspension.sprung_mass)";
}

}  // namespace squat::model

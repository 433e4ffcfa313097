#include "case/ParameterLevels.h"

#include <algorithm>

namespace squat::cases {

const std::vector<std::string_view>& keysOfLevel(Level level) {
  static const std::vector<std::string_view> basic{"title",
                                                   "defect.shape",
                                                   "defect.length",
                                                   "defect.depth",
                                                   "defect.file",
                                                   "motion.speed",
                                                   "track.preset",
                                                   "track.sleeper_spacing",
                                                   "pad.stiffness",
                                                   "pad.damping",
                                                   "track.defect_from_sleeper",
                                                   "wheelset.preset",
                                                   "suspension.sprung_mass",
                                                   "mesh.preset"};
  // Penalties, damping and sizes of the model itself; stiffness that hardly reaches the axle box.
  static const std::vector<std::string_view> expert{"defect.level",
                                                    "defect.move_nodes",
                                                    "motion.angular_velocity",
                                                    "motion.torque_ramp",
                                                    "motion.run_up",
                                                    "motion.beyond",
                                                    "motion.gravity",
                                                    "contact.normal_penalty",
                                                    "contact.tangential_penalty",
                                                    "damping.fraction",
                                                    "damping.beta",
                                                    "track.length",
                                                    "track.rail_ends",
                                                    "rail.poisson_ratio",
                                                    "rail.density",
                                                    "rail.tangent_modulus",
                                                    "rail.plastic_depth",
                                                    "rail.hardening",
                                                    "rail.irregularity_seed",
                                                    "rail.irregularity_position",
                                                    "pad.longitudinal_stiffness",
                                                    "pad.longitudinal_damping",
                                                    "pad.lateral_stiffness",
                                                    "pad.lateral_damping",
                                                    "pad.length",
                                                    "pad.width",
                                                    "sleeper.poisson_ratio",
                                                    "ballast.longitudinal_stiffness",
                                                    "ballast.longitudinal_damping",
                                                    "ballast.lateral_stiffness",
                                                    "ballast.lateral_damping",
                                                    "wheelset.poisson_ratio",
                                                    "wheelset.damping_ratio",
                                                    "wheelset.damping_limit",
                                                    "suspension.longitudinal_stiffness",
                                                    "suspension.longitudinal_damping",
                                                    "suspension.lateral_stiffness",
                                                    "suspension.lateral_damping",
                                                    "bogie.pitch_radius",
                                                    "mesh.contact_size",
                                                    "mesh.rolling_size",
                                                    "mesh.far_size",
                                                    "mesh.section_growth",
                                                    "mesh.section_size",
                                                    "mesh.band_half_width",
                                                    "mesh.coarse_web",
                                                    "mesh.fine_before",
                                                    "mesh.fine_start",
                                                    "mesh.zone_before",
                                                    "mesh.zone_behind",
                                                    "mesh.wheel_sectors",
                                                    "mesh.rim_depth",
                                                    "mesh.selective_inertia",
                                                    "output.time_step",
                                                    "output.cwt_voices"};
  static const std::vector<std::string_view> none;
  return level == Level::basic ? basic : level == Level::expert ? expert : none;
}

Level levelOf(std::string_view key) {
  for (const Level level : {Level::basic, Level::expert})
    if (const auto& keys = keysOfLevel(level); std::find(keys.begin(), keys.end(), key) != keys.end()) return level;
  return Level::advanced;
}

}  // namespace squat::cases

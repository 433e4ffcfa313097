// widgets/studio/profile/ProfileModel.h - the defect of a case as the profile editor shows it. No windows here.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::studio {

// Positions [m] are those of the profile's own points (as measured) for a sampled profile, and from the deepest point
// for analytic shapes. Heights [m], up positive, as they are run: times the height scale, before levelling.
struct ProfileView {
  std::vector<cases::ProfilePoint> surface;    // the rail's surface along the line on which the wheel runs
  std::vector<cases::ProfilePoint> wheelPath;  // of a rigid wheel, relative to its path on smooth rail
  std::vector<cases::ProfilePoint> removed;    // ends of the line that levelling removes; empty where that is zero
  std::vector<cases::ProfilePoint> handles;    // points that can be dragged; empty for analytic shapes
  std::vector<double> sleepers;                // [m] centres within sight
  double sleeperWidth = 0;                     // [m]
  double shift = 0;                            // [m] own position of the deepest point, from which results count
};

ProfileView profileView(const cases::CaseDescription& description);

// What the height scale makes of the points: table, handles and curve show the same heights.
double shownScale(const cases::Defect& defect);
// The point of the case that is shown as `seen`. With a height scale of zero the height stays `before`.
cases::ProfilePoint pointOfCase(const cases::Defect& defect, cases::ProfilePoint seen, double before = 0);
// What the user has to know to read the heights and positions that are shown; empty: nothing.
QString profileNotes(const cases::Defect& defect);

// The same defect as sampled points (at most 200), so that they can be dragged.
cases::CaseDescription asPoints(const cases::CaseDescription& description);

// Changes of a sampled profile; positions stay at least `minimumGap` apart, so the result is always a valid profile.
inline constexpr double minimumGap = 1e-5;  // [m]
std::vector<cases::ProfilePoint> movedPoint(std::vector<cases::ProfilePoint> points, std::size_t index,
                                            cases::ProfilePoint to);
std::vector<cases::ProfilePoint> withPoint(std::vector<cases::ProfilePoint> points, cases::ProfilePoint added);
std::vector<cases::ProfilePoint> withoutPoint(std::vector<cases::ProfilePoint> points, std::size_t index);

// [m] Height of the curve through the points, straight between them; beyond the ends, that of the end.
double heightOn(const std::vector<cases::ProfilePoint>& points, double position);

// Which point of `after` is the point `index` of `before`, moved or not. Nothing where it is gone, and where more than
// one point differs: the profile was replaced as a whole, and no point of it is the one before.
std::optional<std::size_t> pointAfter(const std::vector<cases::ProfilePoint>& before,
                                      const std::vector<cases::ProfilePoint>& after, std::size_t index);

// Nearest multiple of `step`; `value` itself where the step is not positive.
double snapped(double value, double step);

}  // namespace squat::studio

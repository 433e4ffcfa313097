#include "render/SyntheticSurface.h"

#include <array>
#include <cmath>
#include <utility>

namespace squat::tests {
namespace {

using Outline = std::vector<std::pair<double, double>>;
constexpr double radius = 0.46;

class Builder {
 public:
  explicit Builder(results::SurfaceMesh& mesh) : mesh_(mesh) {}

  void startPart(const std::string& name) { mesh_.partNames.push_back(name); }

  std::int32_t point(double x, double y, double z) {
    for (double value : {x, y, z}) mesh_.points.push_back(static_cast<float>(value));
    return static_cast<std::int32_t>(mesh_.points.size() / 3 - 1);
  }

  void quad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    for (std::int32_t corner : {a, b, c, d}) mesh_.quads.push_back(corner);
    mesh_.part.push_back(static_cast<std::uint8_t>(mesh_.partNames.size() - 1));
  }

  // Joins each ring of points to the next one.
  void skin(const std::vector<std::vector<std::int32_t>>& rings, bool closed) {
    for (std::size_t i = 0; i + (closed ? 0 : 1) < rings.size(); ++i) {
      const auto& a = rings[i];
      const auto& b = rings[(i + 1) % rings.size()];
      for (std::size_t j = 0; j < a.size(); ++j) quad(a[j], a[(j + 1) % a.size()], b[(j + 1) % a.size()], b[j]);
    }
  }

  void extrude(const Outline& yz, const std::vector<double>& stations) {
    std::vector<std::vector<std::int32_t>> rings;
    for (double x : stations) {
      rings.emplace_back();
      for (const auto& [y, z] : yz) rings.back().push_back(point(x, y, z));
    }
    skin(rings, false);
  }

  void revolve(const Outline& yr, double x0, double z0, int sectors) {
    std::vector<std::vector<std::int32_t>> rings;
    for (int i = 0; i < sectors; ++i) {
      const double angle = 2 * M_PI * i / sectors;
      rings.emplace_back();
      for (const auto& [y, r] : yr)
        rings.back().push_back(point(x0 + r * std::sin(angle), y, z0 - r * std::cos(angle)));
    }
    skin(rings, true);
  }

  // A plane patch: `place` maps a first coordinate in [from, to] and a share 0..1 to a point.
  template <class Location>
  void plate(double from, double to, int columns, int rows, const Location& location) {
    std::vector<std::vector<std::int32_t>> grid;
    for (int i = 0; i <= columns; ++i) {
      grid.emplace_back();
      for (int j = 0; j <= rows; ++j) {
        const auto at = location(from + (to - from) * i / columns, static_cast<double>(j) / rows);
        grid.back().push_back(point(at[0], at[1], at[2]));
      }
    }
    for (std::size_t i = 0; i + 1 < grid.size(); ++i)
      for (std::size_t j = 0; j + 1 < grid[i].size(); ++j)
        quad(grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]);
  }

  void spring(std::array<double, 6> ends) {
    for (double value : ends) mesh_.springs.push_back(static_cast<float>(value));
  }

 private:
  results::SurfaceMesh& mesh_;
};

std::vector<double> railStations() {
  std::vector<double> stations;
  for (double x = -1.5; x < 1.5;) {
    stations.push_back(x);
    x += std::abs(x) < 0.06 ? 0.004 : 0.03;
  }
  stations.push_back(1.5);
  return stations;
}

Outline railOutline() {
  Outline outline;
  for (int i = 0; i <= 16; ++i) outline.emplace_back(-0.032 + 0.004 * i, -0.5 * std::pow(-0.032 + 0.004 * i, 2) / 0.3);
  for (const auto& corner : Outline{{0.035, -0.008},
                                    {0.035, -0.04},
                                    {0.008, -0.05},
                                    {0.008, -0.13},
                                    {0.07, -0.15},
                                    {0.07, -0.159},
                                    {-0.07, -0.159},
                                    {-0.07, -0.15},
                                    {-0.008, -0.13},
                                    {-0.008, -0.05},
                                    {-0.035, -0.04},
                                    {-0.035, -0.008}})
    outline.push_back(corner);
  return outline;
}

}  // namespace

results::SurfaceMesh syntheticSurface(double wheelAt) {
  results::SurfaceMesh mesh;
  Builder builder(mesh);
  builder.startPart("rail");
  builder.extrude(railOutline(), railStations());
  builder.startPart("sleepers");
  for (double centre : {-1.2, -0.6, 0.0, 0.6, 1.2}) {
    builder.extrude({{-0.63, -0.17}, {0.4, -0.17}, {0.4, -0.32}, {-0.63, -0.32}}, {centre - 0.13, centre + 0.13});
    for (double side : {-0.13, 0.13}) {
      const auto a = builder.point(centre + side, -0.63, -0.17), b = builder.point(centre + side, 0.4, -0.17);
      const auto c = builder.point(centre + side, 0.4, -0.32), d = builder.point(centre + side, -0.63, -0.32);
      builder.quad(a, b, c, d);
    }
    for (double x : {centre - 0.06, centre + 0.06}) {
      for (double y : {-0.05, 0.05}) builder.spring({x, y, -0.159, x, y, -0.17});
      for (double y : {-0.5, -0.2, 0.1, 0.35}) builder.spring({x, y, -0.32, x, y, -0.44});
    }
  }
  builder.startPart("wheel rim");
  Outline rim;
  for (int i = 0; i <= 20; ++i) rim.emplace_back(-0.0675 + 0.00675 * i, radius);
  rim.emplace_back(0.0675, 0.395);
  rim.emplace_back(-0.0675, 0.395);
  builder.revolve(rim, wheelAt, radius, 240);
  builder.startPart("wheel body and axle");
  builder.revolve({{0.014, 0.395},
                   {0.014, 0.14},
                   {0.0875, 0.14},
                   {0.0875, 0.08},
                   {0.15, 0.08},
                   {0.15, 0.065},
                   {0.33, 0.065},
                   {0.33, 0.001},
                   {-0.75, 0.001},
                   {-0.75, 0.08},
                   {-0.0875, 0.08},
                   {-0.0875, 0.14},
                   {-0.014, 0.14},
                   {-0.014, 0.395}},
                  wheelAt, radius, 64);
  // Inner faces on y = 0: below the rail's top and above the tread.
  builder.startPart("rail cut");
  builder.plate(-0.06, 0.06, 60, 16, [](double x, double share) { return std::array{x, 0.0, -0.036 * share}; });
  builder.startPart("wheel cut");
  builder.plate(-0.14, 0.14, 140, 20, [&](double angle, double share) {
    const double r = radius - 0.06 * share, turned = angle - 0.204 / radius;
    return std::array{wheelAt + r * std::sin(-turned), 0.0, radius - r * std::cos(turned)};
  });
  builder.spring({wheelAt, 0.25, radius + 0.07, wheelAt, 0.25, radius + 0.35});
  return mesh;
}

results::SurfaceSnapshot syntheticSnapshot(const results::SurfaceMesh& surface, double wheelAt, double travel) {
  results::SurfaceSnapshot snapshot;
  snapshot.name = "impact";
  snapshot.wheelTravel = travel;
  snapshot.wheelRotation = travel / radius;
  snapshot.position = wheelAt + travel;
  snapshot.time = travel / 30;
  const double contact = wheelAt + travel;
  const double c = std::cos(snapshot.wheelRotation), s = std::sin(snapshot.wheelRotation);
  std::vector<bool> rolling(surface.points.size() / 3, false);
  for (std::size_t quad = 0; quad < surface.part.size(); ++quad)
    for (std::size_t corner = 0; corner < 4; ++corner)
      if (surface.partNames[surface.part[quad]].rfind("wheel", 0) == 0)
        rolling[static_cast<std::size_t>(surface.quads[4 * quad + corner])] = true;
  for (std::size_t i = 0; i < rolling.size(); ++i) {
    double x = static_cast<double>(surface.points[3 * i]), y = static_cast<double>(surface.points[3 * i + 1]);
    double z = static_cast<double>(surface.points[3 * i + 2]);
    if (rolling[i]) {
      const double dx = x - wheelAt, dz = z - radius;
      x = contact + c * dx + s * dz;
      z = radius - s * dx + c * dz;
    }
    const double bell = std::exp(
        -(std::pow((x - contact) / 0.011, 2) + std::pow(y / 0.009, 2) + std::pow((std::abs(z) - 0.004) / 0.009, 2)));
    snapshot.vonMises.push_back(static_cast<float>(620e6 * bell + 12e6));
    snapshot.displacement.push_back(0);
    snapshot.displacement.push_back(0);
    snapshot.displacement.push_back(static_cast<float>(rolling[i] ? 0 : -1e-4 * std::exp(-std::abs(x - contact))));
  }
  return snapshot;
}

}  // namespace squat::tests

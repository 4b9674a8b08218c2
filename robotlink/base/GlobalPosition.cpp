// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/GlobalPosition.h"

#include <cmath>

namespace robotlink {
namespace {

// The ellipsoid of WGS 84.
constexpr double kEquator = 6378137.0, kFlattening = 1 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);

/// Distance from the surface to the Earth's axis along the vertical, m (the prime vertical radius of
/// curvature).
double verticalRadius(double latitude) {
  const double sine = std::sin(latitude);
  return kEquator / std::sqrt(1 - kEccentricity2 * sine * sine);
}

/// A position in the Earth-centered frame: x through latitude and longitude 0, z through the north pole.
Vector3 centered(double latitude, double longitude, double altitude) {
  const double radius = verticalRadius(latitude);
  const double toAxis = (radius + altitude) * std::cos(latitude);
  return {toAxis * std::cos(longitude), toAxis * std::sin(longitude),
          (radius * (1 - kEccentricity2) + altitude) * std::sin(latitude)};
}

}  // namespace

GlobalPosition globalPosition(const GlobalPosition& origin, const Vector3& eastNorthUp) {
  const double latitude = radians(origin.latitude), longitude = radians(origin.longitude);
  const Vector3 east(-std::sin(longitude), std::cos(longitude), 0);
  const Vector3 up(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                   std::sin(latitude));
  const Vector3 north = up.cross(east);
  const Vector3 place = centered(latitude, longitude, origin.altitude) + east * eastNorthUp.x() +
                        north * eastNorthUp.y() + up * eastNorthUp.z();
  // Fixed-point iteration; near the ground it converges to less than a micrometer in three rounds.
  const double toAxis = place.head<2>().norm();
  double found = latitude;
  for (int round = 0; round < 6; ++round)
    found = std::atan2(place.z() + kEccentricity2 * verticalRadius(found) * std::sin(found), toAxis);
  // Measured along the vertical, which is well defined at the poles, too.
  const double foundLongitude = toAxis > 0 ? std::atan2(place.y(), place.x()) : longitude;
  const Vector3 vertical(std::cos(found) * std::cos(foundLongitude),
                         std::cos(found) * std::sin(foundLongitude), std::sin(found));
  const double altitude = (place - centered(found, foundLongitude, 0)).dot(vertical);
  return {degrees(found), degrees(foundLongitude), altitude};
}

}  // namespace robotlink

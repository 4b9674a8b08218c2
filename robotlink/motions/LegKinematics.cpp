// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/LegKinematics.h"

#include <algorithm>
#include <cmath>

namespace robotlink {
namespace {

struct SpreadLimit {
  double swingDeg, foreDeg, hindDeg;
};
constexpr std::array<SpreadLimit, 12> kSpreadLimits{{{-117, 2.6, 3.0},
                                                     {-90, -2, -1.3},
                                                     {-60, -6.3, -6.0},
                                                     {-30, -10.5, -9.5},
                                                     {-15, -11, -11},
                                                     {0, -11, -11},
                                                     {30, -9, -9.5},
                                                     {45, -7.5, -7.5},
                                                     {60, -5.5, -5.0},
                                                     {90, -0.7, -0.5},
                                                     {117, 2.0, 1.0},
                                                     {120, 2.0, 1.0}}};
constexpr double kSwingLimit = radians(117);
constexpr double kSpreadMaximum = radians(89);
constexpr double kKneeMinimum = radians(-27), kKneeMaximum = radians(147);

/// A vector in directions that are the same for all legs: away from the body's center, outwards, down.
Vector3 mirroredLeg(Leg leg, const Vector3& v) {
  return {isFore(leg) ? v.x() : -v.x(), isLeft(leg) ? v.y() : -v.y(), -v.z()};
}

double clampedArc(double value, bool& reached) {
  if (value < -1 || value > 1) reached = false;
  return std::clamp(value, -1.0, 1.0);
}

}  // namespace

Vector3 LegKinematics::hipInBody(Leg leg) const {
  return {isFore(leg) ? dimensions_.hipX : -dimensions_.hipX,
          isLeft(leg) ? dimensions_.hipY : -dimensions_.hipY, 0};
}

Vector3 LegKinematics::pawInHip(Leg leg, const LegAngles& angles) const {
  const double bend = angles.knee + shankAngle(leg);
  const double away = dimensions_.kneeAway + shank(leg) * std::sin(bend);
  const double down = dimensions_.kneeDown + shank(leg) * std::cos(bend);
  const double s2 = std::sin(angles.spread), c2 = std::cos(angles.spread);
  const double outside = dimensions_.pawOffset * c2 + down * s2;
  const double lower = down * c2 - dimensions_.pawOffset * s2;
  const double s1 = std::sin(angles.swing), c1 = std::cos(angles.swing);
  return mirroredLeg(leg, {away * c1 + lower * s1, outside, lower * c1 - away * s1});
}

LegKinematics::Solution LegKinematics::anglesFor(Leg leg, const Vector3& pawInHip) const {
  const Vector3 target = mirroredLeg(leg, pawInHip);
  const double offset = dimensions_.pawOffset;
  const double thigh = std::hypot(dimensions_.kneeAway, dimensions_.kneeDown);
  const double thighAngle = std::atan2(dimensions_.kneeAway, dimensions_.kneeDown);
  Solution solution;

  // The knee alone determines the distance of the paw from the hip.
  const double squared = target.squaredNorm() - offset * offset;
  const double cosine = (squared - thigh * thigh - shank(leg) * shank(leg)) / (2 * thigh * shank(leg));
  const double bend = thighAngle + std::acos(clampedArc(cosine, solution.reached));
  const double away = dimensions_.kneeAway + shank(leg) * std::sin(bend);
  const double down = dimensions_.kneeDown + shank(leg) * std::cos(bend);

  // J1's axis is parallel to y, so J2 alone determines how far outside the paw is.
  const double radius = std::hypot(offset, down);
  const double spread =
      std::asin(clampedArc(target.y() / radius, solution.reached)) - std::atan2(offset, down);
  const double lower = down * std::cos(spread) - offset * std::sin(spread);
  const double swing = normalizedAngle(std::atan2(target.x(), target.z()) - std::atan2(away, lower));

  const LegAngles angles{swing, spread, bend - shankAngle(leg)};
  solution.angles = limited(leg, angles);
  if (solution.angles != angles) solution.reached = false;
  return solution;
}

double LegKinematics::minimumSpread(Leg leg, double swing) {
  const double swingDeg = std::clamp(degrees(swing), -117.0, 117.0);
  std::size_t i = 1;
  while (kSpreadLimits[i].swingDeg < swingDeg) ++i;
  const SpreadLimit &from = kSpreadLimits[i - 1], &to = kSpreadLimits[i];
  const double part = (swingDeg - from.swingDeg) / (to.swingDeg - from.swingDeg);
  const double low = isFore(leg) ? from.foreDeg : from.hindDeg;
  const double high = isFore(leg) ? to.foreDeg : to.hindDeg;
  return radians(low + (high - low) * part);
}

LegAngles LegKinematics::limited(Leg leg, const LegAngles& angles) {
  LegAngles result;
  result.swing = std::clamp(angles.swing, -kSwingLimit, kSwingLimit);
  result.spread = std::clamp(angles.spread, minimumSpread(leg, result.swing), kSpreadMaximum);
  result.knee = std::clamp(angles.knee, kKneeMinimum, kKneeMaximum);
  return result;
}

}  // namespace robotlink

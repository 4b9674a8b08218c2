// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/team/TeamBallFusion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace modules {

using Eigen::Matrix2d;
using robotlink::Vector2;

namespace {

/// The weights that covariance intersection tries.
constexpr int kWeights = 20;

/// Fuses a report into a ball with the weight that makes the trace of the covariance smallest.
void intersect(FusedBall& ball, const BallReport& report) {
  const Matrix2d a = ball.covariance.inverse(), b = report.covariance.inverse();
  double best = 1, least = ball.covariance.trace();
  for (int i = 0; i < kWeights; ++i) {
    const double weight = static_cast<double>(i) / kWeights;
    const double trace = Matrix2d(weight * a + (1 - weight) * b).inverse().trace();
    if (trace >= least) continue;
    least = trace;
    best = weight;
  }
  const Matrix2d covariance = Matrix2d(best * a + (1 - best) * b).inverse();
  ball.position = covariance * (best * a * ball.position + (1 - best) * b * report.position);
  ball.velocity = best * ball.velocity + (1 - best) * report.velocity;
  ball.covariance = covariance;
  if (best < 1) ball.robots.push_back(report.robot);
}

}  // namespace

double FusedBall::deviation() const {
  return std::sqrt(0.5 * covariance.trace());
}

Matrix2d ballCovariance(const Vector2& ballInField, double ballDeviation,
                        const robotlink::Pose2& robotInField, double positionDeviation,
                        double headingDeviation) {
  const Vector2 to = ballInField - robotInField.translation();
  const double round = ballDeviation * ballDeviation + positionDeviation * positionDeviation + 1e-6;
  // Turning the robot moves the ball perpendicular to the ray.
  const Vector2 across = std::min(1.0, headingDeviation) * Vector2(-to.y(), to.x());
  return Matrix2d::Identity() * round + across * across.transpose();
}

BallReport TeamBallFusion::predicted(const BallReport& report) const {
  BallReport now = report;
  const double speed = report.velocity.norm(), age = std::max(0.0, report.age);
  if (speed > 0) {
    now.position += report.velocity * (options_.roll.wayAfter(speed, age) / speed);
    now.velocity *= options_.roll.speedAfter(speed, age) / speed;
  }
  const double drift = options_.drift * age;
  now.covariance += Matrix2d::Identity() * drift * drift;
  return now;
}

bool TeamBallFusion::agree(const BallReport& a, const BallReport& b) const {
  const Vector2 off = a.position - b.position;
  const Matrix2d covariance = a.covariance + b.covariance;
  return off.dot(covariance.inverse() * off) <= options_.gate * options_.gate;
}

std::optional<FusedBall> TeamBallFusion::fuse(std::span<const BallReport> reports) const {
  std::vector<BallReport> recent;
  for (const BallReport& report : reports)
    if (report.age <= options_.memory && report.position.allFinite()) recent.push_back(predicted(report));
  const BallReport* center = nullptr;
  double most = 0;
  for (const BallReport& report : recent) {
    double information = 0;
    for (const BallReport& other : recent)
      if (agree(report, other)) information += 1 / other.covariance.trace();
    // Among equals the most certain one.
    information += 1e-3 / report.covariance.trace();
    if (information <= most) continue;
    most = information;
    center = &report;
  }
  if (center == nullptr) return std::nullopt;
  FusedBall ball{center->position, center->velocity, center->covariance, {center->robot}};
  for (const BallReport& report : recent)
    if (&report != center && agree(report, *center)) intersect(ball, report);
  std::ranges::sort(ball.robots);
  return ball;
}

}  // namespace modules

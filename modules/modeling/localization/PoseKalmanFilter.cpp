// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/localization/PoseKalmanFilter.h"

#include <algorithm>
#include <cmath>

namespace modules {

using Eigen::Matrix3d;
using Eigen::RowVector3d;
using robotlink::normalizedAngle;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// Goals have no exact position, because posts and robots hide parts of them.
constexpr double kGoalFactor = 2;
/// Two hypotheses nearer than this are one, m and rad.
constexpr double kSamePlace = 0.3, kSameHeading = 0.35;
/// Landmarks nearer to each other than this do not determine a pose, m.
constexpr double kMinSeparation = 0.8;
/// The deviation of an unknown pose, m and rad.
constexpr double kUnknown = 2;

}  // namespace

PoseKalmanFilter::PoseKalmanFilter(const robotlink::FieldDescription& field, const Options& options)
    : options_(options), edges_(field), halfLength_(0.5 * field.length), halfWidth_(0.5 * field.width) {
  summarize();
}

void PoseKalmanFilter::startAt(const Pose2& pose, double deviation) {
  hypotheses_ = {{pose, Matrix3d(Matrix3d::Identity() * deviation * deviation), 1}};
  memory_.clear();
  summarize();
}

void PoseKalmanFilter::keepOnField(Pose2& pose) const {
  pose.x = std::clamp(pose.x, -halfLength_, halfLength_);
  pose.y = std::clamp(pose.y, -halfWidth_, halfWidth_);
}

void PoseKalmanFilter::predict(Hypothesis& hypothesis, const Pose2& step, bool shaken) const {
  const double c = std::cos(hypothesis.pose.heading), s = std::sin(hypothesis.pose.heading);
  Matrix3d transition = Matrix3d::Identity();
  transition(0, 2) = -s * step.x - c * step.y;
  transition(1, 2) = c * step.x - s * step.y;
  const double drift = (shaken ? 10 : 1) * options_.driftNoise;
  const double way = options_.walkNoise * std::sqrt(std::hypot(step.x, step.y)) + drift;
  const double turn = options_.turnNoise * std::sqrt(std::abs(step.heading)) + drift;
  hypothesis.covariance = transition * hypothesis.covariance * transition.transpose();
  hypothesis.covariance.diagonal() += Eigen::Vector3d(way * way, way * way, turn * turn);
  hypothesis.pose = hypothesis.pose * step;
  keepOnField(hypothesis.pose);
}

double PoseKalmanFilter::correct(Hypothesis& hypothesis, const RowVector3d& row, double difference,
                                 double deviation) const {
  // Only a part of the information is new, as if the measurement were less exact.
  const double noise = deviation * deviation / options_.evidence;
  const Eigen::Vector3d spread = hypothesis.covariance * row.transpose();
  const double variance = row * spread;
  const double off = difference * difference / (variance + deviation * deviation);
  const double bounded = std::min(off, options_.gate * options_.gate);
  if (off <= options_.gate * options_.gate) {
    const Eigen::Vector3d gain = spread / (variance + noise);
    hypothesis.pose.x += gain.x() * difference;
    hypothesis.pose.y += gain.y() * difference;
    hypothesis.pose.heading = normalizedAngle(hypothesis.pose.heading + gain.z() * difference);
    keepOnField(hypothesis.pose);
    hypothesis.covariance -= gain * spread.transpose();
  }
  return std::exp(-0.5 * options_.evidence * bounded);
}

double PoseKalmanFilter::correctByLandmark(Hypothesis& hypothesis, const LandmarkMeasurement& seen) const {
  const double doubt = (seen.isGoal ? kGoalFactor : 1) * (2 - seen.confidence);
  const auto toLandmark = [&] { return Vector2(seen.position - hypothesis.pose.translation()); };
  Vector2 to = toLandmark();
  const double square = std::max(0.01, to.squaredNorm());
  const double bearing = normalizedAngle(seen.bearing - std::atan2(to.y(), to.x()) + hypothesis.pose.heading);
  double likelihood = correct(hypothesis, {to.y() / square, -to.x() / square, -1}, bearing,
                              doubt * options_.bearingDeviation);
  to = toLandmark();
  const double distance = std::max(0.1, to.norm());
  likelihood *= correct(hypothesis, {-to.x() / distance, -to.y() / distance, 0}, seen.distance - distance,
                        doubt * (options_.distanceDeviation * seen.distance + 0.05));
  return likelihood;
}

double PoseKalmanFilter::correctByLine(Hypothesis& hypothesis, const LineMeasurement& point) const {
  const Vector2 inField = hypothesis.pose * point.inRobot;
  const auto edge = edges_.nearestEdge(inField, point.direction + hypothesis.pose.heading);
  const double deviation = options_.lineDeviation + options_.lineDeviationPerMeter * point.inRobot.norm();
  if (!edge) return std::exp(-0.5 * options_.evidence * options_.gate * options_.gate);
  const Vector2 along = (edge->end - edge->start).normalized();
  const Vector2 normal(-along.y(), along.x());
  // The motion of the point when the robot turns.
  const Vector2 arm = inField - hypothesis.pose.translation();
  const double turning = normal.dot(Vector2(-arm.y(), arm.x()));
  return correct(hypothesis, {normal.x(), normal.y(), turning}, -normal.dot(inField - edge->start),
                 deviation);
}

void PoseKalmanFilter::addHypothesis(const Pose2& pose, double distance) {
  Hypothesis added{pose, Matrix3d::Zero(), wasCarried_ ? 1 : options_.newWeight};
  keepOnField(added.pose);
  if ((added.pose.translation() - pose.translation()).norm() > 0.4) return;
  const double deviation = 0.1 + options_.distanceDeviation * distance;
  const double turn = 2 * options_.bearingDeviation + 0.1;
  added.covariance.diagonal() = Eigen::Vector3d(deviation * deviation, deviation * deviation, turn * turn);
  const bool known = std::ranges::any_of(hypotheses_, [&](const auto& one) { return areSame(one, added); });
  if (known) return;
  hypotheses_.push_back(added);
  wasCarried_ = false;
}

void PoseKalmanFilter::addHypotheses(const Pose2& robotInOdometry) {
  const auto& all = memory_.sightings();
  const Pose2 odometryInRobot = robotInOdometry.inverse();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if ((all[i].position - all[j].position).norm() < kMinSeparation) continue;
      const Vector2 a = odometryInRobot * all[i].inOdometry, b = odometryInRobot * all[j].inOdometry;
      // Distances that contradict each other are those of landmarks seen before and after a kidnapping.
      const double apart = (all[i].position - all[j].position).norm();
      if (std::abs((a - b).norm() - apart) > 0.3 * apart + 0.2) continue;
      addHypothesis(LandmarkMemory::poseFrom(all[i].position, a, all[j].position, b),
                    std::max(a.norm(), b.norm()));
    }
  }
}

bool PoseKalmanFilter::areSame(const Hypothesis& a, const Hypothesis& b) const {
  return (a.pose.translation() - b.pose.translation()).norm() < kSamePlace &&
         std::abs(normalizedAngle(a.pose.heading - b.pose.heading)) < kSameHeading;
}

void PoseKalmanFilter::mergeHypotheses() {
  std::ranges::stable_sort(hypotheses_, std::ranges::greater(), &Hypothesis::weight);
  std::vector<Hypothesis> kept;
  for (const Hypothesis& one : hypotheses_) {
    const auto same = std::ranges::find_if(kept, [&](const auto& other) { return areSame(one, other); });
    if (same != kept.end())
      same->weight += one.weight;
    else if (one.weight >= options_.minimumWeight &&
             kept.size() < static_cast<std::size_t>(std::max(1, options_.maximumHypotheses)))
      kept.push_back(one);
  }
  hypotheses_ = std::move(kept);
}

void PoseKalmanFilter::normalize() {
  double sum = 0;
  for (const Hypothesis& one : hypotheses_) sum += one.weight;
  for (Hypothesis& one : hypotheses_)
    one.weight = sum > 0 ? one.weight / sum : 1 / static_cast<double>(hypotheses_.size());
}

void PoseKalmanFilter::summarize() {
  if (hypotheses_.empty()) {
    estimate_ = {{}, kUnknown, robotlink::kPi};
    return;
  }
  const Hypothesis& best = hypotheses_.front();
  // The other hypotheses make the estimate doubtful, as if they were a meter and a radian away.
  const double elsewhere = 1 - best.weight;
  estimate_.robotInField = best.pose;
  estimate_.positionDeviation = std::sqrt(0.5 * (best.covariance(0, 0) + best.covariance(1, 1)) + elsewhere);
  estimate_.headingDeviation = std::sqrt(best.covariance(2, 2) + elsewhere);
}

void PoseKalmanFilter::update(const Frame& frame) {
  const Pose2 step = hasOdometry_ ? odometry_.inverse() * frame.robotInOdometry : Pose2{};
  odometry_ = frame.robotInOdometry;
  hasOdometry_ = true;
  if (frame.carried) {
    // The poses before say nothing about those after.
    memory_.clear();
    wasCarried_ = true;
  }
  memory_.add(frame.time, frame.robotInOdometry, frame.landmarks, options_.memory);
  for (Hypothesis& one : hypotheses_) predict(one, step, frame.shaken);
  if (!frame.landmarks.empty()) addHypotheses(frame.robotInOdometry);
  const auto wanted = static_cast<std::size_t>(std::max(0, options_.linePoints));
  const std::size_t count = std::min(frame.lines.size(), wanted);
  for (Hypothesis& one : hypotheses_) {
    for (const LandmarkMeasurement& seen : frame.landmarks) one.weight *= correctByLandmark(one, seen);
    for (std::size_t i = 0; i < count; ++i)
      one.weight *= std::pow(correctByLine(one, frame.lines[i * frame.lines.size() / count]), 0.2);
    one.covariance = 0.5 * (one.covariance + one.covariance.transpose()).eval();
  }
  normalize();
  mergeHypotheses();
  normalize();
  summarize();
}

}  // namespace modules

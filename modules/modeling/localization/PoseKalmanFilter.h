// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "modules/modeling/PoseEstimate.h"
#include "modules/modeling/localization/FieldEdgeMap.h"
#include "modules/modeling/localization/FieldMonteCarlo.h"
#include "modules/modeling/localization/LandmarkMemory.h"

namespace modules {

/// Self-localization by an extended Kalman filter over dead reckoning, the bearings and distances of
/// landmarks and the distances of points to lines, with several hypotheses of the pose (Jensfelt, Kristensen:
/// Active global localisation for a mobile robot using multiple hypothesis tracking, 2001; Quinlan,
/// Middleton: Multiple model Kalman filters, RoboCup 2009).
///
/// Each hypothesis is a normal distribution with a weight. A pair of landmarks that were seen lately
/// determines a pose; where no hypothesis is near it, one is added, so that a robot that was carried away
/// finds itself again. Hypotheses that become equal are merged, those without weight are removed. The
/// estimate is the hypothesis with the highest weight. Deterministic. Not thread-safe.
class PoseKalmanFilter {
 public:
  struct Options {
    /// The deviation of a landmark's bearing, rad.
    double bearingDeviation = 0.06;
    /// The deviation of a landmark's distance, as a fraction of it.
    double distanceDeviation = 0.12;
    /// The deviation of the distance of a point to its line, m, plus a fraction of its distance to the
    /// robot.
    double lineDeviation = 0.05, lineDeviationPerMeter = 0.12;
    /// The number of an image's points of lines that are used; 0: none.
    int linePoints = 6;
    /// The fraction of an image's information that the previous image did not contain.
    double evidence = 0.3;
    /// Error after walking one meter, m, and after turning one radian, rad; they grow with the square root.
    double walkNoise = 0.1, turnNoise = 0.12;
    /// Added in every update, m and rad.
    double driftNoise = 0.002;
    /// A measurement farther away than this many standard deviations does not correct a hypothesis.
    double gate = 3;
    /// The weight of a hypothesis that is added.
    double newWeight = 0.02;
    /// Hypotheses with less weight are removed.
    double minimumWeight = 0.005;
    int maximumHypotheses = 8;
    /// The time for which landmarks are remembered for new hypotheses, s.
    double memory = 4;
  };
  using Frame = FieldMonteCarlo::Frame;

  /// A pose with the covariance of (x, y, heading), in the field, and a weight; all weights sum up to 1.
  struct Hypothesis {
    robotlink::Pose2 pose;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
    double weight = 1;
  };

  /// Starts without any hypothesis: at the center, completely uncertain.
  PoseKalmanFilter(const robotlink::FieldDescription& field, const Options& options);
  /// Restarts with one hypothesis; `deviation` in m and rad.
  void startAt(const robotlink::Pose2& pose, double deviation);
  void setOptions(const Options& options) { options_ = options; }
  /// Call it once an image.
  void update(const Frame& frame);

  const PoseEstimate& estimate() const { return estimate_; }
  /// Sorted by descending weight.
  const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }
  const FieldEdgeMap& edges() const { return edges_; }

 private:
  void predict(Hypothesis& hypothesis, const robotlink::Pose2& step, bool shaken) const;
  /// Corrects a hypothesis by a measurement of one number, and returns the likelihood of it, from a lower
  /// bound for outliers up to 1. `row`: the derivatives with respect to the pose; `difference`: measured
  /// minus expected.
  double correct(Hypothesis& hypothesis, const Eigen::RowVector3d& row, double difference,
                 double deviation) const;
  double correctByLandmark(Hypothesis& hypothesis, const LandmarkMeasurement& seen) const;
  double correctByLine(Hypothesis& hypothesis, const LineMeasurement& point) const;
  /// Adds the poses that follow from pairs of landmarks.
  void addHypotheses(const robotlink::Pose2& robotInOdometry);
  void addHypothesis(const robotlink::Pose2& pose, double distance);
  void keepOnField(robotlink::Pose2& pose) const;
  /// Whether two hypotheses are the same pose.
  bool areSame(const Hypothesis& a, const Hypothesis& b) const;
  void mergeHypotheses();
  void normalize();
  void summarize();

  Options options_;
  FieldEdgeMap edges_;
  /// Half of the field's surface, m.
  double halfLength_, halfWidth_;
  LandmarkMemory memory_;
  std::vector<Hypothesis> hypotheses_;
  robotlink::Pose2 odometry_;
  bool hasOdometry_ = false;
  /// The robot was carried, and nothing has said since then where it is.
  bool wasCarried_ = false;
  PoseEstimate estimate_;
};

}  // namespace modules

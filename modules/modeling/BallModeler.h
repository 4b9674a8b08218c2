// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "modules/modeling/BallFilter.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/ViewFrustum.h"

namespace modules {

// Debug keys shared by all solutions of the task. Inline, so that they are defined in every file that
// registers a solution.
inline const robotlink::RobotDrawingKey kBallKey{
    "ball-model/ball",
    "The ball's estimated position with its uncertainty, and where it rolls (drawn around the robot)"};
inline const robotlink::PlotKey kBallPositionKey{
    "ball-model/position", "Position of the ball in the robot's frame, and its deviation"};
inline const robotlink::PlotKey kBallAgeKey{"ball-model/age", "Seconds since the ball was seen"};

/// The base of solutions of the task "ball-model": sends the estimate, and draws and plots it. Used by its
/// process's thread; the context must outlive it.
class BallModeler : public robotlink::Solution {
 public:
  explicit BallModeler(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        ballRadius_(context.robot().field->ballRadius),
        model_(context.output(robotlink::kBallModel)) {}

 protected:
  void publish(const BallEstimate& ball, const google::protobuf::Timestamp& time) {
    auto package = std::make_shared<robotcontrol::BallModel>();
    *package->mutable_timestamp() = time;
    package->set_known(ball.known);
    robotlink::assign(*package->mutable_position_in_robot(), ball.position);
    robotlink::assign(*package->mutable_velocity_in_robot(), ball.velocity);
    package->set_seconds_since_seen(ball.secondsSinceSeen);
    package->set_standard_deviation(ball.deviation);
    draw(ball);
    model_.send(std::move(package));
  }

  /// For drawings of the derived classes.
  robotlink::DebugContext& debug_;
  double ballRadius_;  ///< m

 private:
  void draw(const BallEstimate& ball) {
    if (debug_.on(kBallAgeKey)) debug_.plot(kBallAgeKey, ball.secondsSinceSeen, "s");
    if (!ball.known) return;
    if (debug_.on(kBallKey)) {
      auto drawing = debug_.robotDrawing(kBallKey);
      drawing.circle(ball.position, ballRadius_, robotlink::colors::kOrange, 2);
      drawing.circle(ball.position, ballRadius_ + ball.deviation, robotlink::colors::kGray);
      if (ball.velocity.norm() > 0.02)
        drawing.arrow(ball.position, ball.position + ball.velocity, robotlink::colors::kOrange);
    }
    if (debug_.on(kBallPositionKey)) {
      debug_.plot(kBallPositionKey, "x", ball.position.x(), "m");
      debug_.plot(kBallPositionKey, "y", ball.position.y(), "m");
      debug_.plot(kBallPositionKey, "deviation", ball.deviation, "m");
    }
  }

  robotlink::Output<robotcontrol::BallModel> model_;
};

/// The base of solutions that feed an estimator with ball percepts: one with update(), estimate(),
/// setOptions() and Options as BallFilter has them.
template <typename Estimator>
class PerceptBallModeler : public BallModeler {
 public:
  PerceptBallModeler(robotlink::SolutionContext& context, const typename Estimator::Options& options)
      : BallModeler(context),
        percept_(context.input(robotlink::kBallPercept)),
        motion_(context.input(robotlink::kMotionStatus)),
        camera_(context.input(robotlink::kCameraPose)),
        estimator_(options) {}

  void execute() override {
    if (!percept_ || !percept_.isNew()) return;
    std::optional<BallMeasurement> seen;
    if (percept_->seen() && percept_->confidence() >= minimumConfidence())
      seen = BallMeasurement{robotlink::vector2(percept_->position_in_robot()), percept_->confidence()};
    const double time = robotlink::seconds(robotlink::instant(percept_->timestamp()));
    const robotlink::Pose2 odometry = motion_ ? robotlink::pose2(motion_->odometry()) : robotlink::Pose2{};
    estimator_.setOptions(options());
    estimator_.update(time, odometry, seen);
    if (isGone()) estimator_.forget();
    publish(estimator_.estimate(), percept_->timestamp());
    drawMore(estimator_, odometry);
  }

 protected:
  virtual typename Estimator::Options options() const = 0;
  /// Percepts with less confidence are ignored.
  virtual double minimumConfidence() const = 0;
  /// The ball is forgotten after this many images in a row that should show it and do not; 0: never.
  virtual int absentImages() const { return 0; }
  /// Draws what the estimator has beyond the estimate.
  virtual void drawMore(const Estimator& /*estimator*/, const robotlink::Pose2& /*robotInOdometry*/) {}

 private:
  /// The area in which a ball is found in nearly each image: this far away, m, and in this part of the image.
  static constexpr double kSureFrom = 0.25, kSureUpTo = 1.5, kSurePart = 0.8;

  /// Counts the images that should show the ball and do not.
  bool isGone() {
    const BallEstimate ball = estimator_.estimate();
    const double distance = ball.position.norm();
    if (percept_->seen() || !ball.known || absentImages() <= 0) {
      absent_ = 0;
    } else if (camera_ && distance > kSureFrom && distance < kSureUpTo &&
               robotlink::ViewFrustum(*camera_).shows({ball.position.x(), ball.position.y(), ballRadius_},
                                                      kSurePart)) {
      ++absent_;
    }
    return absentImages() > 0 && absent_ >= absentImages();
  }

  robotlink::Input<robotcontrol::BallPercept> percept_;
  robotlink::Input<robotcontrol::MotionStatus> motion_;
  robotlink::Input<robotcontrol::CameraPose> camera_;
  Estimator estimator_;
  /// Images in a row without the ball that should show it.
  int absent_ = 0;
};

}  // namespace modules

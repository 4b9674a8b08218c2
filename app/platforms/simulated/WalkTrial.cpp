// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/WalkTrial.h"

#include <algorithm>
#include <cmath>

#include "app/platforms/simulated/RunEnd.h"
#include "app/platforms/simulated/game/GameRules.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Random.h"

namespace app {
namespace {

using robotlink::Pose2;

/// Simulated s, before the walk, and from its begin until its speed is steady.
constexpr double kStandTime = 0.5, kSteadyAfter = 1.5;
/// While a robot is steered, requests are repeated.
constexpr double kRepeatAfter = 0.5;
/// The distance of the start from the middle of the field, m.
constexpr double kBeforeMiddle = 0.8;
/// The most that the seed adds to the heading (rad), and to the commanded velocity (m/s, rad/s).
constexpr double kHeadingRange = 0.3, kSidewardRange = 0.01, kRotationRange = 0.1;
/// A body lies if its z-axis has a smaller z-component.
constexpr double kWalkUpright = 0.7;

/// Steers one robot, and adds up how it moves.
class WalkMeasurement {
 public:
  WalkMeasurement(SimulatedRun& run, WalkTrial::Velocity asked)
      : run_(run), robot_(run.robots().front()), asked_(asked) {}

  /// Fails if the request is refused.
  robotlink::Result<void> walk(double seconds) {
    const robotlink::Instant end = now() + robotlink::fromSeconds(seconds);
    while (now() < end) {
      if (now() >= due_) {
        if (auto steered = steer(); !steered) return steered;
        due_ = now() + robotlink::fromSeconds(kRepeatAfter);
      }
      step();
    }
    return {};
  }
  void stand(double seconds) {
    const robotlink::Instant end = now() + robotlink::fromSeconds(seconds);
    while (now() < end) run_.step();
  }
  /// Begins the measurement; what comes before is not measured.
  void begin() {
    sum_ = {};
    begun_ = now();
    last_ = pose();
  }
  WalkTrial::Velocity mean() const {
    const double time = std::max(robotlink::seconds(now() - begun_), 1e-3);
    return {sum_.x / time, sum_.y / time, sum_.heading / time};
  }
  double leastUpright() const { return leastUpright_; }

 private:
  robotlink::Instant now() const { return run_.world().clock().now(); }
  Pose2 pose() const {
    const auto pose = run_.world().simulation().modelPose(robot_);
    return pose ? robotlink::groundPose(*pose) : Pose2();
  }
  void step() {
    run_.step();
    const Pose2 next = pose(), moved = last_.inverse() * next;
    sum_.x += moved.x;
    sum_.y += moved.y;
    sum_.heading += std::remainder(moved.heading, 2 * robotlink::kPi);
    last_ = next;
    const auto body = run_.world().simulation().modelPose(robot_);
    if (body) leastUpright_ = std::min(leastUpright_, body->linear()(2, 2));
  }
  robotlink::Result<void> steer() {
    robotcontrol::Request request;
    request.set_robot(robot_);
    auto& motion = *request.mutable_motion()->mutable_motion();
    motion.set_kind(robotcontrol::MotionRequest::WALK);
    motion.mutable_walk()->set_x(asked_.forward);
    motion.mutable_walk()->set_y(asked_.sideward);
    motion.mutable_walk()->set_rotation(asked_.rotation);
    return run_.request(request);
  }

  SimulatedRun& run_;
  const std::string robot_;
  const WalkTrial::Velocity asked_;
  robotlink::Instant due_{}, begun_{};
  Pose2 last_, sum_;
  double leastUpright_ = 1;
};

tl::unexpected<robotlink::Errors> impossible(const char* id, std::string text) {
  return tl::unexpected(robotlink::Errors{{id, std::move(text), {}, {}}});
}

}  // namespace

tl::expected<WalkTrial::Result, robotlink::Errors> WalkTrial::measure() const {
  RunOptions options = run;
  options.kickOffs = false;
  options.game = kNoGame;
  robotlink::Random random(options.world.seed, 0x3A1C);
  auto made = SimulatedRun::create(std::move(options), listeners);
  if (!made) return tl::unexpected(made.error());
  const RunEnd end(std::move(*made));
  SimulatedRun& simulated = end.run();
  if (simulated.robots().empty())
    return impossible("walk.no-robot", "there is no robot in this scene to walk");
  const double heading = random.uniform(-kHeadingRange, kHeadingRange);
  const Pose2 start{-kBeforeMiddle * std::cos(heading), -kBeforeMiddle * std::sin(heading), heading};
  if (!simulated.world().simulation().placeModel(simulated.robots().front(), start))
    return impossible("walk.no-place", "something is in the way of the robot that is to walk");
  Result result;
  result.asked = {asked.forward, asked.sideward + random.uniform(-kSidewardRange, kSidewardRange),
                  asked.rotation + random.uniform(-kRotationRange, kRotationRange)};
  WalkMeasurement measurement(simulated, result.asked);
  measurement.stand(kStandTime + random.uniform());
  for (const double time : {kSteadyAfter, seconds}) {
    measurement.begin();
    if (auto walked = measurement.walk(time); !walked)
      return tl::unexpected(robotlink::Errors{walked.error()});
  }
  result.leastUpright = measurement.leastUpright();
  result.fell = result.leastUpright < kWalkUpright;
  if (!result.fell) result.walked = measurement.mean();
  return result;
}

}  // namespace app

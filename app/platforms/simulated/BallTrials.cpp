// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/BallTrials.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/platforms/simulated/RunEnd.h"
#include "robotlink/base/Random.h"
#include "robotlink/config/FieldDescription.h"
#include "simcore/Scene.h"

namespace app {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

/// The least distance of the ball from the robot's center, m.
constexpr double kClearOfRobot = 0.3;

/// The pose of a model in the field's frame.
Pose2 poseOf(const SimulatedRun& run, const std::string& model) {
  const auto pose = run.world().simulation().modelPose(model);
  return pose ? robotlink::groundPose(*pose) : Pose2{};
}

/// The name of the ball.
const std::string& ballOf(const SimulatedRun& run) {
  return run.world().simulation().scene().balls().front();
}

/// Places the ball at random. Places that the simulation refuses (in a wall, off the field) are replaced by
/// others; fails after many of them.
bool placeBall(SimulatedRun& run, const BallTrials& trials, std::uint64_t seed, Vector2& ball) {
  robotlink::Random random(seed, 0xBA11);
  const Pose2 robot = poseOf(run, run.robots().front());
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const double distance = trials.radius * std::sqrt(random.uniform());
    const double angle = random.uniform(-robotlink::kPi, robotlink::kPi);
    if (distance < kClearOfRobot) continue;
    ball = robot * Vector2(distance * std::cos(angle), distance * std::sin(angle));
    if (run.world().simulation().placeModel(ballOf(run), {ball.x(), ball.y(), 0})) return true;
  }
  return false;
}

/// The least distance of the robot's center from the walls when it is placed anywhere, m; and of the ball's.
constexpr double kRobotFromWall = 0.3, kBallFromWall = 0.15;

/// Places robot and ball anywhere on the field, at random.
bool placeAnywhere(SimulatedRun& run, const robotlink::FieldDescription& field, BallTrials::Trial& trial) {
  robotlink::Random random(trial.seed, 0x60A1);
  simcore::Simulation& simulation = run.world().simulation();
  const auto inside = [&](double limit, double margin) {
    return random.uniform(margin - limit, limit - margin);
  };
  for (int attempt = 0; attempt < 1000; ++attempt) {
    trial.robot = {inside(field.goalLineX(), kRobotFromWall), inside(field.touchLineY(), kRobotFromWall),
                   random.uniform(-robotlink::kPi, robotlink::kPi)};
    trial.ball = {inside(field.goalLineX(), kBallFromWall), inside(field.touchLineY(), kBallFromWall)};
    if ((trial.ball - trial.robot.translation()).norm() < kClearOfRobot) continue;
    // The ball leaves the place to which the robot comes.
    (void)simulation.placeModel(ballOf(run), {trial.ball.x(), trial.ball.y(), 0});
    if (simulation.placeModel(run.robots().front(), trial.robot) &&
        simulation.placeModel(ballOf(run), {trial.ball.x(), trial.ball.y(), 0}))
      return true;
  }
  return false;
}

/// Whether the whole ball is in the goal that a team attacks; the red one plays toward +x.
bool isInGoal(const robotlink::FieldDescription& field, const Vector2& ball, double direction) {
  return direction * ball.x() > field.goalLineX() + field.ballRadius &&
         std::abs(ball.y()) < 0.5 * field.goalWidth;
}

/// Plays a trial that ends with a goal. Nothing if it was canceled.
std::optional<BallTrials::Trial> playForGoal(SimulatedRun& run, const BallTrials& trials,
                                             BallTrials::Trial trial) {
  const robotlink::Clock& clock = run.world().clock();
  const auto& robots = run.world().simulation().scene().robots();
  const auto robot = std::ranges::find(robots, run.robots().front(), &simcore::Scene::Robot::name);
  const double direction = robot == robots.end() ? 1 : run.field()->playingDirection(robot->team);
  while (clock.now() < robotlink::Instant(robotlink::fromSeconds(trials.seconds)) && !trial.scored) {
    if (trials.stop && trials.stop()) return std::nullopt;
    run.step();
    if (!trial.touched && run.world().simulation().ballContacts() > 0) {
      trial.touched = true;
      trial.touchedAfter = robotlink::seconds(clock.now());
    }
    trial.scored = isInGoal(*run.field(), poseOf(run, ballOf(run)).translation(), direction);
  }
  if (trial.scored) trial.scoredAfter = robotlink::seconds(clock.now());
  trial.moved = (poseOf(run, ballOf(run)).translation() - trial.ball).norm();
  return trial;
}

/// Plays a trial whose ball is placed. Nothing if it was canceled.
std::optional<BallTrials::Trial> playOne(SimulatedRun& run, const BallTrials& trials,
                                         BallTrials::Trial trial) {
  const robotlink::Clock& clock = run.world().clock();
  robotlink::Instant end = robotlink::Instant(robotlink::fromSeconds(trials.seconds));
  while (clock.now() < end) {
    if (trials.stop && trials.stop()) return std::nullopt;
    run.step();
    if (trial.touched || run.world().simulation().ballContacts() == 0) continue;
    trial.touched = true;
    trial.touchedAfter = robotlink::seconds(clock.now());
    end = clock.now() + robotlink::fromSeconds(trials.afterTouch);
  }
  trial.moved = (poseOf(run, ballOf(run)).translation() - trial.ball).norm();
  const auto robot = run.world().simulation().modelPose(run.robots().front());
  trial.fell = robot && robot->linear()(2, 2) < 0.5;
  return trial;
}

}  // namespace

tl::expected<std::vector<BallTrials::Trial>, robotlink::Errors> BallTrials::play() const {
  RunOptions options = run;
  // Each trial starts with a placed ball and ends soon after the first touch.
  options.kickOffs = false;
  auto made = SimulatedRun::create(std::move(options), listeners);
  if (!made) return tl::unexpected(made.error());
  const RunEnd end(std::move(*made));
  SimulatedRun& simulated = end.run();
  if (simulated.robots().empty()) {
    return tl::unexpected(robotlink::Errors{
        {"trials.no-robot", "there is no robot in this scene to play", {}, {run.scene.string(), 0, 0}}});
  }
  if (simulated.world().simulation().scene().balls().empty()) {
    return tl::unexpected(robotlink::Errors{
        {"trials.no-ball", "there is no ball in this scene to play with", {}, {run.scene.string(), 0, 0}}});
  }
  if (goals && !simulated.field()) {
    return tl::unexpected(robotlink::Errors{
        {"trials.no-field", "there is no field in this scene to score on", {}, {run.scene.string(), 0, 0}}});
  }
  std::vector<Trial> trials;
  for (int i = 0; i < count; ++i) {
    Trial trial;
    trial.seed = firstSeed + static_cast<std::uint64_t>(i);
    if (auto errors = simulated.reset(trial.seed); !errors.empty()) return tl::unexpected(std::move(errors));
    const bool placed = goals ? placeAnywhere(simulated, *simulated.field(), trial)
                              : placeBall(simulated, *this, trial.seed, trial.ball);
    if (!placed) {
      return tl::unexpected(
          robotlink::Errors{{"trials.no-place",
                             "there is no room for the ball within the radius; choose a larger one",
                             {},
                             {run.scene.string(), 0, 0}}});
    }
    const auto played = goals ? playForGoal(simulated, *this, trial) : playOne(simulated, *this, trial);
    if (!played) break;
    trials.push_back(*played);
    if (onTrial) onTrial(trials.back());
  }
  return trials;
}

}  // namespace app

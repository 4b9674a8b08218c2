// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/simulated/BallTrials.h"

#include <cmath>
#include <optional>

#include "app/core/simulated/RunEnd.h"
#include "robotlink/base/Random.h"
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
  std::vector<Trial> trials;
  for (int i = 0; i < count; ++i) {
    Trial trial;
    trial.seed = firstSeed + static_cast<std::uint64_t>(i);
    if (auto errors = simulated.reset(trial.seed); !errors.empty()) return tl::unexpected(std::move(errors));
    if (!placeBall(simulated, *this, trial.seed, trial.ball)) {
      return tl::unexpected(robotlink::Errors{{"trials.no-place",
                                               "the ball fits nowhere within the radius; choose a larger one",
                                               {},
                                               {run.scene.string(), 0, 0}}});
    }
    const auto played = playOne(simulated, *this, trial);
    if (!played) break;
    trials.push_back(*played);
    if (onTrial) onTrial(trials.back());
  }
  return trials;
}

}  // namespace app

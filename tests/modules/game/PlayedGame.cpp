// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/modules/game/PlayedGame.h"
#include "robotlink/debugging/SharedDebugQueue.h"

#include <cstdlib>
#include <stdexcept>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

using robotlink::Instant;
using robotlink::Pose2;
using robotlink::Pose3;
using robotlink::Vector2;

namespace {

const std::string kRobot = "red1";

robotcontrol::Request requestTo(const std::string& robot) {
  robotcontrol::Request request;
  request.set_robot(robot);
  return request;
}

}  // namespace

PlayedGame::PlayedGame(Solutions solutions, app::SimulatedWorld::Options world) {
  const std::string resources = ROBOTCONTROL_SOURCE_DIR "/resources";
  setenv("ROBOTCONTROL_RESOURCES", resources.c_str(), 1);
  app::RunOptions options;
  options.scene = resources + "/scenes/field2002.sdf";
  options.layout = resources + "/layouts/compact.yaml";
  options.world = std::move(world);
  options.solutions = std::move(solutions);
  app::SimulatedRun::Listeners listeners;
  listeners.queue = [this](const std::string&, auto queue) { receive(*queue); };
  listeners.trouble = [](const std::string&, const auto&, const std::string& text) {
    throw std::runtime_error(text);
  };
  auto run = app::SimulatedRun::create(std::move(options), std::move(listeners));
  if (!run) throw std::runtime_error(describe(run.error()));
  run_ = *std::move(run);
}

void PlayedGame::placeRobot(const Pose2& pose) {
  const auto placed = run_->world().simulation().placeModel(kRobot, pose);
  if (!placed) throw std::runtime_error(placed.error().describe());
}

void PlayedGame::placeBall(const Vector2& place) {
  const auto placed = run_->world().simulation().placeModel("ball", {place.x(), place.y(), 0});
  if (!placed) throw std::runtime_error(placed.error().describe());
}

PlayedGame::Truth PlayedGame::truth() const {
  const simcore::Simulation& simulation = run_->world().simulation();
  Truth truth;
  truth.robotInField = robotlink::groundPose(*simulation.modelPose(kRobot));
  const Pose2& robot = truth.robotInField;
  truth.ballInRobot = robot.inverse() * Vector2(simulation.modelPose("ball")->translation().head<2>());
  const simcore::CameraSensor& camera = simulation.cameras().front();
  const Pose3 cameraInField =
      simulation.bodyPoses()[static_cast<std::size_t>(camera.body)] * camera.cameraInBody;
  const Pose3 robotInField = Pose3(Eigen::Translation3d(robot.x, robot.y, 0)) *
                             Pose3(Eigen::AngleAxisd(robot.heading, Eigen::Vector3d::UnitZ()));
  truth.cameraInRobot = robotInField.inverse() * cameraInField;
  return truth;
}

void PlayedGame::run(double seconds) {
  const Instant end = run_->world().clock().now() + robotlink::fromSeconds(seconds);
  while (run_->world().clock().now() < end) {
    run_->step();
    truths_[run_->world().clock().now()] = truth();
    while (truths_.size() > 200) truths_.erase(truths_.begin());
  }
}

void PlayedGame::show(const std::string& package, Listener listener) {
  listeners_[package] = std::move(listener);
  publish(robotlink::packageKey(package));
}

void PlayedGame::publish(const std::string& key) {
  robotcontrol::Request request = requestTo(kRobot);
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  if (!run_->request(request)) throw std::runtime_error("request refused");
}

void PlayedGame::select(const std::string& task, const std::string& solution) {
  robotcontrol::Request request = requestTo(kRobot);
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(solution);
  if (!run_->request(request)) throw std::runtime_error("request refused");
}

void PlayedGame::receive(const robotlink::SharedDebugQueue& queue) {
  for (const robotlink::SharedDebugMessage& message : queue.messages) {
    paths_.insert(message.path);
    if (const auto* text = message.as<foxglove::Log>())
      texts_.push_back(text->name() + ": " + text->message());
    const auto listener = listeners_.find(message.path);
    const auto truth = truths_.find(message.time.value());
    if (listener != listeners_.end() && truth != truths_.end())
      listener->second(message.content->SerializeAsString(), truth->second);
  }
}

double PlayedGame::time() const {
  return robotlink::seconds(run_->world().clock().now());
}
std::uint64_t PlayedGame::ballContacts() const {
  return run_->world().simulation().ballContacts();
}

}  // namespace modules

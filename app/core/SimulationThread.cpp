// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/SimulationThread.h"

#include "app/core/SceneMessages.h"
#include "foxglove/Geometry.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"
#include "simcore/Scene.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kTransformsEvery{15};
constexpr std::chrono::milliseconds kStatusEvery{100};
/// Further behind than this, lost time is not caught up with.
constexpr std::chrono::milliseconds kMaxLag{200};

}  // namespace

SimulationThread::SimulationThread(robotlink::Session& session) : session_(session), thread_([this] { runLoop(); }) {}

SimulationThread::~SimulationThread() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  wakeUp_.notify_one();
  thread_.join();
}

void SimulationThread::post(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  wakeUp_.notify_one();
}

bool SimulationThread::runJobs(std::unique_lock<std::mutex>& lock) {
  while (!jobs_.empty() && !quit_) {
    const auto job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
  return !quit_;
}

void SimulationThread::runLoop() {
  std::unique_lock lock(mutex_);
  while (runJobs(lock)) {
    if (!run_ || (!running_ && stepsWanted_ == 0)) {
      wakeUp_.wait(lock, [this] { return quit_ || !jobs_.empty(); });
      continue;
    }
    if (running_ && wakeUp_.wait_until(lock, nextStepAt(), [this] { return quit_ || !jobs_.empty(); })) continue;
    lock.unlock();
    stepOnce();
    lock.lock();
  }
  lock.unlock();
  run_.reset();
}

SimulationThread::Clock::time_point SimulationThread::nextStepAt() const {
  if (speed_ <= 0) return paceStart_;  // As fast as possible: it is always late.
  const double simulated = robotlink::seconds(run_->world().clock().now() - paceStartTime_);
  return paceStart_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(simulated / speed_));
}

void SimulationThread::restartPacing() {
  paceStart_ = Clock::now();
  if (run_) paceStartTime_ = run_->world().clock().now();
}

void SimulationThread::stepOnce() {
  if (Clock::now() - nextStepAt() > kMaxLag) restartPacing();
  run_->step();
  if (stepsWanted_ > 0) --stepsWanted_;
  const auto now = Clock::now();
  const bool single = !running_;
  if (single || now - lastTransforms_ >= kTransformsEvery) {
    lastTransforms_ = now;
    publishTransforms();
  }
  if (single || now - lastStatus_ >= kStatusEvery) publishStatus();
}

SimulatedRun::Listeners SimulationThread::listeners() {
  return {[this](const std::string& robot, auto queue) { session_.pushQueue(robot, queue); },
          [this](const std::string& robot, const robotlink::Process& process, const std::string& text) {
            publishTrouble(robot, process, text);
          }};
}

SimulationThread::Loaded SimulationThread::describe() const {
  Loaded loaded{run_->options(), {}, run_->field()};
  for (const std::string& robot : run_->robots()) loaded.robots[robot] = run_->description(robot);
  return loaded;
}

void SimulationThread::load(RunOptions options, LoadHandler handler) {
  post([this, options = std::move(options), handler = std::move(handler)] {
    auto run = SimulatedRun::create(options, listeners());
    if (!run) {
      handler(tl::unexpected(run.error()));
      return;
    }
    run_ = std::move(*run);
    restartPacing();
    publishScene();
    handler(describe());
  });
}

void SimulationThread::setLayout(std::filesystem::path file, LoadHandler handler) {
  post([this, file = std::move(file), handler = std::move(handler)] {
    if (!run_) return;
    if (robotlink::Errors errors = run_->setLayout(file); !errors.empty()) {
      handler(tl::unexpected(std::move(errors)));
      return;
    }
    handler(describe());
  });
}

void SimulationThread::request(const robotcontrol::Request& request) {
  post([this, request] { fulfil(request); });
}

void SimulationThread::fulfil(const robotcontrol::Request& request) {
  const auto done = fulfilRequest(request);
  const bool answeredByProgram = done && !request.robot().empty() && !request.has_stop();
  if (answeredByProgram) return;
  robotcontrol::RequestResult result;
  result.set_id(request.id());
  result.set_accepted(done.has_value());
  if (!done) result.set_reason(done.error().text);
  session_.pushResult(result);
  if (run_) publishStatus();
}

robotlink::Result<void> SimulationThread::fulfilRequest(const robotcontrol::Request& request) {
  if (!run_) return robotlink::failure("simulation.none", "no simulation is loaded; open a scene first");
  if (request.has_control_simulation()) return control(request.control_simulation());
  if (request.has_place_model()) {
    auto placed = run_->world().simulation().placeModel(request.place_model().model(),
                                                        robotlink::pose2(request.place_model().pose_in_field()));
    publishTransforms();
    return placed;
  }
  return run_->request(request);
}

robotlink::Result<void> SimulationThread::control(const robotcontrol::ControlSimulation& control) {
  using Control = robotcontrol::ControlSimulation;
  if (control.speed() >= 0) speed_ = control.speed();
  restartPacing();
  switch (control.action()) {
    case Control::START:
      running_ = true;
      break;
    case Control::PAUSE:
      running_ = false;
      break;
    case Control::STEP:
      running_ = false;
      ++stepsWanted_;
      break;
    case Control::RESET:
      return resetRun();
    default:
      break;
  }
  return {};
}

robotlink::Result<void> SimulationThread::resetRun() {
  stepsWanted_ = 0;
  if (const robotlink::Errors errors = run_->reset(run_->options().world.seed); !errors.empty()) {
    return tl::unexpected(errors.front());
  }
  restartPacing();
  publishScene();
  return {};
}

void SimulationThread::publishScene() {
  const robotlink::Instant now = run_->world().clock().now();
  lastStatusTime_ = now;
  lastStatus_ = Clock::now();
  session_.push({"scene", now, sceneMessage(run_->world().simulation())});
  publishTransforms();
  publishStatus();
}

void SimulationThread::publishTransforms() {
  session_.push({"transforms", run_->world().clock().now(), transformsMessage(run_->world().simulation())});
}

void SimulationThread::publishStatus() {
  SimulatedWorld& world = run_->world();
  const robotlink::Instant now = world.clock().now();
  const double elapsed = std::chrono::duration<double>(Clock::now() - lastStatus_).count();
  if (elapsed >= 0.5 * std::chrono::duration<double>(kStatusEvery).count()) {
    measuredSpeed_ = running_ ? robotlink::seconds(now - lastStatusTime_) / elapsed : 0;
    lastStatus_ = Clock::now();
    lastStatusTime_ = now;
  }
  auto status = std::make_shared<robotcontrol::SimulationStatus>();
  status->set_time(robotlink::seconds(now));
  status->set_speed(running_ ? measuredSpeed_ : 0);
  status->set_requested_speed(speed_);
  status->set_running(running_);
  status->set_steps(world.costs().steps);
  status->set_ball_contacts(world.simulation().ballContacts());
  status->set_scene(run_->options().scene.string());
  for (const auto& robot : run_->robots()) status->add_robots(robot);
  for (const auto& robot : run_->stoppedRobots()) status->add_stopped_robots(robot);
  for (const auto& model : movableModels(world.simulation())) status->add_models(model);
  session_.push({"simulation", now, std::move(status)});
}

void SimulationThread::publishTrouble(const std::string& robot, const robotlink::Process& process,
                                      const std::string& text) {
  const robotlink::Instant now = process.clock().now();
  auto log = std::make_shared<foxglove::Log>();
  log->set_level(foxglove::Log::ERROR);
  log->set_name(process.name());
  log->set_message(text);
  robotlink::assign(*log->mutable_timestamp(), now);
  session_.push({robot + "/log", now, std::move(log)});
}

}  // namespace app

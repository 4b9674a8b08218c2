// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/CameraWork.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

#include "simcore/world/SensorErrors.h"

namespace app {
namespace {

/// The longest time between two steps at which images are requested, in steps of the physics.
constexpr std::uint64_t kStepsBetweenAsks = 2;

/// Makes an image in YCbCr 4:2:2 black.
void blacken(robotlink::Image& image) {
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = i % 2 == 0 ? 0 : 128;
}

/// Labels the last image of a renderer.
void label(const TrueClasses& classes, simcore::CameraRenderer& renderer, const simcore::CameraOptics& optics,
           int width, robotlink::Image& labels) {
  renderer.label(classes.ofInstances(), TrueClasses::kBackground, labels);
  optics.distortLabels(TrueClasses::kBackground, width, labels);
  TrueClasses::ignoreMixedPairs(labels);
}

}  // namespace

struct CameraWork::Studio {
  const std::shared_ptr<const simcore::RenderScene> scene;
  const TrueClasses classes;
  const bool shadows;
  std::mutex mutex;
  /// Idle renderers; protected by the mutex.
  std::vector<std::unique_ptr<simcore::CameraRenderer>> renderers;

  Studio(std::shared_ptr<const simcore::RenderScene> ofScene, bool withShadows)
      : scene(std::move(ofScene)), classes(*scene), shadows(withShadows) {}

  std::unique_ptr<simcore::CameraRenderer> borrow() {
    {
      const std::lock_guard lock(mutex);
      if (!renderers.empty()) {
        auto renderer = std::move(renderers.back());
        renderers.pop_back();
        return renderer;
      }
    }
    return std::make_unique<simcore::CameraRenderer>(scene, simcore::CameraRenderer::Options{shadows});
  }
  void giveBack(std::unique_ptr<simcore::CameraRenderer> renderer) {
    const std::lock_guard lock(mutex);
    renderers.push_back(std::move(renderer));
  }
};

struct CameraWork::Ahead {
  std::shared_ptr<Studio> studio;
  std::shared_ptr<simcore::CameraOptics> optics;
  simcore::ComingImage coming;
  simcore::CameraOptics::Mount mount = {};
  simcore::ShutterModel shutter = {};
  Order order = {};
  bool hasClasses = false;
  robotlink::Image image = {}, classes = {};
  enum class State : std::uint8_t { kWaits, kBegun, kDone };
  std::atomic<State> state{State::kWaits};

  /// The first thread that calls this makes the image; others return at once.
  void make() {
    State expected = State::kWaits;
    if (!state.compare_exchange_strong(expected, State::kBegun)) return;
    auto renderer = studio->borrow();
    renderer->setLighting(order.lighting);
    const auto posesAt = [this](double age, std::vector<simcore::Pose3>& poses) { coming.poses(age, poses); };
    optics->render(*renderer, posesAt, mount, order.model, shutter, robotlink::PixelFormat::kYuyv,
                   order.noise, image);
    if (hasClasses) label(studio->classes, *renderer, *optics, image.width, classes);
    if (order.blackout) blacken(image);
    studio->giveBack(std::move(renderer));
    state = State::kDone;
    state.notify_all();
  }
  /// Makes it, or waits until another thread has.
  void finish() {
    make();
    for (State now = state; now != State::kDone; now = state) state.wait(now);
  }
  /// Cancels the job unless a thread has begun it; that thread then finishes it.
  void giveUp() {
    State expected = State::kWaits;
    state.compare_exchange_strong(expected, State::kDone);
  }
};

CameraWork::CameraWork(const simcore::Simulation& simulation, std::shared_ptr<robotlink::ThreadPool> pool,
                       bool shadows)
    : simulation_(simulation), pool_(std::move(pool)), shadows_(shadows) {
  restart();
}

CameraWork::~CameraWork() = default;

void CameraWork::restart() {
  scene_ = simulation_.renderScene();
  for (Camera& camera : cameras_) forgetAhead(camera);
  studio_ = std::make_shared<Studio>(scene_, shadows_);
  lanes_.clear();
  cameras_.clear();
  cameras_.resize(simulation_.cameras().size());
  last_ = nullptr;
  posed_ = kNever;
  if (cameras_.empty()) return;
  for (std::size_t i = 0; i < cameras_.size(); ++i) cameras_[i].shot.camera = i;
  const std::size_t threads = pool_ ? static_cast<std::size_t>(pool_->threads()) : 1;
  lanes_.resize(std::min(threads, cameras_.size()));
  lanes_[0].renderer = std::make_unique<simcore::CameraRenderer>(simulation_.renderScene(),
                                                                 simcore::CameraRenderer::Options{shadows_});
  for (std::size_t i = 1; i < lanes_.size(); ++i) lanes_[i].renderer = lanes_[0].renderer->another();
}

void CameraWork::forgetImages() {
  for (Camera& camera : cameras_) camera.shot.step = kNever;
  posed_ = kNever;
}

void CameraWork::forgetPast() {
  forgetImages();
  for (Camera& camera : cameras_) {
    camera.nextAt = 0;
    forgetAhead(camera);
  }
}

void CameraWork::forgetAhead(Camera& camera) {
  if (!camera.ahead) return;
  camera.ahead->giveUp();
  camera.ahead.reset();
  // A thread may still use it.
  camera.aheadOptics.reset();
}

bool CameraWork::mayAskAt(std::size_t camera, std::uint64_t step) const {
  const Camera& one = cameras_[camera];
  const auto period =
      static_cast<std::uint64_t>(simulation_.cameras()[camera].period / simcore::Simulation::kStep);
  return one.askedAt != kNever && one.askedAt < step && step - one.askedAt <= period + kStepsBetweenAsks;
}

std::optional<std::uint64_t> CameraWork::nextAsk(std::size_t camera, const IsDue& isDue) {
  Camera& one = cameras_[camera];
  if (!mayAskAt(camera, simulation_.steps() + 1)) return std::nullopt;
  if (one.nextAt <= simulation_.steps()) {
    // Images are requested at every second step.
    std::uint64_t next = one.askedAt + kStepsBetweenAsks;
    while (next <= simulation_.steps() || (mayAskAt(camera, next) && !isDue(camera, next)))
      next += kStepsBetweenAsks;
    one.nextAt = next;
  }
  return mayAskAt(camera, one.nextAt) ? std::optional(one.nextAt) : std::nullopt;
}

void CameraWork::renderAhead(const Orders& orders, const IsDue& isDue) {
  if (lanes_.empty() || !pool_ || pool_->threads() < 2) return;
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    Camera& one = cameras_[i];
    if (one.ahead || one.askedAt == kNever || one.askedAt > simulation_.steps()) continue;
    const auto at = nextAsk(i, isDue);
    auto coming = at ? simulation_.comingImage(i, *at) : std::nullopt;
    if (!coming) continue;
    const simcore::CameraSensor& sensor = simulation_.cameras()[i];
    if (!one.aheadOptics) one.aheadOptics = std::make_shared<simcore::CameraOptics>();
    one.ahead = std::make_shared<Ahead>();
    one.ahead->studio = studio_;
    one.ahead->optics = one.aheadOptics;
    one.ahead->mount = {sensor.body, sensor.cameraInBody};
    one.ahead->shutter = sensor.shutter;
    one.ahead->order = orders(i);
    one.ahead->order.noise.frame = coming->step;
    one.ahead->hasClasses = one.asksClasses;
    one.ahead->coming = *std::move(coming);
    pool_->later([ahead = one.ahead] { ahead->make(); });
  }
}

bool CameraWork::finishAhead(Shot& shot) {
  Camera& one = cameras_[shot.camera];
  const std::shared_ptr<Ahead> ahead = one.ahead;
  if (!ahead || ahead->order != shot.order || (shot.hasClasses && !ahead->hasClasses)) {
    forgetAhead(one);
    return false;
  }
  ahead->finish();
  one.ahead.reset();
  std::swap(shot.image, ahead->image);
  std::swap(shot.classes, ahead->classes);
  ++begunAhead_;
  return true;
}

bool CameraWork::isExpected(std::size_t camera, const IsDue& isDue) const {
  const Camera& one = cameras_[camera];
  const std::uint64_t now = simulation_.steps();
  return one.shot.step != now && mayAskAt(camera, now) && isDue(camera, now);
}

const robotlink::Image& CameraWork::image(std::size_t camera, const Orders& orders, const IsDue& isDue) {
  Camera& one = cameras_[camera];
  if (one.shot.step != simulation_.steps()) makeTogether(camera, orders, isDue);
  one.shot.step = kNever;
  one.askedAt = simulation_.steps();
  one.asksClasses = false;
  last_ = &one.shot;
  return one.shot.image;
}

void CameraWork::makeTogether(std::size_t camera, const Orders& orders, const IsDue& isDue) {
  std::vector<Shot*> shots{&cameras_[camera].shot};
  for (std::size_t i = 0; lanes_.size() > 1 && i < cameras_.size(); ++i) {
    if (i != camera && isExpected(i, isDue)) shots.push_back(&cameras_[i].shot);
  }
  for (Shot* shot : shots) {
    shot->order = orders(shot->camera);
    shot->hasClasses = cameras_[shot->camera].asksClasses;
  }
  pose();
  const std::size_t lanes = std::min(lanes_.size(), shots.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&](std::size_t lane) {
    for (std::size_t i = next++; i < shots.size(); i = next++) {
      if (!finishAhead(*shots[i])) draw(*shots[i], lanes_[lane]);
    }
  };
  if (lanes > 1) {
    pool_->run(lanes, work);
  } else {
    work(0);
  }
  for (Shot* shot : shots) shot->step = simulation_.steps();
}

const robotlink::Image& CameraWork::preview(std::size_t camera, const Orders& orders) {
  preview_.camera = camera;
  preview_.order = orders(camera);
  preview_.hasClasses = false;
  pose();
  draw(preview_, lanes_[0]);
  last_ = &preview_;
  return preview_.image;
}

const robotlink::Image& CameraWork::trueClasses() {
  if (last_ == nullptr) return preview_.classes;
  if (last_ != &preview_) cameras_[last_->camera].asksClasses = true;
  if (!last_->hasClasses) {
    last_->hasClasses = true;
    pose();
    draw(*last_, lanes_[0]);
  }
  return last_->classes;
}

void CameraWork::pose() {
  // Made here, since threads may not.
  const auto poses = simulation_.bodyPoses();
  const std::uint64_t version = simulation_.posesVersion();
  if (std::exchange(posed_, version) == version) return;
  lanes_[0].renderer->setPoses(poses);
  lanes_[0].renderer->place();
}

bool CameraWork::seesOtherInstants(std::size_t camera, const Order& order) const {
  const simcore::CameraSensor& sensor = simulation_.cameras()[camera];
  return order.model.distortion.any() || sensor.shutter.any() ||
         simulation_.sensorErrors(sensor.info.path)->hasTiming();
}

simcore::CameraRenderer& CameraWork::expose(Shot& shot, Lane& lane) {
  const simcore::CameraSensor& sensor = simulation_.cameras()[shot.camera];
  const Order& order = shot.order;
  if (!seesOtherInstants(shot.camera, order)) {
    lane.renderer->setLighting(order.lighting);
    lane.renderer->render(
        simulation_.bodyPoses()[static_cast<std::size_t>(sensor.body)] * sensor.cameraInBody, order.model,
        robotlink::PixelFormat::kYuyv, order.noise, shot.image);
    return *lane.renderer;
  }
  if (!lane.other)
    lane.other = std::make_unique<simcore::CameraRenderer>(simulation_.renderScene(),
                                                           simcore::CameraRenderer::Options{shadows_});
  lane.other->setLighting(order.lighting);
  const auto posesAt = [&](double age, std::vector<simcore::Pose3>& poses) {
    simulation_.cameraPoses(shot.camera, age, poses);
  };
  cameras_[shot.camera].optics.render(*lane.other, posesAt, {sensor.body, sensor.cameraInBody}, order.model,
                                      sensor.shutter, robotlink::PixelFormat::kYuyv, order.noise, shot.image);
  return *lane.other;
}

void CameraWork::draw(Shot& shot, Lane& lane) {
  simcore::CameraRenderer& renderer = expose(shot, lane);
  if (shot.hasClasses) {
    label(studio_->classes, renderer, cameras_[shot.camera].optics, shot.image.width, shot.classes);
  }
  if (shot.order.blackout) blacken(shot.image);
}

}  // namespace app

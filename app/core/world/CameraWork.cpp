// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/world/CameraWork.h"

#include <algorithm>
#include <atomic>

#include "simcore/world/SensorErrors.h"

namespace app {
namespace {

/// The longest time between two steps at which cameras are asked, in steps of the physics.
constexpr std::uint64_t kStepsBetweenAsks = 2;

/// Makes an image in YCbCr 4:2:2 black.
void blacken(robotlink::Image& image) {
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = i % 2 == 0 ? 0 : 128;
}

}  // namespace

CameraWork::CameraWork(const simcore::Simulation& simulation, std::shared_ptr<robotlink::ThreadPool> pool,
                       bool shadows)
    : simulation_(simulation),
      pool_(std::move(pool)),
      shadows_(shadows),
      classes_(*simulation.renderScene()) {
  restart();
}

void CameraWork::restart() {
  classes_ = TrueClasses(*simulation_.renderScene());
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

bool CameraWork::isExpected(std::size_t camera, const IsDue& isDue) const {
  const Camera& one = cameras_[camera];
  const std::uint64_t now = simulation_.steps();
  if (one.askedAt == kNever || one.shot.step == now || !isDue(camera)) return false;
  const auto period =
      static_cast<std::uint64_t>(simulation_.cameras()[camera].period / simcore::Simulation::kStep);
  return one.askedAt < now && now - one.askedAt <= period + kStepsBetweenAsks;
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
    for (std::size_t i = next++; i < shots.size(); i = next++) draw(*shots[i], lanes_[lane]);
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
  if (posed_ == simulation_.steps()) return;
  posed_ = simulation_.steps();
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
    renderer.label(classes_.ofInstances(), TrueClasses::kBackground, shot.classes);
    cameras_[shot.camera].optics.distortLabels(TrueClasses::kBackground, shot.image.width, shot.classes);
    TrueClasses::ignoreMixedPairs(shot.classes);
  }
  if (shot.order.blackout) blacken(shot.image);
}

}  // namespace app

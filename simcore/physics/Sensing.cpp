// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/Sensing.h"

#include <algorithm>

#include "robotlink/base/Random.h"

namespace simcore {

Sensing::Sensing(const Physics& physics, const std::vector<SensorSource>& sources, const Vector3& gravity)
    : physics_(physics),
      sources_(sources),
      gravity_(gravity),
      velocities_(sources.size(), Vector3::Zero()),
      specificForces_(sources.size(), -gravity) {}

void Sensing::afterStep() {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const SensorSource& source = sources_[i];
    if (source.kind != SensorSource::Kind::kAccelerometer) continue;
    const Vector3 point = physics_.linkInWorld(source.body) * source.poseInLink.translation();
    const Vector3 velocity = physics_.velocityAt(source.body, point);
    specificForces_[i] = (velocity - velocities_[i]) / kStepSeconds - gravity_;
    velocities_[i] = velocity;
  }
}

void Sensing::forgetVelocitiesOf(int model) {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (sources_[i].model != model) continue;
    velocities_[i] = Vector3::Zero();
    specificForces_[i] = -gravity_;
  }
}

void Sensing::readExactly(std::size_t index, std::vector<double>& values) const {
  const SensorSource& source = sources_[index];
  switch (source.kind) {
    case SensorSource::Kind::kAngle:
      values[0] = physics_.angle(source.hinge);
      break;
    case SensorSource::Kind::kContact:
      values[0] = physics_.touched(source.body, source.collision) ? 1 : 0;
      break;
    case SensorSource::Kind::kDistance: {
      const Pose3 pose = physics_.linkInWorld(source.body) * source.poseInLink;
      values[0] = physics_.castRay(pose.translation(), pose.linear().col(0), source.maximum, source.model);
      break;
    }
    case SensorSource::Kind::kGyroscope: {
      const Pose3 pose = physics_.linkInWorld(source.body) * source.poseInLink;
      Eigen::Map<Vector3>(values.data()) =
          pose.linear().transpose() * physics_.angularVelocityOf(source.body);
      break;
    }
    case SensorSource::Kind::kAccelerometer: {
      const Pose3 pose = physics_.linkInWorld(source.body) * source.poseInLink;
      Eigen::Map<Vector3>(values.data()) = pose.linear().transpose() * specificForces_[index];
      break;
    }
  }
}

void Sensing::read(const Noise& noise, std::vector<Sensor>& sensors) const {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const SensorSource& source = sources_[i];
    std::vector<double>& values = sensors[i].values;
    readExactly(i, values);
    robotlink::Random random(noise.seed, robotlink::hashBits(0, i, noise.step));
    for (double& value : values) {
      if (noise.on && source.noise > 0) value += source.noise * random.normal();
      if (source.maximum > source.minimum) value = std::clamp(value, source.minimum, source.maximum);
    }
  }
}

}  // namespace simcore

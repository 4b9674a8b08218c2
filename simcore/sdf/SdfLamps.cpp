// SPDX-License-Identifier: GPL-3.0-or-later
// readLamps() of SdfConversion.h: point lights, directional ones and spots.
#include <algorithm>
#include <cmath>

#include "simcore/sdf/SdfDevices.h"

namespace simcore {
namespace {

/// A channel of a color; 0 where it is no number.
float shareOf(float channel) {
  return channel > 0 ? std::min(channel, 1.F) : 0.F;
}

Lamp readLamp(const sdf::Light& light, const Pose3& pose, const SdfContext& context) {
  const sdf::ElementPtr element = light.Element();
  Lamp lamp;
  lamp.position = pose.translation().cast<float>();
  lamp.intensity =
      static_cast<float>(context.within(light.Intensity(), 0, 100, "a light's intensity", element));
  const auto color = light.Diffuse();
  lamp.color = {shareOf(color.R()), shareOf(color.G()), shareOf(color.B())};
  if (light.Type() == sdf::LightType::POINT) {
    lamp.attenuation = static_cast<float>(
        context.within(light.QuadraticAttenuationFactor(), 0, 1000, "a light's attenuation", element));
    return lamp;
  }
  Vector3 direction = pose.linear() * toEigen(light.Direction());
  if (!direction.allFinite() || direction.norm() <= 0) direction = -Vector3::UnitZ();
  lamp.direction = direction.normalized().cast<float>();
  if (light.Type() == sdf::LightType::DIRECTIONAL) {
    lamp.kind = Lamp::Kind::kDirectional;
    return lamp;
  }
  lamp.kind = Lamp::Kind::kSpot;
  lamp.attenuation = static_cast<float>(
      context.within(light.QuadraticAttenuationFactor(), 0, 1000, "a light's attenuation", element));
  const double outer =
      context.within(light.SpotOuterAngle().Radian(), 0, robotlink::kPi, "a spot's outer_angle", element);
  const double inner = std::clamp(light.SpotInnerAngle().Radian(), 0.0, outer);
  lamp.outerAngle = static_cast<float>(outer);
  lamp.innerAngle = static_cast<float>(inner);
  return lamp;
}

}  // namespace

void readLamps(const sdf::World& world, WorldDescription& result, const SdfContext& context) {
  for (std::uint64_t i = 0; i < world.LightCount(); ++i) {
    const sdf::Light& light = *world.LightByIndex(i);
    if (light.Element()->HasElement("light_on") && !light.Element()->Get<bool>("light_on")) continue;
    const Pose3 pose = resolvedPose(light.SemanticPose(), "", light.Element(), context);
    result.lamps.push_back(readLamp(light, pose, context));
    result.lampPoses.push_back(pose);
    result.lampNames.push_back(light.Name());
    result.lampDirections.push_back(toEigen(light.Direction()));
    result.lampRadiation.push_back(readIntensities(light.Element(), context));
  }
}

}  // namespace simcore

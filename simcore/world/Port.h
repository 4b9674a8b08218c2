// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "simcore/world/PortInfo.h"

namespace simcore {

/// Something that can be read or commanded in a simulation, whatever it is. A plain value.
struct Port {
  enum class Kind : std::uint8_t {
    kSensor,
    kCamera,
    kRange,
    kImage,
    kServo,
    kDrive,
    kGuide,
    kDoor,
    /// True pose of a model: x, y, z, and a quaternion x, y, z, w, in the world.
    kTruePose,
    /// True velocity of a model's origin and its turning rate, in the world.
    kTrueVelocity,
    /// A view that a controller adds: numbers, an image or a drawing.
    kOutput,
  };
  PortInfo info;
  Kind kind = Kind::kSensor;
  /// Among those of its kind; of truth the index of the model.
  std::size_t index = 0;

  bool isActuator() const {
    return kind == Kind::kServo || kind == Kind::kDrive || kind == Kind::kGuide || kind == Kind::kDoor;
  }
  bool isTruth() const { return kind == Kind::kTruePose || kind == Kind::kTrueVelocity; }
};

/// A model as a camera sees it.
struct TruePercept {
  std::string model;
  /// The pose of the model's frame in that of the camera.
  robotlink::Pose3 modelInCamera = robotlink::Pose3::Identity();
  /// The smallest rectangle around its visible pixels: the first column and row, and the last ones.
  int left = 0, top = 0, right = 0, bottom = 0;
  /// How many pixels show it.
  int pixels = 0;
};

}  // namespace simcore

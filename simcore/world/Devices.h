// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "simcore/world/CameraModel.h"
#include "simcore/world/PortInfo.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

/// A sensor that yields numbers. Its reading is that of the last step, noise included.
struct Sensor {
  PortInfo info;
  std::vector<double> values;
};

struct CameraSensor {
  PortInfo info;
  CameraModel model;
  int body = 0;  ///< index in RenderScene::bodies
  Pose3 cameraInBody = Pose3::Identity();
  robotlink::Duration period{};  ///< between images
  double noise =
      0;  ///< standard deviation of each channel, grey values; to be applied only if options ask for noise
};

/// A joint's servo: it turns towards a requested angle with limited speed and torque.
struct Servo {
  PortInfo info;                    ///< "red1/legFL1/request"
  double minimum = 0, maximum = 0;  ///< rad
  double maximumSpeed = 0;          ///< rad/s
  double maximumTorque = 0;         ///< N m
};

/// Driven wheels on a robot's two sides ("skid steering"). A side's wheels are told one speed.
struct WheelDrive {
  PortInfo info;            ///< "p3at1/drive": the speeds of the left and the right rims, {2}, m/s
  std::string controller;   ///< the protocol of its microcontroller ("arcos"); empty: it has none
  double wheelRadius = 0;   ///< m
  double track = 0;         ///< m; while nothing is in the way, the robot turns by (right - left) / track
  double maximumSpeed = 0;  ///< m/s, of the rims
};

/// What a drive's encoders and motors tell. Travel is that of the rims, mean of a side's wheels, since the
/// simulation began; it never wraps, and goes on while wheels slip.
struct WheelState {
  double leftTravel = 0, rightTravel = 0;  ///< m
  double leftSpeed = 0, rightSpeed = 0;    ///< m/s
  /// The motors do what they can, yet the wheels hardly turn, for a tenth of a second at least.
  bool leftBlocked = false, rightBlocked = false;
};

}  // namespace simcore

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "logplayer/bhuman/Payloads.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer::bhuman {

// Conversion of payloads to messages, with the path below the robot; process and frame number are not set.

/// Severity of a text.
enum class Level : std::uint8_t { kInfo, kWarning };

/// `frame`: the frame of reference of the camera.
robotlink::StreamMessage cameraImage(const robotlink::Image& image, const std::string& frame,
                                     robotlink::Instant time);
/// The pose of the camera in the robot, with fields of view and image size.
robotlink::StreamMessage cameraPose(const CameraPlace& place, const CameraOptics& optics,
                                    robotlink::Instant time);
robotlink::StreamMessage jointStates(const JointAngles& joints, robotlink::Instant time);
/// Only the acceleration: paws and distance sensor of the package belong to another robot.
robotlink::StreamMessage bodySensors(const SensorReadings& sensors, robotlink::Instant time);
/// All sensor values by their names.
robotlink::StreamMessage bodyReadings(const std::vector<Reading>& readings, robotlink::Instant time);
/// Only the odometry.
robotlink::StreamMessage motionStatus(const robotlink::Pose2& odometry, robotlink::Instant time);
/// Invalid UTF-8 is replaced by "?". `name`: the source of the text.
robotlink::StreamMessage text(const std::string& text, Level level, const std::string& name,
                              robotlink::Instant time);
/// Ends a frame; `number` counts from 1.
robotlink::StreamMessage frameInfo(const std::string& process, std::uint64_t number, robotlink::Instant time);

}  // namespace logplayer::bhuman
